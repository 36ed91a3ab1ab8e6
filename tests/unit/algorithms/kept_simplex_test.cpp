// SPDX-License-Identifier: MIT
//
// What proves that up to three pairs of vertices hold the closest points: it proves those with which GJK
// ends, those of V-Clip's features near contact, and of vertices chosen at random nothing that is not so.
#include "edgewise/algorithms/kept_simplex.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/layouts/aos.hpp"
#include "edgewise/layouts/points_soa.hpp"
#include "edgewise/scene/motion.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/truth/exact_distance.hpp"

namespace edgewise {
namespace {

using Table = points_soa<f64>;

Polyhedron random_hull(scene::Rng& rng) {
    std::vector<Vec3d> points;
    for (int i = 0; i < 12; ++i) points.push_back(rng.on_sphere());
    return convex_hull(points).or_throw();
}

/// Two bodies near each other, and their exact distance.
struct Case {
    Polyhedron body_a, body_b;
    Table a, b;
    Transform<double> pose;
    double exact;

    explicit Case(scene::Rng& rng)
        : body_a(random_hull(rng)),
          body_b(random_hull(rng)),
          a(body_a, Parts::support),
          b(body_b, Parts::support),
          pose{rng.rotation(), (2 + std::pow(10.0, rng.uniform(-3, 0.5))) * rng.on_sphere()},
          exact(truth::exact_distance(body_a.vertices, Pose{}, body_b.vertices,
                                      {pose.rotation, pose.translation})
                    .or_throw()
                    .distance) {}

