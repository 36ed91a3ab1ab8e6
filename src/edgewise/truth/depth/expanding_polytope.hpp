// SPDX-License-Identifier: MIT
//
// A convex polytope on points of A - B that holds the origin, grown a point at a time, exactly: the polytope
// of EPA (van den Bergen, "Proximity queries and penetration depth computation on 3D game objects", 2001).
//
// Faces are triangles; a flat facet may be several of them. A new point removes the faces it lies strictly
// above and leaves the coplanar ones: what is removed is then one disc, and no new face is ever degenerate.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "edgewise/truth/integer_vector.hpp"
#include "edgewise/truth/minimum_norm.hpp"

namespace edgewise::truth {

struct DifferencePoint {
    VertexPair pair;
    IntegerVec point;
};

class ExpandingPolytope {
  public:
    /// The plane is normal.x = height: normal outward, not unit, height not negative. The distance from the
    /// origin is sqrt(squared_height / squared_normal).
    struct Face {
        std::array<std::uint32_t, 3> corner;  ///< counter-clockwise from outside
        IntegerVec normal;
        mpz_class height, squared_height, squared_normal;
        bool removed = false;
    };

    /// Four points that span space, the origin in their hull.
    explicit ExpandingPolytope(std::vector<DifferencePoint> tetrahedron);

    /// Returns the face with its plane nearest to the origin; ties go to the oldest face.
    [[nodiscard]] std::uint32_t nearest();

    /// Takes in a point strictly above that face.
    void expand(std::uint32_t face, DifferencePoint point);

    [[nodiscard]] const std::vector<DifferencePoint>& points() const { return points_; }
    [[nodiscard]] const std::vector<Face>& faces() const { return faces_; }  ///< the removed ones as well

  private:
    struct Edge {
        std::uint32_t tail, head;
    };

    [[nodiscard]] bool comes_later(std::uint32_t f, std::uint32_t g) const;
    void add_face(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    [[nodiscard]] std::vector<Edge> remove_below(std::uint32_t face, const IntegerVec& point);

    std::vector<DifferencePoint> points_;
    std::vector<Face> faces_;
    std::vector<std::uint32_t> heap_;                        ///< nearest first; removed ones are passed over
    std::unordered_map<std::uint64_t, std::uint32_t> left_;  ///< the face on the left of a directed edge
};

/// Returns true if the plane of f is strictly nearer to the origin than that of g.
[[nodiscard]] bool is_nearer(const ExpandingPolytope::Face& f, const ExpandingPolytope::Face& g);

}  // namespace edgewise::truth
