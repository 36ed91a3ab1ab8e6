// SPDX-License-Identifier: MIT
//
// The proof of a penetration depth must refuse what is wrong: another face, a foreign point, a dent.
//
// Exact penetration depth against closed forms: boxes, contacts, flat bodies, bad input.
#include "edgewise/truth/exact_proof.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "exact_bodies.hpp"

namespace edgewise::truth {
namespace {

/// A unit box with a vertex inside it, sunk into the corner of a larger one: A - B is a cube from -2 to 0.5.
class DepthProof : public ::testing::Test {
  protected:
    DepthProof() : bodies_(sunk_, {}, large_, {}), polytope_(tetrahedron()) {}

    std::vector<DifferencePoint> tetrahedron() {
        std::vector<DifferencePoint> points;
        for (const VertexPair pair :
             {VertexPair{0, 7}, VertexPair{7, 4}, VertexPair{7, 2}, VertexPair{7, 1}}) {
            points.push_back({pair, bodies_.difference(pair)});
        }
        return points;
    }

    void grow() {
        for (;;) {
            const std::uint32_t face = polytope_.nearest();
            LowestPoint beyond = bodies_.lowest(-polytope_.faces()[face].normal);
            if (beyond.height == -polytope_.faces()[face].height) return;
            polytope_.expand(face, {beyond.pair, beyond.point});
        }
    }

    void expect_refused(std::uint32_t face) {
        EXPECT_THROW(require_depth(bodies_, polytope_, face), std::logic_error) << face;
    }

    Points sunk_ = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0},
                    {1, 1, 0}, {0, 0, 1}, {1, 0, 1},
                    {0, 1, 1}, {1, 1, 1}, {0.03125, 0.5, 0.4375}};
    Points large_ = box({0.5, 0.5, 0.5}, {2, 2, 2});
    ExactPair bodies_;
    ExpandingPolytope polytope_;
};

TEST_F(DepthProof, accepts_the_nearest_face_only) {
    for (std::uint32_t face = 0; face < 4; ++face) expect_refused(face);
    grow();
    EXPECT_NO_THROW(require_depth(bodies_, polytope_, polytope_.nearest()));
    int refused = 0;
    for (std::uint32_t face = 0; face < polytope_.faces().size(); ++face) {
        if (!ExpandingPolytope::is_nearer(polytope_.faces()[polytope_.nearest()], polytope_.faces()[face]))
            continue;
        expect_refused(face);
        ++refused;
    }
    EXPECT_GE(refused, 3);
}

TEST_F(DepthProof, refuses_a_point_that_is_no_difference) {
    std::vector<DifferencePoint> points = tetrahedron();
    points[0].point = 2 * points[0].point;
    polytope_ = ExpandingPolytope(points);
    grow();
    expect_refused(polytope_.nearest());
}

/// Every face of the whole of A - B bounds it, but one at the far side is not nearest. Dented there by the
/// vertex inside, the polytope has no nearer face, and the nearest plane is right, but it is not convex.
TEST_F(DepthProof, refuses_a_far_face_and_a_dent) {
    for (std::uint32_t face = 0; face < polytope_.faces().size(); ++face) {
        if (polytope_.faces()[face].removed) continue;
        LowestPoint beyond = bodies_.lowest(-polytope_.faces()[face].normal);
        if (beyond.height == -polytope_.faces()[face].height) continue;
        polytope_.expand(face, {beyond.pair, beyond.point});
    }
    const std::uint32_t nearest = polytope_.nearest();
    EXPECT_NO_THROW(require_depth(bodies_, polytope_, nearest));
    const auto& faces = polytope_.faces();
    const auto found = std::find_if(faces.begin(), faces.end(), [](const ExpandingPolytope::Face& f) {
        return !f.removed && sgn(f.normal.x) < 0 && sgn(f.normal.y) == 0 && sgn(f.normal.z) == 0;
    });
    ASSERT_TRUE(found != faces.end());
    const std::uint32_t far = static_cast<std::uint32_t>(found - faces.begin());
    expect_refused(far);
    polytope_.expand(far, {{8, 7}, bodies_.difference({8, 7})});
    ASSERT_EQ(polytope_.nearest(), nearest);
    expect_refused(nearest);
}

