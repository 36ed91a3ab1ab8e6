// SPDX-License-Identifier: MIT
//
// A rectangular box about the origin with its sides along the axes, as engines keep boxes: three half extents
// and nothing else, 24 bytes in double and 12 in single. Vertices, rings, edges and faces follow from the
// handles; every plane is exact, because its normal lies along an axis.
//
// A handle is made of bits, one for each axis: 4 for x, 2 for y, 1 for z. The number of a vertex has the bits
// of the axes on which it is positive. An edge is the bit of its axis and its tail, the end on the negative
// side. Faces have the canonical body's numbers: x, y, z on the negative side, then z, y, x on the positive.
//
// Other bodies are refused, and so is a box with a vertex that is one bit off (stored_body).
#pragma once

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

#include "edgewise/geometry/hull.hpp"
#include "edgewise/geometry/message.hpp"
#include "edgewise/geometry/polyhedron_builder.hpp"
#include "edgewise/layout_parts/block_table.hpp"
#include "edgewise/table/ring_questions.hpp"

namespace edgewise {

/// The box with its vertices in the order of their numbers. Fails, with a reason, if the body is no box about
/// the origin with sides along the axes, to the last bit, or has a face that is split.
[[nodiscard]] inline Result<Polyhedron> box_in_order(const Polyhedron& body) {
    const auto refuse = [](const auto&... why) {
        return Result<Polyhedron>::failure(
            message("box takes bodies of 8 vertices at (+-x, +-y, +-z) and 6 faces, and ", why...));
    };
    if (body.vertex_count() != 8 || body.face_count() != 6)
        return refuse("this one has ", body.vertex_count(), " and ", body.face_count());
    const auto number = [&](Index v) {
        const Vec3d& p = body.vertices[v];
        return Index{p.x() > 0} << 2 | Index{p.y() > 0} << 1 | Index{p.z() > 0};
    };
    FaceRings ordered{std::vector<Vec3d>(8), std::vector<Index>(8), {}};
    for (Index v = 0; v < 8; ++v) {
        if (body.vertices[v].cwiseAbs() != body.vertices[0].cwiseAbs())
            return refuse("vertices ", body.input_index[0], " and ", body.input_index[v],
                          " of this one differ in more than signs");
        ordered.vertices[number(v)] = body.vertices[v];
        ordered.input_index[number(v)] = body.input_index[v];
    }
    for (Index f = 0; f < 6; ++f) {
        auto& ring = ordered.rings.emplace_back();
        for (const HalfEdge h : body.ring_of_face(f)) ring.push_back(number(body.tail(h)));
    }
    return build_polyhedron(ordered);
}

/// Three half extents, at the start of the block.
template <class Stored>
struct HalfExtents {
    static void place(BlockPlan& plan, const BodyFacts& /*n*/) {
        plan.array_at<Stored>(3, {{Component::vertex_coordinates, sizeof(Stored)}});
    }
};

template <Precision P, class Loader = Direct>
class box : public WithNumberedFeatures<PlacedTable<HalfExtents<typename P::Stored>, P, Loader>> {
    using Base = WithNumberedFeatures<PlacedTable<HalfExtents<typename P::Stored>, P, Loader>>;

  public:
    using typename Base::Compute, typename Base::Edge, typename Base::Face, typename Base::Stored,
        typename Base::Vertex;

    static constexpr std::string_view name = "box";
    static constexpr std::string_view stores = "three half extents of a box about the origin";
    static constexpr std::string_view derives = "vertices, rings, edges, faces and every plane";
    static constexpr bool derives_planes = true, derives_rings = true;

    /// The box as the table holds it, with its vertices in the order of their numbers: the only kind of body
    /// that it may be built from.
    [[nodiscard]] static Result<Polyhedron> stored_body(const Polyhedron& body) {
        if constexpr (!std::is_same_v<Stored, float>) return box_in_order(body);
        auto single = round_to_single(body);
        return single ? box_in_order(*single) : single;
    }

    /// Both kinds of parts are the same here: nothing can be left out.
    box(const Polyhedron& body, Parts /*parts*/, Loader loader = {}) : Base(body, Parts::features, loader) {
        write_body(body);
    }
    using Base::Base;

    void write_body(const Polyhedron& body) {
        assert(box_in_order(body));
        for (int k = 0; k < 3; ++k) stored()[k] = static_cast<Stored>(std::abs(body.vertices[0][k]));
    }

