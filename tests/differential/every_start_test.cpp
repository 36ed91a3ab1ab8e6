// SPDX-License-Identifier: MIT
//
// V-Clip started from every pair of features of two cubes (640 without face-face, or 1300 where the cubes'
// faces are split into triangles): every start must give the same distance. At gaps of -0.1, 0.1 and 1,
// aligned, at 45 degrees, and in generic poses. The authors of V-Clip tested it in this way.
#include <gtest/gtest.h>

#include <cstdio>

#include "edgewise/algorithms/vclip.hpp"
#include "judged.hpp"
#include "stored_bodies.hpp"
#include "tables_under_test.hpp"

namespace edgewise {
namespace {

template <class Type>
class EveryStart : public ::testing::Test {};
TYPED_TEST_SUITE(EveryStart, TableTypes);

/// Corners of a cube with coordinates of 0.5, exact in every precision.
std::vector<Vec3d> corners() {
    std::vector<Vec3d> points;
    for (int i = 0; i < 8; ++i)
        points.emplace_back(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5);
    return points;
}

Polyhedron quad_cube() { return *convex_hull(corners()); }

/// The cube of quad_cube with every face as two triangles.
Polyhedron triangle_cube() {
    std::vector<std::vector<Index>> triangles;
    const Polyhedron quads = quad_cube();
    for (Index f = 0; f < quads.face_count(); ++f) {
        const auto ring = quads.ring_of_face(f);
        const auto corner = [&](std::size_t i) { return quads.tail(ring[i]); };
        triangles.push_back({corner(0), corner(1), corner(2)});
        triangles.push_back({corner(0), corner(2), corner(3)});
    }
    const auto cube = polyhedron_from_faces(quads.vertices, triangles);
    EXPECT_TRUE(cube) << cube.error;
    return *cube;
}

template <class T>
std::vector<Feature<T>> all_features(const T& table) {
    std::vector<Feature<T>> features;
    for (const auto v : table.all_vertices()) {
        features.push_back(Feature<T>::of_vertex(v));
        for (const auto [edge, flipped] : table.ring_of_vertex(v)) {
            if (!flipped) features.push_back(Feature<T>::of_edge(edge));
        }
    }
    for (const auto f : table.all_faces()) features.push_back(Feature<T>::of_face(f));
    return features;
}

struct Turn {
    const char* name;
    Mat3d rotation;
    bool generic = false;  ///< nothing is parallel, so no fallback is needed
};

std::vector<Turn> turns() {
    const double h = std::sqrt(0.5);
    Mat3d about_z, corner;
    about_z << h, -h, 0, h, h, 0, 0, 0, 1;
    corner << h, 0, h, 0.5, h, -0.5, -0.5, h, 0.5;  // 45 degrees about y, then about x: an edge first
    scene::Rng rng(7);
    return {{"aligned", Mat3d::Identity()},
            {"45 degrees", about_z},
            {"45 degrees twice", corner},
            {"generic", rng.rotation(), true},
            {"another", rng.rotation(), true}};
}

/// B next to A along a direction, with this gap by exact arithmetic (negative: the depth of the overlap).
RandomPair placed(const Polyhedron& cube, const Mat3d& rotation, const Vec3d& direction, double gap) {
    RandomPair pair;
    pair.pose_b.rotation = rotation;
    pair.pose_b.translation = 4 * direction;
    const auto exact = truth::exact_distance(cube.vertices, pair.pose_a, cube.vertices, pair.pose_b);
    EXPECT_TRUE(exact) << exact.error;
    pair.pose_b.translation += exact->separation * ((exact->distance - gap) / exact->distance);
    return pair;
}

struct Outcome {
    int starts = 0, wrong = 0, fallbacks = 0, most_steps = 0;
    double error = 0, least = std::numeric_limits<double>::infinity(), most = 0;
};

template <class T>
Outcome from_every_start(const T& table, const Polyhedron& cube, const CheckedPair& checked) {
    Outcome outcome;
    const auto features = all_features(table);
    for (const auto& a : features) {
        for (const auto& b : features) {
            if (a.kind() == FeatureKind::face && b.kind() == FeatureKind::face) continue;
            FeaturePair<T, T> pair(table, table, {a, b});
            const Distance answer = VClip::query(table, table, checked.a_from_b, pair);
            const Judged judged = judge_answer(answer, checked, cube, cube);
            ++outcome.starts;
            outcome.wrong += judged.verdict_wrong;
            outcome.fallbacks += answer.fallbacks;
            outcome.most_steps = std::max(outcome.most_steps, answer.steps);
            outcome.error =
                std::max({outcome.error, judged.distance_error, judged.witness_error, judged.outside});
            outcome.least = std::min(outcome.least, answer.distance);
            outcome.most = std::max(outcome.most, answer.distance);
        }
    }
    return outcome;
}

template <class Type>
void expect_one_answer(const Polyhedron& cube, const std::string& name, int starts) {
    using Table = typename Type::Table;
    const Table table(cube, Parts::features);
    const double allowed = verified_error<Table>;
    const Vec3d directions[] = {{1, 0, 0}, {0, 0, -1}, {0.6, 0.8, 0}, {1 / 3.0, 2 / 3.0, -2 / 3.0}};
    int asked = 0;
    for (const Turn& turn : turns()) {
        int here = 0, steps = 0;
        double error = 0;
        for (const Vec3d& direction : directions) {
            for (const double gap : {-0.1, 0.1, 1.0}) {
                const auto pair = placed(cube, turn.rotation, direction, gap);
                const CheckedPair checked = check_pair(cube, cube, pair, compute_eps<Table>);
                const Outcome outcome = from_every_start(table, cube, checked);
                SCOPED_TRACE(name + ", " + turn.name + ", gap " + std::to_string(gap));
                EXPECT_EQ(outcome.starts, starts);
                EXPECT_EQ(outcome.wrong, 0);
                EXPECT_LE(outcome.error, allowed);
                EXPECT_LE((outcome.most - outcome.least) / checked.band.scale, allowed);
                here += outcome.fallbacks;
                asked += outcome.starts;
                steps = std::max(steps, outcome.most_steps);
                error = std::max(error, outcome.error);
            }
        }
        std::printf("%s %s %s: worst error %.2g, at most %d steps, %d fallbacks\n", Type::name, name.c_str(),
                    turn.name, error, steps, here);
        if (turn.generic) {
            EXPECT_EQ(here, 0) << "fallbacks";
        }
    }
    EXPECT_EQ(asked, 60 * starts);
}

template <class Type>
void expect_one_answer_of_features(const Polyhedron& cube, const std::string& name, int starts) {
    if constexpr (has_features<typename Type::Table>) {
        if (!holds<typename Type::Table>(cube)) GTEST_SKIP() << "this layout does not hold the " << name;
        expect_one_answer<Type>(cube, name, starts);
    } else {
        GTEST_SKIP() << "V-Clip needs features";
    }
}

TYPED_TEST(EveryStart, OfTwoCubesGivesOneDistance) {
    expect_one_answer_of_features<TypeParam>(quad_cube(), "cube", 640);
}

TYPED_TEST(EveryStart, OfTwoCubesWithSplitFacesGivesOneDistance) {
    expect_one_answer_of_features<TypeParam>(triangle_cube(), "split cube", 1300);
}

}  // namespace
}  // namespace edgewise
