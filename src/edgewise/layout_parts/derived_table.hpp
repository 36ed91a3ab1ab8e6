// SPDX-License-Identifier: MIT
//
// A feature table that stores no feature: neighbour rings and vertex coordinates are all there is, and every
// edge, face and plane is worked out from them when it is asked for. For layouts that differ in how they keep
// coordinates.
//
// An edge is its two vertices and where one stands in the other's ring; a face is its first half-edge. The
// neighbour before and the one after an edge in a ring are the third corners of its two faces: two vectors
// give the face's normal there. Planes are through a vertex, not at a distance from the origin, so nothing
// cancels; and both features on the two sides of a plane derive it from the same corner, so that they read
// the same number.
#pragma once

#include <cstdint>

#include "edgewise/layout_parts/block_table.hpp"
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

/// `at` is the head's place in the ring of the tail, or, seen from the head, the tail's place in its ring.
struct DerivedEdge {
    Index tail, head, at;
    bool from_head;

    [[nodiscard]] bool operator==(const DerivedEdge& other) const {
        return tail == other.tail && head == other.head;
    }
};

/// The first half-edge of its ring: from `vertex` to the neighbour at this place.
struct DerivedFace {
    Index vertex, at;
    [[nodiscard]] bool operator==(const DerivedFace&) const = default;
};

/// Table: the layout; it gives vertex(v).
template <class Table, Precision P, class Loader>
class DerivedTable : public BlockTable<P, Loader, typename P::Compute> {
    using Base = BlockTable<P, Loader, typename P::Compute>;

  public:
    using typename Base::Compute;
    using typename Base::Vertex;
    using Edge = DerivedEdge;
    using Face = DerivedFace;

    static constexpr bool derives_planes = true;
    static constexpr Face no_face = {0xffffffff, 0xffffffff};

