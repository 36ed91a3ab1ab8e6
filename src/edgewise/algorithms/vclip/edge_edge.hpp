// SPDX-License-Identifier: MIT
//
// State E-E (TR-97-05, Algorithm 7). Each edge is clipped to the other's region: first by the two vertex-edge
// planes, with a derivative test against the vertices; then, from the range that is left, by the two
// edge-face planes, with a derivative test against the faces.
#pragma once

#include <cassert>
#include <cstdint>
#include <optional>

#include "edgewise/algorithms/vclip/body.hpp"
#include "edgewise/algorithms/vclip/clip.hpp"
#include "edgewise/geometry/tolerance.hpp"

namespace edgewise::vclip {

template <class Mine, class Theirs>
class EdgeClipping {
  public:
    using Scalar = ComputeOf<Mine>;

    EdgeClipping(Body<Mine>& mine, const Body<Theirs>& theirs)
        : mine_(mine),
          theirs_(theirs),
          edge_(mine.feature.edge()),
          segment_(segment_seen_by(mine, theirs.table, theirs.feature.edge())) {}

    /// Moves `mine` off its edge; false if the other edge comes closest within this edge's region.
    [[nodiscard]] bool leave() { return leave_to_vertex() || leave_to_face(); }

  private:
    /// The feature beyond a plane of this edge. Its handle is read only when V-Clip moves to it.
    enum class Neighbour : std::uint8_t { tail, head, left, right };

    [[nodiscard]] bool leave_to_vertex() {
        if (clip_by_end(End::tail) || clip_by_end(End::head)) return true;
        if (clip_.at_low && past_low_vertex()) return move_to(*clip_.at_low);
        if (clip_.at_high && past_high_vertex()) return move_to(*clip_.at_high);
        return false;
    }

    [[nodiscard]] bool clip_by_end(End end) {
        const auto vertex = end == End::tail ? Neighbour::tail : Neighbour::head;
        const auto& plane = mine_.table.vertex_edge_plane(edge_, end);
        end_normal_ = plane.normal;
        return clip_by(plane, vertex) == Clipped::simply_excluded && move_to(vertex);
    }

    template <class Plane>
    [[nodiscard]] Clipped clip_by(const Plane& plane, Neighbour beyond) {
        return clip_.against(-plane.distance(segment_.tail), -plane.distance(segment_.head), beyond);
    }

    [[nodiscard]] bool leave_to_face() {
        for (const Side side : {Side::left, Side::right}) {
            const auto face = side == Side::left ? Neighbour::left : Neighbour::right;
            const auto clipped = clip_by(mine_.table.edge_face_plane(edge_, side), face);
            if (clipped == Clipped::simply_excluded) return move_to(face);
        }
        if (clip_.low > clip_.high) return leave_after_compound_exclusion();
        if (is_face(clip_.at_low) && rises_at(*clip_.at_low, clip_.low)) return move_to(*clip_.at_low);
        if (is_face(clip_.at_high) && falls_at(*clip_.at_high, clip_.high)) return move_to(*clip_.at_high);
        return false;
    }

    /// Called when nothing of the other edge is left between two planes. Two faces: it passes under this
    /// edge, and one of them is nearer. A vertex and a face: the vertex if its derivative decides so.
    [[nodiscard]] bool leave_after_compound_exclusion() {
        assert(clip_.at_low && clip_.at_high);
        const bool low_is_nearer =
            is_face(clip_.at_low)
                ? (is_face(clip_.at_high) ? rises_at(*clip_.at_low, clip_.low) : !past_high_vertex())
                : past_low_vertex();
        return move_to(low_is_nearer ? *clip_.at_low : *clip_.at_high);
    }

    [[nodiscard]] static bool is_face(const std::optional<Neighbour>& n) {
        return n == Neighbour::left || n == Neighbour::right;
    }
    [[nodiscard]] typename Mine::Vertex vertex_of(Neighbour n) const {
        assert(n == Neighbour::tail || n == Neighbour::head);
        return n == Neighbour::tail ? mine_.table.tail(edge_) : mine_.table.head(edge_);
    }
    [[nodiscard]] typename Mine::Face face_of(Neighbour n) const {
        assert(is_face(n));
        return n == Neighbour::left ? mine_.table.left(edge_) : mine_.table.right(edge_);
    }

    /// Derivative tests against a vertex: the distance falls until the edge has passed it.
    [[nodiscard]] bool past_low_vertex() const { return slope_at(*clip_.at_low, clip_.low) > 0; }
    [[nodiscard]] bool past_high_vertex() const { return slope_at(*clip_.at_high, clip_.high) < 0; }
    [[nodiscard]] Scalar slope_at(Neighbour vertex, Scalar lambda) const {
        return slope_where_clipped(Vec3<Scalar>(segment_.head - segment_.tail), end_normal_,
                                   Vec3<Scalar>(segment_.at(lambda) - mine_.table.vertex(vertex_of(vertex))));
    }

    /// Derivative tests against a face: the sign of the height times the slope of the edge over the plane.
    [[nodiscard]] bool rises_at(Neighbour face, Scalar lambda) const { return derivative(face, lambda) > 0; }
    [[nodiscard]] bool falls_at(Neighbour face, Scalar lambda) const { return derivative(face, lambda) < 0; }
    [[nodiscard]] Scalar derivative(Neighbour face, Scalar lambda) const {
        const auto plane = unscaled_face_plane(mine_.table, face_of(face));
        const Scalar height = height_at(plane, segment_, lambda);
        const Scalar slope = slope_over(theirs_, plane.normal);
        return height > 0 ? slope : height < 0 ? -slope : Scalar(0);
    }

    bool move_to(Neighbour neighbour) {
        if (is_face(neighbour))
            mine_.move_to_face(face_of(neighbour));
        else
            mine_.move_to_vertex(vertex_of(neighbour));
        return true;
    }

    Body<Mine>& mine_;
    const Body<Theirs>& theirs_;
    typename Mine::Edge edge_;
    Segment<Scalar> segment_;  // the other edge, in this body's frame
    Clip<Scalar, Neighbour> clip_;
    Vec3<Scalar> end_normal_;  // normal of the vertex-edge planes, which are parallel
};

template <class TableA, class TableB>
[[nodiscard]] Step edge_edge(Body<TableA>& a, Body<TableB>& b) {
    if (EdgeClipping<TableA, TableB>(a, b).leave()) return Step::moved;
    if (EdgeClipping<TableB, TableA>(b, a).leave()) return Step::moved;
    return Step::separated;
}

}  // namespace edgewise::vclip
