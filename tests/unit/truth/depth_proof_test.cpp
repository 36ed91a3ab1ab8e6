// SPDX-License-Identifier: MIT
//
// The proof of a penetration depth must refuse what is wrong: another face, a foreign point, a dent.
#include "edgewise/truth/exact_proof.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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

}  // namespace
}  // namespace edgewise::truth
