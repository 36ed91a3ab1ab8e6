// SPDX-License-Identifier: MIT
//
// Rounded bodies against exact distances of their cores: points, segments, boxes and hulls, with radii from
// none to larger than the core; and the depth, by which moving B out makes the bodies touch.
#include "edgewise/algorithms/rounded.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/layouts/lean.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/truth/exact_distance.hpp"

namespace edgewise {
namespace {

using Core = lean<f64>;

std::vector<Polyhedron> cores() {
    std::vector<Polyhedron> cores;
    cores.push_back(hull_of_any(std::vector<Vec3d>{{0.25, 0, 0}}).or_throw());
    cores.push_back(hull_of_any(std::vector<Vec3d>{{0, 0, -0.5}, {0, 0, 0.75}}).or_throw());
    for (const char* shape : {"box8", "sphere38"}) cores.push_back(scene::make_shape(shape).or_throw());
    return cores;
}

struct RoundedPair {
    const Polyhedron &a, &b;
    Rounded<Core> rounded_a, rounded_b;
    Transform<double> a_from_b;

    [[nodiscard]] double radii() const { return rounded_a.radius + rounded_b.radius; }
    /// Exact distance of the cores, with B moved.
    [[nodiscard]] double exact(const Vec3d& moved = Vec3d::Zero()) const {
        const Pose pose_b{a_from_b.rotation, a_from_b.translation + moved};
        return truth::exact_distance(a.vertices, {}, b.vertices, pose_b).or_throw().distance;
    }
};

/// What was met, and the worst error of a distance or a depth.
struct MetRoundedPairs {
    int separated = 0, deep = 0, cores_meet = 0;
    double worst = 0;
};

template <class Algorithm>
void check_answer(const RoundedPair& asked, MetRoundedPairs& seen) {
    typename Algorithm::template Pair<Core, Core> pair(asked.rounded_a.core, asked.rounded_b.core);
    const Distance answer = query_rounded<Algorithm>(asked.rounded_a, asked.rounded_b, asked.a_from_b, pair);
    const double gap = asked.exact() - asked.radii();
    if (std::abs(gap) < 1e-13) return;
    ASSERT_EQ(answer.status == Status::separated, gap > 0) << gap;
    auto cold = typename Algorithm::template Pair<Core, Core>(asked.rounded_a.core, asked.rounded_b.core);
    EXPECT_EQ(query_rounded<Algorithm>(asked.rounded_a, asked.rounded_b, asked.a_from_b, cold, {.cutoff = 0})
                      .status == Status::separated,
              gap > 0);
    if (gap <= 0) return;
    ++seen.separated;
    seen.worst = std::max({seen.worst, std::abs(answer.distance - gap),
                           std::abs(norm(Vec3d(answer.point_b - answer.point_a)) - gap)});
}

void check_depth(const RoundedPair& asked, MetRoundedPairs& seen) {
    SimplexPair<Core, Core> pair(asked.rounded_a.core, asked.rounded_b.core);
    const Distance cores = Gjk::query(asked.rounded_a.core, asked.rounded_b.core, asked.a_from_b, pair);
    if (asked.exact() >= asked.radii()) return;
    PenetrationSpace space;
    const Penetration found =
        rounded_penetration(asked.rounded_a, asked.rounded_b, asked.a_from_b, cores, pair, space);
    ASSERT_TRUE(found.converged);
    ++seen.deep;
    seen.cores_meet += cores.status != Status::separated;
    const auto out = [&](double part) { return asked.exact(part * found.depth * found.normal); };
    seen.worst = std::max({seen.worst, std::abs(out(1) - asked.radii()),
                           std::abs(dot(Vec3d(found.point_a - found.point_b), found.normal) - found.depth)});
    EXPECT_LT(out(0.99), asked.radii()) << "no deeper than that";
}

TEST(Rounded, IsTheCoreAndARadius) {
    const std::vector<Polyhedron> bodies = cores();
    std::vector<Core> tables;
    for (const Polyhedron& body : bodies) tables.emplace_back(body, Parts::features);
    scene::Rng rng(11);
    MetRoundedPairs seen;
    for (int i = 0; i < 4000; ++i) {
        const std::size_t a = rng.below(4), b = rng.below(4);
        constexpr double radii[] = {0, 0.01, 0.25, 1.5};
        const RoundedPair asked{bodies[a],
                                bodies[b],
                                {tables[a], radii[rng.below(4)]},
                                {tables[b], radii[rng.below(4)]},
                                {scene::rotation_matrix(rng.orientation()),
                                 3e-3 * static_cast<double>(rng.below(1000)) * rng.on_sphere()}};
        check_answer<Gjk>(asked, seen);
        check_answer<VClip>(asked, seen);
        check_depth(asked, seen);
    }
    std::printf("%d separated, %d deep, %d of these with cores that meet; worst error %.1e\n", seen.separated,
                seen.deep, seen.cores_meet, seen.worst);
    EXPECT_GT(seen.separated, 1000);
    EXPECT_GT(seen.deep - seen.cores_meet, 300);
    EXPECT_GT(seen.cores_meet, 300);
    EXPECT_LT(seen.worst, 1e-14);
}

}  // namespace
}  // namespace edgewise