ExactDepth ask(const Points& a, const Points& b, const Pose& pose_a = {}, const Pose& pose_b = {}) {
    const Result<ExactDepth> answer = exact_depth(a, pose_a, b, pose_b);
    EXPECT_TRUE(answer) << answer.error;
    return answer ? *answer : ExactDepth{};
}

TEST(ExactDepth, boxes_at_dyadic_offsets) {
    for (const double depth : {0.25, 0x1p-30, 0x1p-52}) {
        const ExactDepth along_x = ask(unit_box, unit_box, {}, moved({1 - depth, 0.5, 0}));
        EXPECT_EQ(along_x.depth, depth);
        EXPECT_EQ(along_x.normal, Vec3d(1, 0, 0));
        const ExactDepth below = ask(unit_box, unit_box, {}, moved({0, 0.5, depth - 1}));
        EXPECT_EQ(below.depth, depth);
        EXPECT_EQ(below.normal, Vec3d(0, 0, -1));
    }
    // R v + t is no double here, and the depth is below the rounding of the vertices.
    EXPECT_EQ(ask(unit_box, Points{{1, 0.5, 0.5}}, {}, moved({-0x1p-105, 0, 0})).depth, 0x1p-105);
    EXPECT_EQ(ask(unit_box, unit_box).depth, 1);
    EXPECT_EQ(ask(unit_box, box({0.25, 0.25, 0.25}, {0.5, 0.5, 0.75})).depth, 0.5);
    EXPECT_EQ(ask(unit_box, Points{{0.5, 0.5, 0.75}}).depth, 0.25);
    // The corner x + y + z <= 1 against a cube with a corner that reaches into it along the slanted face.
    const Points corner = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const ExactDepth slanted = ask(corner, box({0.25, 0.25, 0.25}, {2, 2, 2}));
    EXPECT_EQ(slanted.depth, std::sqrt(0.0625 / 3));
    EXPECT_EQ(slanted.normal, Vec3d::Constant(0.57735026918962576451));
}

TEST(ExactDepth, touching_and_flat_are_zero) {
    const ExactDepth face = ask(unit_box, unit_box, {}, moved({0.25, -1, 0.5}));
    EXPECT_EQ(face.depth, 0);
    EXPECT_EQ(face.normal, Vec3d(0, -1, 0));
    EXPECT_EQ(ask(unit_box, unit_box, {}, moved({1, 1, 1})).depth, 0);
    const Points square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const Points line = {{0.5, 0.5, -1}, {0.5, 0.5, 1}};
    const Points point = {{0.5, 0.5, 0}};
    const ExactDepth coplanar = ask(square, square, {}, moved({0.5, 0.5, 0}));
    EXPECT_EQ(coplanar.depth, 0);
    EXPECT_EQ(coplanar.normal.cwiseAbs(), Vec3d(0, 0, 1));
    for (const Points& flat : {line, point}) {
        const ExactDepth same = ask(flat, flat);
        EXPECT_EQ(same.depth, 0);
        EXPECT_EQ(norm(same.normal), 1);
    }
    EXPECT_EQ(ask(line, line).normal.z(), 0);
    // A segment through a square can leave through its side or be pulled out.
    EXPECT_EQ(ask(square, line).depth, 0.5);
    EXPECT_EQ(ask(square, line, {}, moved({0.25, 0, 0.875})).depth, 0.125);
}

TEST(ExactDepth, says_what_is_wrong) {
    EXPECT_NE(exact_depth(unit_box, {}, unit_box, moved({3, 0, 0})).error.find("2 apart"), std::string::npos);
    EXPECT_FALSE(exact_depth({}, {}, unit_box, {}).error.empty());
    const Points bad = {{0, std::numeric_limits<double>::quiet_NaN(), 0}};
    EXPECT_NE(exact_depth(unit_box, {}, bad, {}).error.find("vertex 0 is not finite"), std::string::npos);
}

}  // namespace
}  // namespace edgewise::truth
