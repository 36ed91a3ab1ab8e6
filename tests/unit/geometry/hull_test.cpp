// SPDX-License-Identifier: MIT
//
// Hulls against two oracles that know nothing of Qhull: every input point lies below every plane, and in any
// direction the farthest input point is no farther than the farthest vertex.
#include "edgewise/geometry/hull.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <set>

#include "geometry_bodies.hpp"

namespace edgewise {
namespace {

using testing::all_violations;
using testing::box_points;
using testing::Dice;
using testing::grid_points;
using testing::placed;
using testing::Points;
using testing::random_rotation;
using testing::sphere_points;

double largest_coordinate_of(const Points& points) {
    double largest = 0;
    for (const Vec3d& p : points) largest = std::max(largest, max_abs(p));
    return largest;
}

/// How far any input point sticks out of the body, by its planes.
double worst_above(const Polyhedron& body, const Points& points) {
    double worst = 0;
    for (const Plane<double>& plane : body.face_planes) {
        for (const Vec3d& p : points) worst = std::max(worst, plane.distance(p));
    }
    return worst;
}

template <class Range>
double support(const Range& points, const Vec3d& direction) {
    double best = -std::numeric_limits<double>::infinity();
    for (const Vec3d& p : points) best = std::max(best, dot(p, direction));
    return best;
}

/// How far the input reaches beyond the body's vertices in the worst of some directions.
double worst_support_gap(const Polyhedron& body, const Points& points, Dice& dice) {
    double worst = 0;
    for (int k = 0; k < 50; ++k) {
        const Vec3d direction = dice.direction();
        worst = std::max(worst, support(points, direction) - support(body.vertices, direction));
    }
    return worst;
}

/// Sound, Euler holds, vertices are the input's own bits, both oracles agree. Returns the worst relative
/// error.
double expect_hull(const Points& points, Dice& dice) {
    const Result<Polyhedron> hull = convex_hull(points);
    EXPECT_TRUE(hull) << hull.error;
    if (!hull) return 0;
    EXPECT_EQ(all_violations(*hull), "");
    EXPECT_EQ(hull->vertex_count() + hull->face_count(), hull->edge_count() + 2);
    EXPECT_TRUE(std::is_sorted(hull->input_index.begin(), hull->input_index.end()));
    for (std::size_t v = 0; v < hull->vertex_count(); ++v) {
        EXPECT_EQ(hull->vertices[v], points[hull->input_index[v]]);
    }
    const double unit = extent(points);
    const double rounding = 1e-15 * largest_coordinate_of(points);
    const double above = worst_above(*hull, points);
    const double gap = worst_support_gap(*hull, points, dice);
    EXPECT_LE(above, 1e-12 * unit + rounding);
    EXPECT_LE(gap, 1e-12 * unit + rounding);
    return std::max(above, gap) / (unit + 1e-3 * largest_coordinate_of(points));
}

TEST(Hull, CubeHasSixQuads) {
    const Result<Polyhedron> cube = convex_hull(box_points(Vec3d(1, 1, 1)));
    ASSERT_TRUE(cube) << cube.error;
    EXPECT_EQ(cube->vertex_count(), 8u);
    EXPECT_EQ(cube->edge_count(), 12u);
    ASSERT_EQ(cube->face_count(), 6u);
    for (Index f = 0; f < 6; ++f) {
        EXPECT_EQ(cube->ring_of_face(f).size(), 4u);
        EXPECT_EQ(norm(cube->face_planes[f].normal), 1);
        EXPECT_EQ(cube->face_planes[f].offset, -1);
    }
    EXPECT_EQ(volume(*cube), 8);
    EXPECT_EQ(all_violations(*cube), "");
}

TEST(Hull, PointsInFacesAndOnEdgesVanish) {
    for (const int steps : {2, 3, 4, 7}) {
        const Result<Polyhedron> cube = convex_hull(grid_points(steps, Vec3d(1, 2, 3)));
        ASSERT_TRUE(cube) << cube.error;
        EXPECT_EQ(cube->vertex_count(), 8u) << steps;
        EXPECT_EQ(cube->edge_count(), 12u) << steps;
        EXPECT_EQ(cube->face_count(), 6u) << steps;
        EXPECT_NEAR(volume(*cube), 48, 1e-12);
    }
}

TEST(Hull, LowestIndexNamesADuplicate) {
    Points points = box_points(Vec3d(1, 1, 1));
    const Points again = points;
    points.insert(points.begin() + 3, Vec3d(0, 0, 0));
    points.insert(points.end(), again.rbegin(), again.rend());
    const Result<Polyhedron> cube = convex_hull(points);
    ASSERT_TRUE(cube) << cube.error;
    EXPECT_EQ(cube->input_index, (std::vector<Index>{0, 1, 2, 4, 5, 6, 7, 8}));
    const Points zeros = {Vec3d(-0.0, 0, 0), Vec3d(0, -0.0, 0), Vec3d(1, 0, 0), Vec3d(0, 1, 0),
                          Vec3d(0, 0, 1)};
    const Result<Polyhedron> tetra = convex_hull(zeros);
    ASSERT_TRUE(tetra) << tetra.error;
    EXPECT_EQ(tetra->input_index, (std::vector<Index>{0, 2, 3, 4}));
}

using NamedFaces = std::set<std::vector<Index>>;

/// The faces by the original names of their vertices, free of any order.
NamedFaces named_faces(const Polyhedron& body, const std::vector<Index>& names) {
    NamedFaces result;
    for (Index f = 0; f < body.face_count(); ++f) {
        std::vector<Index> face;
        for (const HalfEdge h : body.ring_of_face(f)) face.push_back(names[body.input_index[body.tail(h)]]);
        std::sort(face.begin(), face.end());
        result.insert(face);
    }
    return result;
}

TEST(Hull, DoesNotDependOnTheOrderOfTheInput) {
    Dice dice(11);
    int merged = 0;
    for (int trial = 0; trial < 50; ++trial) {
        const Points base =
            trial % 2 == 0 ? grid_points(3, Vec3d(1, 1, 1)) : sphere_points(dice, 60, Vec3d(1, 1, 1));
        const Points points = placed(base, random_rotation(dice), dice.vector(), 1);
        std::vector<Index> order(points.size());
        for (Index i = 0; i < order.size(); ++i) order[i] = i;
        const Result<Polyhedron> first = convex_hull(points);
        ASSERT_TRUE(first) << first.error;
        for (std::size_t i = order.size() - 1; i > 0; --i) std::swap(order[i], order[dice.below(i + 1)]);
        Points shuffled;
        for (const Index i : order) shuffled.push_back(points[i]);
        const Result<Polyhedron> second = convex_hull(shuffled);
        ASSERT_TRUE(second) << second.error;
        std::vector<Index> same(points.size());
        for (Index i = 0; i < same.size(); ++i) same[i] = i;
        EXPECT_EQ(named_faces(*first, same), named_faces(*second, order));
        merged += first->face_count() == 6;
    }
    EXPECT_GT(merged, 10);
}

/// Families of awkward but solid bodies, each at random sizes, places and orientations.
Points awkward_body(Dice& dice, int family, const Vec3d& half) {
    if (family == 0) return box_points(half);
    if (family == 1) return grid_points(4, half);
    if (family == 2) return sphere_points(dice, 80, half);
    if (family == 3) {  // near duplicates
        Points points = sphere_points(dice, 50, half);
        for (int k = 0; k < 50; ++k) {
            const double step = std::pow(10, dice.between(-17, -9));
            points.push_back(points[k] + dice.vector() * step);
        }
        return points;
    }
    if (family == 4) {  // box faces with rounding noise
        Points points = grid_points(4, half);
        const double noise = std::pow(10, dice.between(-17, -9));
        for (Vec3d& p : points) p += dice.vector() * noise;
        return points;
    }
    Points points{Vec3d(0, 0, -half.z())};  // a cap so shallow that its facets merge in part
    const double depth = std::pow(10, dice.between(-16, -6));
    for (int k = 0; k < 150; ++k) {
        const Vec3d p = dice.vector();
        const double top = 1 - depth * (p.x() * p.x() + p.y() * p.y());
        points.push_back(Vec3d(p.x(), p.y(), top).cwiseProduct(half));
    }
    return points;
}

TEST(Hull, AwkwardSolidBodiesAreSound) {
    Dice dice(12);
    double worst = 0;
    int far_off = 0, tiny = 0, huge = 0, built = 0;
    for (const double aspect : {1.0, 1e-3, 1e-6}) {
        for (const Vec3d& half : {Vec3d(1, 1, aspect), Vec3d(1, aspect, aspect)}) {
            for (int family = 0; family < 6; ++family) {
                for (int trial = 0; trial < 8; ++trial) {
                    const double scale = std::pow(10, dice.between(-6, 6));
                    const double away = trial % 2 == 0 ? 0 : std::pow(10, dice.between(-3, 6)) * aspect;
                    const Points body = awkward_body(dice, family, half);
                    const Vec3d shift = dice.vector() * away;
                    SCOPED_TRACE(::testing::Message() << "family " << family << " aspect " << aspect);
                    worst =
                        std::max(worst, expect_hull(placed(body, random_rotation(dice), shift, scale), dice));
                    far_off += away > 1e2;
                    tiny += scale < 1e-4;
                    huge += scale > 1e4;
                    ++built;
                }
            }
        }
    }
    std::printf("%d bodies, worst point outside: %.2g of the extent\n", built, worst);
    EXPECT_GT(far_off, 10);
    EXPECT_GT(tiny, 10);
    EXPECT_GT(huge, 10);
}

TEST(Hull, RotatedBoxesKeepTheirSixFaces) {
    Dice dice(13);
    for (const double aspect : {1.0, 1e-2, 1e-4, 1e-6}) {
        for (int trial = 0; trial < 20; ++trial) {
            const Points flat = grid_points(2, Vec3d(1, 0.5, aspect));
            const Result<Polyhedron> box = convex_hull(placed(flat, random_rotation(dice), Vec3d::Zero(), 1));
            ASSERT_TRUE(box) << box.error;
            EXPECT_EQ(box->vertex_count(), 8u) << aspect;
            EXPECT_EQ(box->face_count(), 6u) << aspect;
        }
    }
}

TEST(Hull, NeedlesAreBuiltInTheirOwnAxes) {
    Dice dice(14);
    double worst = 0;
    for (int trial = 0; trial < 30; ++trial) {
        const Points needle = box_points(Vec3d(1, 1e-10, 1e-10));
        worst = std::max(worst, expect_hull(placed(needle, random_rotation(dice), Vec3d::Zero(), 1), dice));
    }
    std::printf("worst point outside a needle: %.2g\n", worst);
}

TEST(Hull, PowersOfTwoAndExactShiftsChangeNothing) {
    Dice dice(15);
    Points points;
    for (int k = 0; k < 200; ++k) {  // 20-bit coordinates, so that the shift below is exact
        points.push_back((dice.vector() * 0x1p20).array().round().matrix());
    }
    const Result<Polyhedron> base = convex_hull(points);
    ASSERT_TRUE(base) << base.error;
    for (const double scale : {0x1p-190, 0x1p-40, 0x1p50, 0x1p160}) {
        const Result<Polyhedron> other =
            convex_hull(placed(points, Mat3d::Identity(), Vec3d(0x1p24, 0, -0x1p30), scale));
        ASSERT_TRUE(other) << other.error;
        EXPECT_EQ(other->input_index, base->input_index);
        EXPECT_EQ(other->face_ring, base->face_ring);
        EXPECT_EQ(other->vertex_ring, base->vertex_ring);
        EXPECT_EQ(all_violations(*other), "");
    }
}

struct RefusedCase {
    const char* name;
    Points points;
    const char* expected;
};

TEST(Hull, RefusesWhatHasNoSolidHull) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    Points not_a_number = box_points(Vec3d(1, 1, 1));
    not_a_number[5].y() = nan;
    Points infinite = box_points(Vec3d(1, 1, 1));
    infinite[2].z() = -inf;
    Points too_large = box_points(Vec3d(1, 1, 1));
    too_large[7].x() = 2e60;
    Dice dice(16);
    const Points tilted = placed(grid_points(3, Vec3d(1, 1, 0)), random_rotation(dice), Vec3d(1, 2, 3), 1);
    const Points line = placed(grid_points(4, Vec3d(1, 0, 0)), random_rotation(dice), Vec3d(1, 2, 3), 1);
    const std::vector<RefusedCase> cases = {
        {"none", {}, "no vertices"},
        {"point", {Vec3d(1, 2, 3)}, "single point"},
        {"duplicates", Points(5, Vec3d(1, 2, 3)), "all 5 vertices are the same point"},
        {"segment", {Vec3d(0, 0, 0), Vec3d(1, 0, 0)}, "2 distinct vertices"},
        {"triangle", {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 1, 0)}, "3 distinct vertices"},
        {"line", line, "on one line"},
        {"plane", tilted, "in one plane"},
        {"square", box_points(Vec3d(1, 1, 0)), "in one plane"},
        {"paper", box_points(Vec3d(1, 1, 1e-14)), "in one plane"},
        {"not a number", not_a_number, "vertex 5: y = nan"},
        {"infinite", infinite, "vertex 2: z = -inf"},
        {"too large", too_large, "vertex 7: x = 2e+60 is beyond 1e+60"},
        {"too small", box_points(Vec3d(1e-61, 1e-61, 1e-61)), "below 1e-60"},
    };
    for (const RefusedCase& refused : cases) {
        const Result<Polyhedron> hull = convex_hull(refused.points);
        EXPECT_FALSE(hull) << refused.name;
        EXPECT_NE(hull.error.find(refused.expected), std::string::npos) << refused.name << ": " << hull.error;
        EXPECT_EQ(hull.error.find('\n'), std::string::npos) << refused.name;
    }
}

TEST(Hull, WorksUpToTheEdgesOfItsRange) {
    for (const double size : {1e-59, 1e-30, 1e30, 0.9e60}) {
        const Result<Polyhedron> cube = convex_hull(box_points(Vec3d(size, size, size)));
        ASSERT_TRUE(cube) << size << ": " << cube.error;
        EXPECT_EQ(cube->face_count(), 6u);
        EXPECT_EQ(all_violations(*cube), "");
    }
}

}  // namespace
}  // namespace edgewise
