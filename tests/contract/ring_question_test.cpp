// SPDX-License-Identifier: MIT
//
// Compares the ring questions of a table with a search over its single planes: they must find the same edge.
// In a tie the first edge of the ring wins, also in a layout's vectorised code.
#include "edgewise/table/ring_questions.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "stored_bodies.hpp"
#include "tables_under_test.hpp"

namespace edgewise {
namespace {

template <class Type>
class RingQuestions : public ::testing::Test {};
TYPED_TEST_SUITE(RingQuestions, TableTypes);

/// The lowest value below zero, its edge, and whether other edges have the same value.
template <class T>
struct Lowest {
    using Edge = typename T::Edge;
    using Compute = ComputeOf<T>;

    std::optional<Edge> edge;
    Compute value = 0, largest = 0;
    bool tie = false;

    void see(Edge e, Compute candidate) {
        largest = std::max(largest, std::abs(candidate));
        tie = candidate < value ? false : tie || (edge && candidate == value);
        if (!(candidate < value)) return;
        value = candidate;
        edge = e;
    }
};

struct Seen {
    int answers = 0, none = 0, ties = 0;

    template <class T>
    void count(const Lowest<T>& lowest) {
        ++answers;
        none += !lowest.edge;
        ties += lowest.tie;
    }
};

template <class T>
void ask_about_point(const T& table, typename T::Vertex v, typename T::Face f, const Vec3<ComputeOf<T>>& p,
                     Seen& seen) {
    Lowest<T> around, about;
    for (const auto [edge, flipped] : table.ring_of_vertex(v)) {
        around.see(edge, table.vertex_edge_plane(edge, flipped ? End::head : End::tail).distance(p));
    }
    for (const auto [edge, flipped] : table.ring_of_face(f)) {
        about.see(edge, table.edge_face_plane(edge, flipped ? Side::right : Side::left).distance(p));
    }
    EXPECT_EQ(most_violated_vertex_plane(table, v, p), around.edge);
    EXPECT_EQ(most_violated_face_side(table, f, p), about.edge);
    seen.count(around);
    seen.count(about);
}

/// Compares a squared slope with the slope along a normal of at most 4, within the rounding of its square.
template <class Scalar>
void expect_slope(Scalar squared, Scalar slope) {
    const Scalar noise = 512 * Tolerance<Scalar>::eps;
    EXPECT_NEAR(squared, squared_slope(slope), noise);
}

template <class T>
void ask_about_slope(const T& table, typename T::Vertex v, const Vec3<ComputeOf<T>>& normal, Seen& seen) {
    Lowest<T> falling;
    for (const auto [edge, flipped] : table.ring_of_vertex(v)) {
        const ComputeOf<T> along = slope_along(table, edge, normal);
        expect_slope(along, dot(Vec3<ComputeOf<T>>(table.direction(edge)), normal));
        falling.see(edge, flipped ? -along : along);
    }
    const auto found = steepest_descent(table, v, normal);
    EXPECT_EQ(found.edge, falling.edge);
    EXPECT_EQ(found.slope, falling.value);
    if (found.edge) {
        EXPECT_EQ(found.steepest, falling.largest);
    }
    seen.count(falling);
}

template <class Range>
auto any_of(const Range& range, std::size_t count, scene::Rng& rng) {
    auto at = range.begin();
    for (std::uint64_t n = rng.below(count); n > 0; --n) ++at;
    return *at;
}

TYPED_TEST(RingQuestions, AgreeWithSinglePlanesAndBreakTiesAlike) {
    scene::Rng rng(1);
    for_each_feature_table<typename TypeParam::Table>(
        [&]<class T>(const T& table, const Polyhedron& body, const std::string& name) {
            Seen seen;
            for (int i = 0; i < 3000; ++i) {
                const auto v = any_of(table.all_vertices(), body.vertex_count(), rng);
                const auto f = any_of(table.all_faces(), body.face_count(), rng);
                const Vec3d lattice = rng.in_cube(2.5).array().round();
                const Vec3d above = body.vertices[table.index_of(v)] * rng.uniform(0, 1.5);
                const Vec3d p = i % 2 ? lattice : Vec3d(above + rng.uniform() * rng.in_cube(0.5));
                ask_about_point(table, v, f, cast<ComputeOf<T>>(p), seen);
                const Vec3d normal = i % 2 ? lattice : rng.on_sphere();
                ask_about_slope(table, v, cast<ComputeOf<T>>(normal), seen);
            }
            std::printf("%s %s: %d answers, %d none, %d ties\n", TypeParam::name, name.c_str(), seen.answers,
                        seen.none, seen.ties);
            EXPECT_GT(seen.none, 100);
            EXPECT_GT(seen.answers - seen.none, 1000);
            EXPECT_GT(seen.ties, name == "cube8" ? 1000 : -1);
        });
}

}  // namespace
}  // namespace edgewise