    [[nodiscard]] double error(const KeptSimplex<Table, Table, double>& kept) const {
        return std::abs(std::sqrt(squared_norm(kept.closest().point)) - exact) / kept.size();
    }
};

TEST(KeptSimplex, ProvesWhereGjkEnds) {
    scene::Rng rng(11);
    std::array<int, 4> asked{}, proven{};
    int beyond = 0;
    double worst = 0;
    for (int i = 0; i < 3000; ++i) {
        const Case at(rng);
        SimplexPair<Table, Table> pair(at.a, at.b);
        if (Gjk::query(at.a, at.b, at.pose, pair).status != Status::separated) continue;
        KeptSimplex<Table, Table, double> kept(at.a, at.b, at.pose);
        for (std::uint32_t k = 0; k < pair.count(); ++k) kept.push(pair.corner(k).a, pair.corner(k).b);
        ++asked[pair.count()];
        beyond += kept.is_beyond(0.99 * at.exact, kept.direction());
        if (!kept.rests_on_all() || !kept.is_proven({})) continue;
        ++proven[pair.count()];
        worst = std::max(worst, at.error(kept));
    }
    std::printf("proven %d of %d points, %d of %d edges, %d of %d triangles, worst error %.2g\n", proven[1],
                asked[1], proven[2], asked[2], proven[3], asked[3], worst);
    for (const std::size_t count : {1U, 2U, 3U}) {
        EXPECT_GT(asked[count], 100);
        EXPECT_GE(proven[count], 0.99 * asked[count]);
    }
    EXPECT_GE(beyond, 0.99 * (asked[1] + asked[2] + asked[3])) << "along the direction of where GJK ends";
    EXPECT_LE(worst, 8 * Tolerance<double>::eps);
}

/// Vertices of the answer at a pose turned by up to a radian, or random ones.
std::vector<VertexPair<Table, Table>> corners_nearby(const Case& at, scene::Rng& rng) {
    std::vector<VertexPair<Table, Table>> corners;
    if (rng.below(2) == 0) {
        const double angle = std::pow(10.0, rng.uniform(-3, 0));
        const Mat3d turn = rotation_matrix(scene::rotation_about(rng.on_sphere(), angle));
        SimplexPair<Table, Table> pair(at.a, at.b);
        static_cast<void>(
            Gjk::query(at.a, at.b, {Mat3d(at.pose.rotation * turn), at.pose.translation}, pair));
        for (std::uint32_t k = 0; k < std::min(pair.count(), 3U); ++k) corners.push_back(pair.corner(k));
    }
    while (corners.empty() || (corners.size() < 3 && rng.below(4) == 0))
        corners.push_back({static_cast<Table::Vertex>(rng.below(at.a.vertex_count())),
                           static_cast<Table::Vertex>(rng.below(at.b.vertex_count()))});
    return corners;
}

TEST(KeptSimplex, ProvesNothingThatIsNotSo) {
    scene::Rng rng(12);
    int on_fewer = 0, unproven = 0, proven = 0;
    double worst = 0;
    for (int i = 0; i < 2000; ++i) {
        const Case at(rng);
        for (int turn = 0; turn < 10; ++turn) {
            KeptSimplex<Table, Table, double> kept(at.a, at.b, at.pose);
            for (const auto& [a, b] : corners_nearby(at, rng)) kept.push(a, b);
            if (!kept.rests_on_all()) {
                ++on_fewer;
            } else if (!kept.is_proven({})) {
                ++unproven;
            } else {
                ++proven;
                worst = std::max(worst, at.error(kept));
            }
        }
    }
    std::printf("%d rest on fewer points, %d not proven, %d proven, worst error %.2g\n", on_fewer, unproven,
                proven, worst);
    EXPECT_GT(on_fewer, 1000);
    EXPECT_GT(unproven, 1000);
    EXPECT_GT(proven, 1000);
    EXPECT_LE(worst, 8 * Tolerance<double>::eps);
}

/// Cutoffs about the exact distance, along the direction of any points, good or bad.
TEST(KeptSimplex, IsBeyondNothingThatIsNearer) {
    scene::Rng rng(13);
    int nearer = 0, undecided = 0, beyond = 0;
    for (int i = 0; i < 2000; ++i) {
        const Case at(rng);
        for (int turn = 0; turn < 10; ++turn) {
            KeptSimplex<Table, Table, double> kept(at.a, at.b, at.pose);
            for (const auto& [a, b] : corners_nearby(at, rng)) kept.push(a, b);
            const double cutoff = at.exact * rng.uniform(0, 1.2);
            const Vec3d direction = kept.direction();
            if (!kept.is_beyond(cutoff, direction)) {
                ++(cutoff > at.exact ? nearer : undecided);
                continue;
            }
            ++beyond;
            EXPECT_LT(cutoff, at.exact);
            const Distance answer = kept.answer_beyond(direction);
            EXPECT_GE(answer.distance, at.exact * (1 - 1e-12)) << "an upper bound";
            const double reach = dot(answer.normal, direction) / norm(direction);
            EXPECT_NEAR(reach, -1, 1e-15) << "the normal is outward for A";
        }
    }
    std::printf("%d nearer than the cutoff, %d not decided, %d beyond it\n", nearer, undecided, beyond);
    for (const int visited : {nearer, undecided, beyond}) EXPECT_GT(visited, 1000);
}

struct CountsGjk : NoObserver {
    int asked = 0;
    void ask_gjk() { ++asked; }
};

/// A tip 1e-5 over a face of 16 sides: V-Clip in single proves the answer by three of the face's corners,
/// whichever part of the face is below.
TEST(KeptSimplex, HoldsATipOverAnyPartOfAFace) {
    std::vector<Vec3d> rim;
    for (int i = 0; i < 32; ++i)
        rim.emplace_back(std::cos(i / 2 * M_PI / 8), std::sin(i / 2 * M_PI / 8), i % 2 ? 0.5 : -0.5);
    const Polyhedron prism = convex_hull(rim).or_throw();
    const Polyhedron tip =
        convex_hull(std::vector<Vec3d>{{0, 0, 0}, {1, 0, 1}, {-1, 1, 1}, {-1, -1, 1}}).or_throw();
    using Single = aos<f32>;
    const Single a(prism, Parts::features), b(tip, Parts::features);
    FeaturePair<Single, Single> pair(a, b);
    CountsGjk observer;
    for (int i = 0; i < 200; ++i) {
        const double angle = 0.1 * i, radius = 0.004 * i;
        const Transform<double> pose{Mat3d::Identity(),
                                     {radius * std::cos(angle), radius * std::sin(angle), 0.5 + 1e-5}};
        const Distance answer = VClip::query(a, b, pose, pair, {}, observer);
        EXPECT_EQ(answer.refinements, 1) << i;
        EXPECT_NEAR(answer.distance, 1e-5, 1e-7);
    }
    EXPECT_EQ(observer.asked, 0);
}

/// A pair in single that is turned a little in each frame, for ten frames each: close, half a unit apart,
/// close, and overlapping.
struct FramesOfAPair {
    int close = 0, far = 0, overlapping = 0,
        repeated = 0;  ///< repeated: of the close, answered at corners again
    double worst = 0;

