// SPDX-License-Identifier: MIT
//
// A feature table that stores no feature: neighbour rings and vertex coordinates are all there is, and every
// edge, face and plane is computed from them when it is asked for. For layouts that differ in how they keep
// coordinates.
//
// An edge is its two vertices and where one stands in the other's ring; a face is its first half-edge. The
// neighbour before and the one after an edge in a ring are the third corners of its two faces: two vectors
// give the face's normal there. Planes are through a vertex, not at a distance from the origin, so nothing
// cancels; and both features on the two sides of a plane derive it from the same corner, so that they read
// the same number.
#pragma once

#include <cassert>
#include <string_view>
#include <vector>

#include "edgewise/layout_parts/block_table.hpp"
#include "edgewise/layout_parts/derived_walks.hpp"
#include "edgewise/layout_parts/narrow_rings.hpp"

namespace edgewise {

/// The plane through `anchor`; its normal has any length.
template <class Scalar>
struct AnchoredPlane {
    Vec3<Scalar> normal, anchor;
    Scalar offset = 0;

    /// In units of |normal|.
    [[nodiscard]] Scalar distance(const Vec3<Scalar>& p) const {
        return dot(normal, Vec3<Scalar>(p - anchor)) + offset;
    }
};

/// Points: how coordinates are kept, from the block's start on, by place(plan, facts), write(base, body) and
/// read(loader, base, v).
template <class Points, Precision P, class Loader>
class DerivedTable : public BlockTable<P, Loader, typename P::Compute> {
    using Base = BlockTable<P, Loader, typename P::Compute>;

  public:
    using typename Base::Compute;
    using typename Base::Vertex;
    using Edge = DerivedEdge;
    using Face = DerivedFace;

    static constexpr std::string_view derives = "edges, faces and every plane";
    static constexpr bool derives_planes = true;
    static constexpr Face no_face = {0xffffffff, 0xffffffff};

    DerivedTable(const Polyhedron& body, Parts parts, Loader loader = {}) : Base(body, parts, loader) {
        this->make_block(points_, ring_places_);
        rings().fill(body);
        write_body(body);
    }

    template <class OtherLoader>
    DerivedTable(const DerivedTable<Points, P, OtherLoader>& other, Loader loader)
        : Base(other, loader), points_(other.points_), ring_places_(other.ring_places_) {}

    void write_body(const Polyhedron& body) { points_.write(block_.base(), body); }
    [[nodiscard]] std::vector<Piece> pieces() const { return this->pieces_of(Points(), NarrowRingPlaces()); }
    [[nodiscard]] Ledger ledger() const { return ledger_of(pieces()); }

    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const {
        assert(v < facts_.vertex_count);
        return cast<Compute>(points_.read(loader_, block_.base(), v));
    }
    [[nodiscard]] auto neighbours(Vertex v) const {
        assert(v < facts_.vertex_count);
        return IndexedRing(rings().first(loader_, v), rings().last(loader_, v),
                           [this](Index at) { return rings().neighbour(loader_, at); });
    }
    [[nodiscard]] auto ring_of_vertex(Vertex v) const {
        assert(v < facts_.vertex_count);
        return IndexedRing(rings().first(loader_, v), rings().last(loader_, v),
                           [this, v](Index at) { return edge_at(v, at); });
    }