    [[nodiscard]] Vec3d half_extents() const { return {half_extent(4), half_extent(2), half_extent(1)}; }
    [[nodiscard]] static constexpr std::size_t vertex_count() { return 8; }
    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const {
        assert(v < 8);
        const Vec3<Compute> half = {half_extent(4), half_extent(2), half_extent(1)};
        return {signed_by(~v >> 2, half.x()), signed_by(~v >> 1, half.y()), signed_by(~v, half.z())};
    }
    [[nodiscard]] static auto neighbours(Vertex v) {
        return IndexedRing(0, 3, [v](Index at) { return v ^ axis_in_ring(v, at); });
    }
    [[nodiscard]] static auto ring_of_vertex(Vertex v) {
        return IndexedRing(0, 3, [v](Index at) { return edge_at(v, axis_in_ring(v, at)); });
    }
    /// Along the face's two axes in turn, from the corner where both are negative, or back to it.
    [[nodiscard]] static auto ring_of_face(Face f) {
        const Index axis = axis_of(f), low = axis == 1 ? 2 : 1, high = 7 ^ axis ^ low;
        const Index corner = f < 3 ? 0 : axis;
        const bool forth = (axis == 2) == (f >= 3);
        return IndexedRing(0, 4, [=](Index at) {
            const Index place = forth ? at : (4 - at) % 4;
            const Index start = corner + (place == 1 || place == 2 ? low : 0) + (place >= 2 ? high : 0);
            const RingEdge<Edge> forwards = edge_at(start, place % 2 == 0 ? low : high);
            return RingEdge<Edge>{forwards.edge, forwards.flipped == forth};
        });
    }

    [[nodiscard]] static Vertex tail(Edge e) { return e & 7; }
    [[nodiscard]] static Vertex head(Edge e) { return tail(e) | e >> 3; }
    /// The start of V-Clip on boxes (vclip/box_start.hpp) asks for these.
    [[nodiscard]] static Edge edge_along(Vertex v, Index axis) { return edge_at(v, axis).edge; }
    [[nodiscard]] static Face face_across(Vertex v, Index axis) {
        return (v & axis) != 0 ? 3 + (axis >> 1) : 2 - (axis >> 1);
    }
    [[nodiscard]] static Face left(Edge e) { return face_beside(e, Side::left); }
    [[nodiscard]] static Face right(Edge e) { return face_beside(e, Side::right); }
    [[nodiscard]] static Vec3<Compute> direction(Edge e) { return along(e >> 3, true); }

    [[nodiscard]] Plane<Compute> vertex_edge_plane(Edge e, End end) const {
        return {along(e >> 3, end == End::head), -half_extent(e >> 3)};
    }
    [[nodiscard]] Plane<Compute> edge_face_plane(Edge e, Side side) const {
        const Index across = 7 ^ e >> 3 ^ axis_beside(e, side);
        return {along(across, (e & across) == 0), half_extent(across)};
    }
    [[nodiscard]] Plane<Compute> face_plane(Face f) const {
        return {along(axis_of(f), f >= 3), -half_extent(axis_of(f))};
    }

    [[nodiscard]] static Compute slope_along(Edge e, const Vec3<Compute>& normal) {
        return squared_slope(normal[coordinate(e >> 3)]);
    }

    /// Proofs by the corners next to a feature (vclip/still_closest.hpp): these differ from it along one
    /// axis.
    [[nodiscard]] static bool neighbours_decide() { return true; }
    [[nodiscard]] bool ends_at_vertex(Vertex v, const Vec3<Compute>& direction, Compute size) const {
        return is_highest(v, 7, direction, size);
    }
    [[nodiscard]] bool ends_at_edge(Edge e, const Vec3<Compute>& direction, Compute size) const {
        return is_highest(tail(e), 7 ^ e >> 3, direction, size);
    }
    [[nodiscard]] std::optional<Plane<Compute>> plane_below(Face f, const Vec3<Compute>& point) const {
        const Plane<Compute> plane = face_plane(f);
        for (const Index axis : {4U, 2U, 1U})
            if (axis != axis_of(f) && std::abs(point[coordinate(axis)]) > half_extent(axis))
                return std::nullopt;
        return plane.distance(point) > 0 ? std::optional(plane) : std::nullopt;
    }

    [[nodiscard]] static std::optional<Edge> edge_named(std::uint32_t number) {
        const Index axis = number >> 3;
        const bool is_edge = (axis == 1 || axis == 2 || axis == 4) && (number & axis) == 0;
        return is_edge ? std::optional<Edge>(number) : std::nullopt;
    }

