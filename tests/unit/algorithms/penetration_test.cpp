// SPDX-License-Identifier: MIT
//
// Penetration depth compared with brute force over every direction that a face of A - B can have: random
// pairs at all depths and in all precisions, boxes with a known depth, touching and concentric pairs,
// needles, and starts that are no help.
#include "edgewise/algorithms/penetration.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/layouts/aos.hpp"
#include "penetration_errors.hpp"

namespace edgewise {
namespace {

using testing::ask;
using testing::box;
using testing::BruteDepth;
using testing::Errors;
using testing::PointPair;
using testing::random_overlap;
using testing::RoundedTable;
using testing::shifted;

Polyhedron random_hull(scene::Rng& rng) {
    std::vector<Vec3d> points;
    const Vec3d stretch(1, rng.uniform(0.1, 1), rng.uniform(0.01, 1));
    for (int i = 0; i < 14; ++i) points.push_back(rng.in_ball().cwiseProduct(stretch));
    return *convex_hull(points);
}

Polyhedron shape(const std::string& name, scene::Rng& rng) {
    return name == "hull" ? random_hull(rng) : *scene::make_shape(name);
}

class RandomPairs : public ::testing::TestWithParam<std::pair<const char*, const char*>> {};

template <class Table>
void compare_with_brute_force(const std::string& name_a, const std::string& name_b, double limit) {
    scene::Rng rng(7);
    Errors errors;
    int shallow = 0, deep = 0, face_of[3] = {};
    for (int i = 0; i < 150; ++i) {
        const Polyhedron a = *round_to_single(shape(name_a, rng));
        const Polyhedron b = *round_to_single(shape(name_b, rng));
        const Transform<double> pose = random_overlap(a, b, rng);
        const BruteDepth truth = testing::brute_depth(a, b, pose);
        shallow += truth.depth < 1e-3;
        deep += truth.depth > 0.3;
        ++face_of[static_cast<int>(truth.face)];
        errors.take(a, b, pose, ask<Table>(a, b, pose), truth.depth);
    }
    const std::string what = name_a + " and " + name_b + ", " + std::string(Table::PrecisionType::name);
    errors.print(what.c_str());
    errors.expect_below(limit);
    EXPECT_GT(shallow, 0);
    EXPECT_GT(deep, 0);
    for (const int count : face_of) EXPECT_GT(count, 0);
}

TEST_P(RandomPairs, InDouble) {
    compare_with_brute_force<RoundedTable<f64>>(GetParam().first, GetParam().second, 1e-15);
}
TEST_P(RandomPairs, InSingle) {
    compare_with_brute_force<RoundedTable<f32>>(GetParam().first, GetParam().second, 1e-6);
}
TEST_P(RandomPairs, Mixed) {
    compare_with_brute_force<RoundedTable<mixed>>(GetParam().first, GetParam().second, 1e-15);
}

INSTANTIATE_TEST_SUITE_P(Shapes, RandomPairs,
                         ::testing::Values(std::pair{"tetra4", "tetra4"}, std::pair{"cube8", "cube8"},
                                           std::pair{"cube8", "sphere38"}, std::pair{"sphere18", "tetra4"},
                                           std::pair{"hull", "hull"}),
                         [](const auto& pair) {
                             return std::string(pair.param.first) + "_" + pair.param.second;
                         });

/// Every coordinate dyadic and every face on an axis: no rounding anywhere.
TEST(Penetration, AlignedBoxesAreExact) {
    const Polyhedron a = box(1, 0.5, 2), b = box(0.75, 1.25, 0.5);
    const Vec3d reach(1.75, 1.75, 2.5);
    scene::Rng rng(3);
    for (int i = 0; i < 400; ++i) {
        Vec3d at;
        for (int k = 0; k < 3; ++k) at[k] = std::ldexp(std::round(std::ldexp(rng.uniform(-1.7, 1.7), 8)), -8);
        if (i % 4 == 0) at[static_cast<int>(rng.below(3))] = 0;  // tied directions
        const Penetration answer = ask(a, b, shifted(at.x(), at.y(), at.z()));
        const Vec3d room = reach - at.cwiseAbs();
        EXPECT_EQ(answer.depth, room.minCoeff());
        EXPECT_LT(norm(Vec3d(answer.point_a - answer.point_b - answer.depth * answer.normal)), 1e-15);
        int axis = 0;
        EXPECT_EQ(answer.normal.cwiseAbs().maxCoeff(&axis), 1);
        EXPECT_EQ(room[axis], answer.depth);
        EXPECT_GE(answer.normal[axis] * at[axis], 0);
    }
}

/// Oblique faces, edges and tips that touch exactly: the normals round, the verdict must not.
TEST(Penetration, TouchingObliquelyIsDepthZero) {
    const Vec3d axes(1, 0.75, 0.3125);
    std::vector<Vec3d> tips;
    for (int i = 0; i < 6; ++i) {
        const Vec3d axis = Mat3d::Identity().col(i % 3);
        tips.push_back((i < 3 ? 1 : -1) * axis.cwiseProduct(axes));
    }
    const Polyhedron octahedron = *convex_hull(tips);
    scene::Rng rng(29);
    for (int i = 0; i < 200; ++i) {
        // A point of the octahedron of twice the size, on a face, an edge or a tip.
        const double x = std::round(rng.uniform(0, 64)) / 32;
        const double y = i % 4 == 0 ? 2 - x : std::round(rng.uniform(0, 32 * (2 - x))) / 32;
        const Vec3d at = axes.cwiseProduct(Vec3d(x, -y, x + y - 2));
        const Penetration answer = ask(octahedron, octahedron, shifted(at.x(), at.y(), at.z()));
        EXPECT_EQ(answer.depth, 0);
        EXPECT_GT(dot(answer.normal, at), 0) << "leads away";
        EXPECT_LT(norm(Vec3d(answer.point_a - answer.point_b)), 1e-15);
    }
}

/// Points, segments and polygons of one plane that cross there or share a corner: any step across the plane
/// separates them, none within it does. A closest point some rounding steps from the origin has a direction
/// within the plane.
TEST(Penetration, OfFlatBodiesHasANormalThatSeparates) {
    scene::Rng rng(31);
    int touching = 0;
    for (int i = 0; i < 4000; ++i) {
        std::vector<Vec3d> points[2];
        const Vec3d line = rng.in_cube(1).cwiseProduct(Vec3d(1, 1, 0));
        for (auto& of : points)
            for (std::uint64_t n = 1 + rng.below(4); n > 0; --n)
                of.push_back(i % 3 == 0 ? Vec3d(line * rng.uniform(-1, 1))
                                        : Vec3d(rng.in_cube(1).cwiseProduct(Vec3d(1, 1, 0))));
        if (i % 2 == 0) points[1].front() = points[0].front();
        const Mat3d turn = i % 4 < 2 ? Mat3d(Mat3d::Identity()) : rng.rotation();
        for (Vec3d& point : points[0]) point = multiply(turn, point);
        const Polyhedron a = *hull_of_any(points[0]), b = *hull_of_any(points[1]);
        const Transform<double> pose{turn, Vec3d::Zero()};
        const aos<f64> table_a(a, Parts::support), table_b(b, Parts::support);
        SimplexPair<aos<f64>, aos<f64>> pair(table_a, table_b);
        if (Gjk::query(table_a, table_b, pose, pair).status == Status::separated) continue;
        ++touching;
        PenetrationSpace space;
        const Penetration answer = penetration(table_a, table_b, pose, pair, space);
        double beyond = -1e300;
        for (const Vec3d& v : a.vertices)
            for (const Vec3d& w : b.vertices)
                beyond = std::max(beyond, dot(answer.normal, Vec3d(v - pose.point(w))));
        EXPECT_NEAR(norm(answer.normal), 1, 1e-14);
        EXPECT_LE(beyond, answer.depth + 1e-14) << i;
    }
    std::printf("%d of 4000 pairs touch\n", touching);
    EXPECT_GT(touching, 1000);
}

TEST(Penetration, ConcentricAndIdenticalBodies) {
    Errors errors;
    scene::Rng rng(11);
    for (const char* name : {"tetra4", "cube8", "sphere18", "sphere38"}) {
        const Polyhedron body = *scene::make_shape(name);
        const Polyhedron inner = scene::scaled(body, 0.25);
        for (int i = 0; i < 8; ++i) {
            Transform<double> pose = shifted(0, 0, 0);
            if (i % 2 == 1) pose.rotation = rng.rotation();
            if (i % 4 >= 2) pose.translation = std::ldexp(1.0, -8 * i) * rng.on_sphere();
            const Polyhedron& b = i < 4 ? body : inner;
            errors.take(body, b, pose, ask(body, b, pose), testing::brute_depth(body, b, pose).depth);
        }
    }
    errors.print("concentric");
    errors.expect_below(1e-15);
}

/// Beams from 1 : 1 to 1 : 10^-9, crossed at any angle or nearly parallel.
TEST(Penetration, Needles) {
    Errors errors;
    scene::Rng rng(5);
    int overlapping = 0;
    for (int i = 0; i < 200; ++i) {
        const double thickness = std::ldexp(1.0, -static_cast<int>(rng.below(30)));
        const Polyhedron a = box(1, thickness, thickness), b = box(1, thickness, 0.5 * thickness);
        Transform<double> pose{rng.rotation(), thickness * rng.in_ball()};
        if (i % 2 == 0) {
            const double turn = std::ldexp(rng.uniform(), -static_cast<int>(rng.below(40)));
            const double length = std::sqrt(1 + turn * turn);
            pose.rotation << 1 / length, -turn / length, 0, turn / length, 1 / length, 0, 0, 0, 1;
        }
        const double truth = testing::brute_depth(a, b, pose).depth;
        if (truth <= 0) continue;
        ++overlapping;
        errors.take(a, b, pose, ask(a, b, pose), truth);
    }
    errors.print("needles");
    errors.expect_below(1e-15);
    EXPECT_GT(overlapping, 100);
}

/// Any vertices may be the start: none, equal ones, a line, a plane, far from the origin.
TEST(Penetration, EveryStartGivesTheSameDepth) {
    scene::Rng rng(13);
    const Polyhedron a = *scene::make_shape("sphere18"), b = *scene::make_shape("cube8");
    double worst = 0;
    for (int i = 0; i < 300; ++i) {
        const Transform<double> pose = i % 3 == 0 ? shifted(0.25, 0.5, 0) : random_overlap(a, b, rng);
        const double truth = testing::brute_depth(a, b, pose).depth;
        if (truth <= 0) continue;
        SimplexPair<Canonical, Canonical> start;
        const std::uint64_t count = rng.below(5);
        const std::uint64_t choice = 1 + rng.below(4);  // few vertices: duplicates and lines
        for (std::uint64_t k = 0; k < count; ++k)
            start.push({static_cast<Index>(rng.below(choice)), static_cast<Index>(rng.below(choice))});
        const Penetration answer = ask<Canonical>(a, b, pose, start);
        EXPECT_TRUE(answer.converged);
        worst = std::max(worst, std::abs(answer.depth - truth));
    }
    std::printf("penetration, any start: worst depth %.2g\n", worst);
    EXPECT_LT(worst, 1e-14);
}

/// A work space too small for the query: the answer is deeper than need be, but still takes the bodies apart.
TEST(Penetration, AFullWorkSpaceLeavesAnUpperBound) {
    scene::Rng rng(17);
    const Polyhedron body = *scene::make_shape("sphere38");
    PenetrationSpace space;
    space.face_limit = 60;
    double loosest = 0;
    for (int i = 0; i < 50; ++i) {
        const Transform<double> pose{rng.rotation(), 0.05 * rng.on_sphere()};
        const Penetration answer = penetration(Canonical(body), Canonical(body), pose, {}, space);
        const PointPair points{body.vertices, testing::moved(body, pose)};
        const double truth = testing::brute_depth(body, body, pose).depth;
        EXPECT_FALSE(answer.converged);
        EXPECT_NEAR(points.reach(answer.normal), answer.depth, 1e-14);
        EXPECT_NEAR(dot(answer.normal, Vec3d(answer.point_a - answer.point_b)), answer.depth, 1e-14);
        EXPECT_GE(answer.depth, truth - 1e-14);
        loosest = std::max(loosest, answer.depth / truth);
    }
    std::printf("penetration, full work space: at most %.4f times the depth\n", loosest);
    EXPECT_GT(loosest, 1);
    EXPECT_LT(loosest, 1.2);
}

/// Up to where the offset swallows the bodies and nothing but a point is left of the difference.
TEST(Penetration, ApartIsDepthZero) {
    const Polyhedron body = *scene::make_shape("sphere18");
    scene::Rng rng(23);
    for (const double gap : {3.0, 1e3, 1e14, 1e16, 1e20, 1e90}) {
        for (int i = 0; i < 20; ++i) {
            const Transform<double> pose{rng.rotation(), gap * rng.on_sphere()};
            const Penetration answer = ask(body, body, pose);
            const PointPair points{body.vertices, testing::moved(body, pose)};
            EXPECT_EQ(answer.depth, 0);
            EXPECT_NEAR(norm(answer.normal), 1, 1e-15);
            EXPECT_LT(points.reach(answer.normal), 0) << gap;
        }
    }
}

/// Sizes from 2^-300 to 2^300: the same bits except for the exponent, so nothing is absolute.
TEST(Penetration, ScalesExactly) {
    scene::Rng rng(19);
    const Polyhedron a = *scene::make_shape("sphere18"), b = *scene::make_shape("tetra4");
    for (int i = 0; i < 40; ++i) {
        const Transform<double> pose{rng.rotation(), 0.5 * rng.on_sphere()};
        const Penetration answer = ask<Canonical>(a, b, pose, {});
        for (const int power : {-300, -60, -1, 60, 300}) {
            const double factor = std::ldexp(1.0, power);
            const Transform<double> other{pose.rotation, factor * pose.translation};
            const Penetration same =
                ask<Canonical>(scene::scaled(a, factor), scene::scaled(b, factor), other, {});
            EXPECT_EQ(same.depth, factor * answer.depth);
            EXPECT_EQ(same.normal, answer.normal);
            EXPECT_EQ(same.point_a, factor * answer.point_a);
            EXPECT_EQ(same.steps, answer.steps);
        }
    }
}

}  // namespace
}  // namespace edgewise