    [[nodiscard]] auto neighbours(Vertex v) const {
        return IndexedRing(rings_.first(loader_, v), rings_.last(loader_, v),
                           [this](Index at) { return rings_.neighbour(loader_, at); });
    }
    [[nodiscard]] auto ring_of_vertex(Vertex v) const {
        return IndexedRing(rings_.first(loader_, v), rings_.last(loader_, v),
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
            side == Side::left ? rings_.after(loader_, e.tail, at) : rings_.before(loader_, e.tail, at);
        const Vec3<Compute> along = vertex(e.head) - base;
        const Vec3<Compute> aside = vertex(rings_.neighbour(loader_, third)) - base;
        return {squared_norm(along) * aside - dot(along, aside) * along, base};
    }

    /// Unit normal: of the whole ring, since a corner of a long side and a short one would turn it.
    [[nodiscard]] AnchoredPlane<Compute> face_plane(const Face& f) const {
        const Vec3<Compute> base = vertex(f.vertex);
        Vec3<Compute> normal = Vec3<Compute>::Zero(), before = Vec3<Compute>::Zero();
        for (const HalfEdgeAt h : walk(f)) {
            const Vec3<Compute> corner = vertex(h.vertex) - base;
            normal += cross(before, corner);
            before = corner;
        }
        return {normal / norm(normal), base};
    }

    [[nodiscard]] auto ring_of_face(const Face& f) const { return FaceRing<RingEdge<Edge>>{this, f}; }
    [[nodiscard]] auto all_faces() const { return AllFaces{this}; }

  protected:
    template <class, Precision, class>
    friend class DerivedTable;

    explicit DerivedTable(Loader loader) : Base(loader) {}
    template <class OtherTable, class OtherLoader>
    DerivedTable(const DerivedTable<OtherTable, P, OtherLoader>& other, Loader loader)
        : Base(other, loader), rings_(other.rings_) {}

    /// Plans an array of what the layout keeps of a vertex, and the rings; allocates, and fills the rings.
    template <class Coordinates>
    [[nodiscard]] Coordinates* build(const Polyhedron& body, Parts parts) {
        BlockPlan plan;
        const auto vertices = plan.array<Coordinates>(body.vertex_count(),
                                                      {{Component::vertex_coordinates, sizeof(Coordinates)}});
        rings_ = NarrowRings(plan, body);
        this->allocate(std::move(plan), body, parts);
        rings_.fill(this->block_, body);
        return this->block_.start(vertices);
    }

    using Base::facts_;
    using Base::loader_;
    NarrowRings rings_;

  private:
    /// A half-edge: from a vertex to the neighbour at a place in its ring.
    using HalfEdgeAt = DerivedFace;

    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const { return static_cast<const Table&>(*this).vertex(v); }

    [[nodiscard]] RingEdge<Edge> edge_at(Vertex v, Index at) const {
        const Index other = rings_.neighbour(loader_, at);
        if (v < other) return {{v, other, at, false}, false};
        return {{other, v, at, true}, true};
    }
    [[nodiscard]] HalfEdgeAt from_tail(const Edge& e) const {
        return {e.tail, e.from_head ? rings_.find(loader_, e.tail, e.head) : e.at};
    }
    [[nodiscard]] HalfEdgeAt from_head(const Edge& e) const {
        return {e.head, e.from_head ? e.at : rings_.find(loader_, e.head, e.tail)};
    }

    /// The next half-edge around the face on the left: at its far end, clockwise from where it came.
    [[nodiscard]] HalfEdgeAt next(const HalfEdgeAt& h) const {
        const Index to = rings_.neighbour(loader_, h.at);
        return {to, rings_.before(loader_, to, rings_.find(loader_, to, h.vertex))};
    }

    /// The face on the left of a half-edge: its smallest half-edge, as in the body (by edges, then tail
    /// first).
    [[nodiscard]] Face face_of(const HalfEdgeAt& start) const {
        Face best = start;
        Index best_low = 0xffffffff, best_high = 0xffffffff;
        HalfEdgeAt h = start;
        do {
            const Index to = rings_.neighbour(loader_, h.at);
            const Index low = std::min(h.vertex, to), high = std::max(h.vertex, to);
            if (low < best_low || (low == best_low && high < best_high)) {
                best = h;
                best_low = low;
                best_high = high;
            }
            h = next(h);
        } while (!(h == start));
        return best;
    }

    /// Half-edges of a face in order, from its first; as such, or as edges.
    template <class Item>
    class FaceRing {
      public:
        class Iterator {
          public:
            Iterator(const DerivedTable* table, const HalfEdgeAt& at, bool done)
                : table_(table), at_(at), done_(done) {}
            Item operator*() const {
                if constexpr (std::is_same_v<Item, HalfEdgeAt>) {
                    return at_;
                } else {
                    return table_->edge_at(at_.vertex, at_.at);
                }
            }
            Iterator& operator++() {
                at_ = table_->next(at_);
                done_ = true;
                return *this;
            }
            /// Beside the end: back at the first half-edge, once under way.
            bool operator!=(const Iterator& end) const { return !(done_ && at_ == end.at_); }

          private:
            const DerivedTable* table_;
            HalfEdgeAt at_;
            bool done_;
        };

        FaceRing(const DerivedTable* table, const Face& f) : table_(table), face_(f) {}
        [[nodiscard]] Iterator begin() const { return {table_, face_, false}; }
        [[nodiscard]] Iterator end() const { return {table_, face_, true}; }

      private:
        const DerivedTable* table_;
        Face face_;
    };
    [[nodiscard]] FaceRing<HalfEdgeAt> walk(const Face& f) const { return {this, f}; }

    /// Every half-edge that is the first of its face.
    class AllFaces {
      public:
        class Iterator {
          public:
            Iterator(const DerivedTable* table, Index vertex) : table_(table), at_{vertex, 0} { settle(); }
            Face operator*() const { return at_; }
            Iterator& operator++() {
                ++at_.at;
                settle();
                return *this;
            }
            bool operator!=(const Iterator& end) const { return at_.vertex != end.at_.vertex; }

          private:
            /// On to the next first half-edge, this one included; the places of all rings follow each other.
            void settle() {
                const Index count = table_->facts_.face_count == 0 ? 0 : table_->facts_.vertex_count;
                if (count == 0) at_.vertex = table_->facts_.vertex_count;
                for (; at_.vertex < count; ++at_.vertex) {
                    for (; at_.at < table_->rings_.last(table_->loader_, at_.vertex); ++at_.at) {
                        if (table_->face_of(at_) == at_) return;
                    }
                }
            }

            const DerivedTable* table_;
            HalfEdgeAt at_;
        };

        explicit AllFaces(const DerivedTable* table) : table_(table) {}
        [[nodiscard]] Iterator begin() const { return {table_, 0}; }
        [[nodiscard]] Iterator end() const { return {table_, table_->facts_.vertex_count}; }

      private:
        const DerivedTable* table_;
    };
};

}  // namespace edgewise