    [[nodiscard]] Vertex tail(const Edge& e) const { return e.tail; }
    [[nodiscard]] Vertex head(const Edge& e) const { return e.head; }
    [[nodiscard]] Face left(const Edge& e) const {
        return facts_.face_count == 0 ? no_face : face_of(from_tail(e));
    }
    [[nodiscard]] Face right(const Edge& e) const {
        return facts_.face_count == 0 ? no_face : face_of(from_head(e));
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

    /// Perpendicular to the edge, within the face: that part of another side of the face which is.
    [[nodiscard]] AnchoredPlane<Compute> edge_face_plane(const Edge& e, Side side) const {
        const Vec3<Compute> base = vertex(e.tail);
        if (facts_.face_count == 0) return {Vec3<Compute>::Zero(), base, -1};
        const Index at = from_tail(e).at;
        const Index third =
            side == Side::left ? rings().after(loader_, e.tail, at) : rings().before(loader_, e.tail, at);
        const Vec3<Compute> along = vertex(e.head) - base;
        const Vec3<Compute> aside = vertex(rings().neighbour(loader_, third)) - base;
        return {squared_norm(along) * aside - dot(along, aside) * along, base};
    }

    /// Unit normal: of the whole ring, since a corner of a long side and a short one would turn it.
    [[nodiscard]] AnchoredPlane<Compute> face_plane(const Face& f) const {
        assert(!(f == no_face));
        const Vec3<Compute> base = vertex(f.vertex);
        Vec3<Compute> normal = Vec3<Compute>::Zero(), before = Vec3<Compute>::Zero();
        const auto corner_at = [&](const HalfEdgeAt& h) { return Vec3<Compute>(vertex(h.vertex) - base); };
        for (const Vec3<Compute> corner : around(f, corner_at)) {
            normal += cross(before, corner);
            before = corner;
        }
        return {normal / norm(normal), base};
    }

    [[nodiscard]] auto ring_of_face(const Face& f) const {
        return around(f, [this](const HalfEdgeAt& h) { return edge_at(h.vertex, h.at); });
    }
    [[nodiscard]] auto all_faces() const {
        const Index vertices = facts_.face_count == 0 ? 0 : facts_.vertex_count;
        const auto from = [this, vertices](const HalfEdgeAt& start) {
            return next_half_edge(
                start, vertices, [this](Index v) { return rings().last(loader_, v); },
                [this](const HalfEdgeAt& h) { return face_of(h) == h; });
        };
        const auto after = [from](const Face& f) { return from({f.vertex, f.at + 1}); };
        return Chain(
            from({0, 0}), Face{vertices, 0}, [](const Face& f) { return f; }, after);
    }

  protected:
    using Base::block_;
    using Base::facts_;
    using Base::loader_;
    [[no_unique_address]] Points points_;

    template <class, Precision, class>
    friend class DerivedTable;

    /// Half-edges of a face in order, from its first, each turned into an item.
    template <class Item>
    [[nodiscard]] auto around(const Face& f, Item item) const {
        using Place = DerivedRingPlace;
        const auto after = [this](const Place& place) { return Place{next(place.at), true}; };
        return Chain(
            Place{f, false}, Place{f, true}, [item](const Place& place) { return item(place.at); }, after);
    }

    [[nodiscard]] RingEdge<Edge> edge_at(Vertex v, Index at) const {
        const Index other = rings().neighbour(loader_, at);
        if (v < other) return {{v, other, at, false}, false};
        return {{other, v, at, true}, true};
    }
    [[nodiscard]] HalfEdgeAt from_tail(const Edge& e) const {
        assert(e.tail < e.head && e.at < facts_.neighbour_count);
        return {e.tail, e.from_head ? rings().find(loader_, e.tail, e.head) : e.at};
    }
    [[nodiscard]] HalfEdgeAt from_head(const Edge& e) const {
        return {e.head, e.from_head ? e.at : rings().find(loader_, e.head, e.tail)};
    }

    /// The next half-edge around the face on the left: at its far end, clockwise from where it came.
    [[nodiscard]] HalfEdgeAt next(const HalfEdgeAt& h) const {
        const Index to = rings().neighbour(loader_, h.at);
        return {to, rings().before(loader_, to, rings().find(loader_, to, h.vertex))};
    }

    /// The face on the left of a half-edge: its smallest half-edge, as in the body.
    [[nodiscard]] Face face_of(const HalfEdgeAt& h) const {
        return first_of_face(
            h, [this](const HalfEdgeAt& at) { return rings().neighbour(loader_, at.at); },
            [this](const HalfEdgeAt& at) { return next(at); });
    }

    [[nodiscard]] NarrowRings rings() const { return ring_places_.in(block_.base()); }
    NarrowRingPlaces ring_places_;
};

}  // namespace edgewise
