// SPDX-License-Identifier: MIT
//
// A table that stores no feature: it has only neighbour rings and vertex coordinates, and computes every
// edge, face and plane from them when it is asked for. For layouts that differ in how they keep
// coordinates.
//
// The neighbour before and the one after an edge in a ring (derived_rings.hpp) are the third corners of its
// two faces: two vectors give the face's normal there. Planes are through a vertex, not at a distance from
// the origin, so nothing cancels; and both features on the two sides of a plane derive it from the same
// corner, so that they read the same number. Thin corners take more care (thin_corners.hpp).
#pragma once

#include <cassert>
#include <string_view>
#include <vector>

#include "edgewise/layout_parts/derived/derived_rings.hpp"
#include "edgewise/layout_parts/derived/thin_corners.hpp"
#include "edgewise/layout_parts/voronoi.hpp"

namespace edgewise {

/// Points: storage of the coordinates, from the block's start on, by place(plan, facts), write(base, body)
/// and read(loader, base, v).
template <class Points, Precision P, class Loader, class RingPlaces = NarrowRingPlaces>
class DerivedPlanes : public DerivedRings<P, Loader, RingPlaces> {
    using Base = DerivedRings<P, Loader, RingPlaces>;

  public:
    using Base::no_face;
    using typename Base::Compute, typename Base::Edge, typename Base::Face, typename Base::Vertex;

    static constexpr std::string_view derives = "edges, faces and every plane";
    static constexpr bool derives_planes = true;

    /// Calls `prepare(body)` of RingPlaces or Points that depend on more of the body than its facts.
    DerivedPlanes(const Polyhedron& body, Parts parts, Loader loader = {}, Points points = {})
        : Base(body, parts, loader), points_(points) {
        if constexpr (requires { this->ring_places_.prepare(body); }) this->ring_places_.prepare(body);
        this->make_block(points_, this->ring_places_);
        rings().fill(body);
        write_body(body);
        note_corners(body);
    }

    template <class OtherLoader>
    DerivedPlanes(const DerivedPlanes<Points, P, OtherLoader, RingPlaces>& other, Loader loader)
        : Base(other, loader), points_(other.points_) {}

    void write_body(const Polyhedron& body) { points_.write(block_.base(), body); }
    void note_facts(const Polyhedron& body) {
        Base::note_facts(body);
        note_corners(body);
    }
    [[nodiscard]] std::vector<Piece> pieces() const { return this->pieces_of(points_, this->ring_places_); }
    [[nodiscard]] Ledger ledger() const { return ledger_of(pieces()); }

    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const {
        assert(v < facts_.vertex_count);
        return cast<Compute>(points_.read(loader_, block_.base(), v));
    }

    [[nodiscard]] Vec3<Compute> direction(const Edge& e) const {
        const Vec3<Compute> along = vertex(e.head) - vertex(e.tail);
        return along / norm(along);
    }

    [[nodiscard]] AnchoredPlane<Compute> vertex_edge_plane(const Edge& e, End end) const {
        const Vec3<Compute> from = vertex(e.tail), to = vertex(e.head);
        if (end == End::tail) return {from - to, from};
        return {to - from, to};
    }

    /// Plane normal to the face through the edge: its normal is another side's part normal to the edge.
    [[nodiscard]] AnchoredPlane<Compute> edge_face_plane(const Edge& e, Side side) const {
        const Vec3<Compute> base = vertex(e.tail);
        if (facts_.face_count == 0) return {Vec3<Compute>::Zero(), base, -1};
        const Index third = this->third_corner(e, side);
        return across(base, vertex(e.head), vertex(third));
    }

    /// Face plane of unit normal, from the whole ring: a corner of a long and a short side would turn it.
    [[nodiscard]] AnchoredPlane<Compute> face_plane(const Face& f) const {
        const auto plane = unscaled_face_plane(f);
        return {plane.normal / norm(plane.normal), plane.anchor};
    }
    [[nodiscard]] AnchoredPlane<Compute> unscaled_face_plane(const Face& f) const {
        assert(!(f == no_face));
        if (facts_.thin_corners) [[unlikely]]
            return plane_of_thin_face(f);
        if (!this->all_triangles()) return polygon_plane(f);
        const Vec3<Compute> base = vertex(f.vertex);
        const auto corners = this->corners_of(f);
        const Vec3<Compute> to_second = vertex(corners.second) - base;
        return {cross(to_second, Vec3<Compute>(vertex(corners.third) - base)), base};
    }

  protected:
    using Base::block_, Base::facts_, Base::loader_, Base::rings;
    [[no_unique_address]] Points points_;

    [[nodiscard]] [[gnu::noinline]] AnchoredPlane<Compute> polygon_plane(const Face& f) const {
        const Vec3<Compute> base = vertex(f.vertex);
        NewellSum<Compute> sum;
        visit_corners(f, [&](const Vec3<Compute>& corner) { sum.add(Vec3<Compute>(corner - base)); });
        return {sum.normal(), base};
    }

    /// Computes polygon_plane of any face, in the next wider arithmetic where that is needed.
    [[nodiscard]] [[gnu::noinline]] AnchoredPlane<Compute> plane_of_thin_face(const Face& f) const {
        const Vec3<Compute> base = vertex(f.vertex);
        PlainNewellSum<Compute> plain;
        visit_corners(f, [&](const Vec3<Compute>& corner) { plain.add(Vec3<Compute>(corner - base)); });
        if (plain.is_fair()) return {plain.normal(), base};
        NewellSum<Wider<Compute>> wide;
        visit_corners(f, [&](const Vec3<Compute>& corner) { wide.add(wide_difference(corner, base)); });
        return {cast<Compute>(wide.normal()), base};
    }

    /// Calls visit(corner) with the corners of a face but its first, in order.
    template <class Visit>
    void visit_corners(const Face& f, Visit visit) const {
        this->visit_sides(f, [&](const DerivedSide& side) {
            if (side.to == f.vertex) return false;
            visit(vertex(side.to));
            return true;
        });
    }

    /// Plane through the edge from base to end, perpendicular to it, positive towards the other corner.
    [[nodiscard]] AnchoredPlane<Compute> across(const Vec3<Compute>& base, const Vec3<Compute>& end,
                                                const Vec3<Compute>& other) const {
        if (facts_.thin_corners) [[unlikely]]
            return {perpendicular_at(base, end, other), base};
        const Vec3<Compute> along = end - base, aside = other - base;
        return {squared_norm(along) * aside - dot(along, aside) * along, base};
    }
    /// Computes `across` between two corners of a triangle, from the smaller one.
    [[nodiscard]] AnchoredPlane<Compute> side_plane(bool rising, const Vec3<Compute>& from,
                                                    const Vec3<Compute>& to,
                                                    const Vec3<Compute>& other) const {
        return rising ? across(from, to, other) : across(to, from, other);
    }

    void note_corners(const Polyhedron& body) {
        facts_.thin_corners = has_thin_corners<Compute>(body, facts_.reach);
    }

    template <class, Precision, class, class>
    friend class DerivedPlanes;
};

}  // namespace edgewise