    /// Returns the vertex farthest along the direction, the first of equals: where rounding absorbs a side,
    /// its two ends are equally high.
    [[nodiscard]] Vertex scan_support(const Vec3<Compute>& direction) const {
        const Compute x = half_extent(4) * direction.x(), y = half_extent(2) * direction.y();
        const Compute z = half_extent(1) * direction.z();
        Vertex best = Vertex{x > 0} << 2 | Vertex{y > 0} << 1 | Vertex{z > 0};
        const Compute top = std::abs(x) + std::abs(y) + std::abs(z);
        const Compute least = std::min({std::abs(x), std::abs(y), std::abs(z)});
        if (least > 4 * Tolerance<Compute>::eps * top) return best;
        for (const Index axis : {4U, 2U, 1U})
            if ((best & axis) != 0 && dot(vertex(best ^ axis), direction) == top) best ^= axis;
        return best;
    }
    /// Returns the height of the farthest vertex along the direction.
    template <class Number>
    [[nodiscard]] Number scan_height(const Vec3<Number>& direction) const {
        return Number(half_extent(4)) * std::abs(direction.x()) +
               Number(half_extent(2)) * std::abs(direction.y()) +
               Number(half_extent(1)) * std::abs(direction.z());
    }

  private:
    /// True if the vertices across these axes from `v` lie lower along the direction, or as low; by more than
    /// rounding if the direction is so short that it is off by its points' rounding (derived_ends.hpp).
    [[nodiscard]] bool is_highest(Vertex v, Index axes, const Vec3<Compute>& direction, Compute size) const {
        const bool is_short = max_abs(direction) < Tolerance<float>::close * size;
        const Compute least = is_short ? Tolerance<Compute>::level * Compute(this->reach()) * size : 0;
        bool highest = true;
        for (const Index axis : {4U, 2U, 1U}) {
            const Compute over = 2 * half_extent(axis) * direction[coordinate(axis)];
            highest &= (axes & axis) == 0 || signed_by(~v >> (axis >> 1), over) >= least;
        }
        return highest;
    }
    /// Axis of the edge at this place of the vertex's ring. Hexadecimal digits, of vertex 7 to vertex 0: a
    /// ring begins at the neighbour of the smallest number and runs counter-clockwise, seen from outside.
    [[nodiscard]] static Index axis_in_ring(Vertex v, Index at) {
        constexpr std::uint32_t axes[] = {0x44442211, 0x21124142, 0x12211424};
        return axes[at] >> 4 * v & 7;
    }
    [[nodiscard]] static RingEdge<Edge> edge_at(Vertex v, Index axis) {
        return {axis << 3 | (v & ~axis), (v & axis) != 0};
    }
    [[nodiscard]] static Index axis_of(Face f) { return 4U >> (f < 3 ? f : 5 - f); }
    /// Axis of the face on this side of the edge: of x, y, z, after the edge's own or before it.
    [[nodiscard]] static Index axis_beside(Edge e, Side side) {
        const Index axis = e >> 3, after = axis > 1 ? axis >> 1 : 4, before = 7 ^ axis ^ after;
        const bool alike = ((e & after) != 0) == ((e & before) != 0);
        return (side == Side::left) == alike ? after : before;
    }
    [[nodiscard]] static Face face_beside(Edge e, Side side) {
        return face_across(tail(e), axis_beside(e, side));
    }
    [[nodiscard]] static Index coordinate(Index axis) { return 2 - (axis >> 1); }
    /// The number, or its negative if `bits` is odd, without a branch.
    [[nodiscard]] static Compute signed_by(Index bits, Compute number) {
        using Bits = std::conditional_t<std::is_same_v<Compute, float>, std::uint32_t, std::uint64_t>;
        return std::bit_cast<Compute>(std::bit_cast<Bits>(number) ^ Bits{bits} << (8 * sizeof(Bits) - 1));
    }
    /// Unit vector along an axis, or against it.
    [[nodiscard]] static Vec3<Compute> along(Index axis, bool positive) {
        const Compute one = positive ? 1 : -1;
        return {one * Compute(axis >> 2), one * Compute(axis >> 1 & 1), one * Compute(axis & 1)};
    }
    [[nodiscard]] Stored* stored() const { return this->template array<Stored>(0); }
    [[nodiscard]] Compute half_extent(Index axis) const {
        return static_cast<Compute>(this->load(stored()[coordinate(axis)], Field::vertex));
    }
};

}  // namespace edgewise
