// SPDX-License-Identifier: MIT
#include "edgewise/algorithms/search/single_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "edgewise/algorithms/kept_simplex.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/layouts/points_soa.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise {
namespace {

using SearchedTable = points_soa<f64>;

SingleSearchEnd search(const SearchedTable& a, const SearchedTable& b, const Transform<double>& a_from_b) {
    SingleSearch to;
    write_search(a, b, a_from_b, std::numeric_limits<double>::infinity(), to);
    SingleSearchEnd end;
    run_single_search(to, end);
    return end;
}

bool same_end(const SingleSearchEnd& a, const SingleSearchEnd& b) {
    bool same = a.count == b.count && a.steps == b.steps;
    for (int i = 0; i < a.count; ++i)
        same = same && a.vertex_a(i) == b.vertex_a(i) && a.vertex_b(i) == b.vertex_b(i);
    return same;
}

/// Returns true if what a search found holds the closest points, proven in doubles.
bool is_proven(const SearchedTable& a, const SearchedTable& b, const Transform<double>& a_from_b,
               const SingleSearchEnd& end) {
    KeptSimplex<SearchedTable, SearchedTable, double> kept(a, b, a_from_b);
    for (int i = 0; i < end.count; ++i) kept.push(end.vertex_a(i), end.vertex_b(i));
    return kept.rests_on_all() && kept.is_proven({});
}

std::vector<SearchedTable> small_bodies(double scale) {
    std::vector<SearchedTable> tables;
    for (const char* shape : {"tetra4", "cube8", "box8", "sphere18", "sphere38"}) {
        Polyhedron body = scene::make_shape(shape).or_throw();
        std::vector<Vec3d> points;
        for (const Vec3d& vertex : body.vertices) points.push_back(vertex * scale);
        tables.emplace_back(convex_hull(points).or_throw(), Parts::support);
    }
    return tables;
}

/// Pairs that are clearly separated: nearly all ends are proven, on points, edges and faces; pairs that share
/// a point: the search says so with four vertices. A power of two changes nothing.
TEST(SingleSearch, FindsClosestPoints) {
    const double huge = 0x1p150;
    const std::vector<SearchedTable> tables = small_bodies(1), huge_tables = small_bodies(huge);
    scene::Rng rng(4);
    int ends[5] = {}, proven = 0, separated = 0, different = 0;
    for (int i = 0; i < 20000; ++i) {
        const std::size_t a = rng.below(tables.size()), b = rng.below(tables.size());
        const double distance = i % 4 == 0 ? rng.uniform(0, 0.1) : rng.uniform(2.5, 6);
        const Transform<double> pose{rng.rotation(), rng.on_sphere() * distance};
        const SingleSearchEnd end = search(tables[a], tables[b], pose);
        ++ends[end.count];
        const Transform<double> far{pose.rotation, pose.translation * huge};
        different += !same_end(end, search(huge_tables[a], huge_tables[b], far));
        if (distance < 1) continue;
        ++separated;
        proven += end.count < 4 && is_proven(tables[a], tables[b], pose, end);
    }
    std::printf("ends on 1 to 4 points: %d, %d, %d, %d; proven %d of %d\n", ends[1], ends[2], ends[3],
                ends[4], proven, separated);
    for (int count = 1; count <= 4; ++count) EXPECT_GT(ends[count], 500) << count;
    EXPECT_GT(proven, separated * 0.99);
    EXPECT_EQ(different, 0);
}

/// Whatever the numbers, a search ends on vertices that the bodies have.
TEST(SingleSearch, EndsOnItsBodiesVertices) {
    std::vector<SearchedTable> tables;
    for (const double scale : {1e-55, 1e-20, 1e-5, 1.0, 1e5, 1e20, 1e55})
        for (SearchedTable& table : small_bodies(scale)) tables.push_back(std::move(table));
    for (const std::vector<Vec3d>& points :
         {std::vector<Vec3d>{{1, 2, 3}}, std::vector<Vec3d>{{1, 2, 3}, {1, 2, 4}},
          std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}})
        tables.emplace_back(flat_hull(points).or_throw(), Parts::support);
    scene::Rng rng(5);
    int without_progress = 0;
    for (int i = 0; i < 50000; ++i) {
        const SearchedTable &a = tables[rng.below(tables.size())], &b = tables[rng.below(tables.size())];
        const double exponent = rng.uniform(-60, 60);
        const Vec3d offset =
            i % 10 == 0 ? Vec3d(Vec3d::Zero()) : Vec3d(rng.on_sphere() * std::pow(10, exponent));
        const SingleSearchEnd end =
            search(a, b, {i % 20 == 0 ? Mat3d(Mat3d::Identity()) : rng.rotation(), offset});
        ASSERT_GE(end.count, 1);
        ASSERT_LE(end.count, 4);
        for (int k = 0; k < end.count; ++k) {
            ASSERT_LT(end.vertex_a(k), a.vertex_count());
            ASSERT_LT(end.vertex_b(k), b.vertex_count());
        }
        without_progress += end.steps > 32;
    }
    std::printf("%d of 50000 searches lost their way\n", without_progress);
}

}  // namespace
}  // namespace edgewise