    using Single = aos<f32>;
    FeaturePair<Single, Single> pair;

    FramesOfAPair(const Single& a, const Single& b) : pair(a, b) {}

    void ask(const Polyhedron& body_a, const Polyhedron& body_b, const Single& a, const Single& b,
             const Transform<double>& pose) {
        const Distance answer = VClip::query(a, b, pose, pair);
        const auto exact =
            truth::exact_distance(body_a.vertices, Pose{}, body_b.vertices, {pose.rotation, pose.translation})
                .or_throw();
        worst = std::max(worst, std::abs(answer.distance - exact.distance) / 4);
        ++(exact.distance == 0 ? overlapping : exact.distance < 1e-4 ? close : far);
        if (exact.distance == 0 || exact.distance > 1e-4) {
            EXPECT_NE(pair.first_try(), FirstTry::corners) << exact.distance;
            return;
        }
        const bool at_corners = pair.first_try() == FirstTry::corners;
        const Distance again = VClip::query(a, b, pose, pair);
        EXPECT_NEAR(again.distance, answer.distance, 1e-6);
        repeated += at_corners && again.steps == 1 && again.refinements == 1;
    }
};

TEST(CloseBodies, AreAskedAtTheirCornersFirst) {
    scene::Rng rng(14);
    int close = 0, far = 0, overlapping = 0, repeated = 0;
    double worst = 0;
    for (int i = 0; i < 200; ++i) {
        const Polyhedron body_a = round_to_single(random_hull(rng)).or_throw(),
                         body_b = round_to_single(random_hull(rng)).or_throw();
        const aos<f32> a(body_a, Parts::features), b(body_b, Parts::features);
        const Table points_a(body_a, Parts::support), points_b(body_b, Parts::support);
        FramesOfAPair frames(a, b);
        Transform<double> pose{rng.rotation(), 3 * rng.on_sphere()};
        for (const double gap : {1e-5, 0.5, 2e-5, -0.05}) {
            for (int frame = 0; frame < 10; ++frame) {
                pose.rotation *= rotation_matrix(scene::rotation_about(rng.on_sphere(), 1e-3));
                pose.translation *= 2 / norm(pose.translation) + 1;
                SimplexPair<Table, Table> points(points_a, points_b);
                const Distance answer = Gjk::query(points_a, points_b, pose, points);
                pose.translation -= (answer.distance - gap) * answer.normal;
                pose = cast<double>(cast<float>(pose));
                frames.ask(body_a, body_b, a, b, pose);
            }
        }
        close += frames.close, far += frames.far, overlapping += frames.overlapping;
        repeated += frames.repeated;
        worst = std::max(worst, frames.worst);
    }
    std::printf("%d close (%d answered at corners again), %d far, %d overlapping, worst error %.3g\n", close,
                repeated, far, overlapping, worst);
    for (const int visited : {close, far, overlapping}) EXPECT_GT(visited, 1000);
    EXPECT_GE(repeated, 0.98 * close);
    EXPECT_LE(worst, 2.5e-7);
}

/// Three points of a difference: those of a body and the origin.
struct Triangle {
    int count = 3;
    SmallArray<Vec3d, 3> corners;
    [[nodiscard]] Vec3d on_a(int i) const { return corners[i]; }
    [[nodiscard]] static Vec3d on_b(int /*i*/) { return Vec3d::Zero(); }
};

/// The plane of a sliver may pass nearer to the origin than the sliver.
TEST(WitnessPoints, AreNotAsNearAsAFootOutsideTheTriangle) {
    Triangle sliver;
    sliver.corners = {Vec3d(1, 0, 1), Vec3d(2, 0, 1), Vec3d(1.5, 1e-8, 1 + 1e-9)};
    ClosestOfSimplex<double> closest;
    closest.weight = {1, 0, 0, 0};
    closest.point = sliver.corners[0];
    const WitnessPoints<double> witnesses(sliver, closest);
    EXPECT_TRUE(witnesses.are_as_near_as(norm(closest.point), 2.0));
    const Vec3d normal =
        cross(Vec3d(sliver.corners[1] - sliver.corners[0]), Vec3d(sliver.corners[2] - sliver.corners[0]));
    closest.point = (dot(normal, sliver.corners[0]) / squared_norm(normal)) * normal;
    EXPECT_FALSE(witnesses.are_as_near_as(norm(closest.point), 2.0));
}

}  // namespace
}  // namespace edgewise
