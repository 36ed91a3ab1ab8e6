// SPDX-License-Identifier: MIT
//
// A table with a mapping as its layout: arrays give the places of a vertex, of an edge's planes, direction
// and ends, and of a face's plane. Reading, writing and rings are equal for all such layouts, and are here.
//
// Arrays has pointers into the block and is a handle of writable memory, as a span is: it may be const where
// what it points to is not. Its members:
//
//     void place(BlockPlan& plan, const BodyFacts& n);         // names its arrays, in memory order
//     ... vertex(Index v) const;                               // the places (places.hpp)
//     ... vertex_edge_plane(Index e, End end) const;
//     ... edge_face_plane(Index e, Side side) const;
//     ... direction(Index e) const;
//     ... length(Index e) const;
//     ... ends(Index e) const;
//     ... face_plane(Index f) const;
//
// A layout with planes that have no place of their own reads them by functions of its own. Its arrays then
// have `void write_edge(Index e, const EdgeGeometry&) const` instead of the places of planes and length.
// `void link(const Polyhedron&) const` writes data that follows from the topology alone, except an edge's
// ends. Arrays that hold the rings too derive from RingsAt.
#pragma once

#include <cassert>
#include <cstddef>
#include <string_view>
#include <type_traits>
#include <vector>

#include "edgewise/layout_parts/block_table.hpp"
#include "edgewise/layout_parts/places.hpp"
#include "edgewise/layout_parts/rings.hpp"
#include "edgewise/layout_parts/stored_fields.hpp"

namespace edgewise {

/// Empty rings for arrays that hold the rings themselves.
struct NoRings {
    static void place(BlockPlan& /*plan*/, const BodyFacts& /*n*/) {}
};

template <class Arrays>
inline constexpr bool brings_rings = std::is_base_of_v<RingsAt<Arrays>, Arrays>;

/// True if every field has a place of its own.
template <class Arrays>
concept PlacesEveryField = requires(const Arrays& at) {
    at.vertex_edge_plane(Index{}, End::tail);
    at.edge_face_plane(Index{}, Side::left);
    at.length(Index{});
};

template <class Arrays, Precision P, class Loader>
class StoredTable : public WithNumberedFeatures<BlockTable<P, Loader>> {
    using Base = WithNumberedFeatures<BlockTable<P, Loader>>;

  protected:
    using Base::facts_, Base::loader_;

  public:
    using typename Base::Compute, typename Base::Edge, typename Base::Face, typename Base::Stored,
        typename Base::Vertex;

    static constexpr std::string_view derives = "nothing";

    StoredTable(const Polyhedron& body, Parts parts, Loader loader = {}, WriteEdges write = WriteEdges::now)
        : Base(body, parts, loader) {
        this->make_block(at_, rings_);
        rings().fill(body, parts);
        for (Index e = 0; e < facts_.edge_count(); ++e) write_ends(at_.ends(e), body.edges[e]);
        if constexpr (requires { at_.link(body); }) {
            if (parts == Parts::features) at_.link(body);
        }
        write_geometry(*this, body, write);
    }

    template <class OtherLoader>
    StoredTable(const StoredTable<Arrays, P, OtherLoader>& other, Loader loader)
        : Base(other, loader), at_(other.at_), rings_(other.rings_) {}

    [[nodiscard]] std::vector<Piece> pieces() const { return this->pieces_of(at_, rings_); }
    [[nodiscard]] Ledger ledger() const { return ledger_of(pieces()); }
    /// Map of the fields by offset from `base`.
    [[nodiscard]] FieldMap field_map(const std::byte* base) const requires PlacesEveryField<Arrays> {
        return map_of_fields<Stored>(at_, rings(), facts_, base);
    }

    [[nodiscard]] auto neighbours(Vertex v) const {
        assert(v < facts_.vertex_count);
        return rings().neighbours(loader_, v);
    }
    [[nodiscard]] auto ring_of_vertex(Vertex v) const {
        assert(v < facts_.vertex_count && facts_.parts == Parts::features);
        return rings().ring_of_vertex(loader_, v);
    }
    [[nodiscard]] auto ring_of_face(Face f) const {
        assert(f < facts_.face_count);
        return rings().ring_of_face(loader_, f);
    }

    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const {
        assert(v < facts_.vertex_count);
        return read_vector<Compute>(loader_, at_.vertex(v), Field::vertex);
    }

    [[nodiscard]] Vertex tail(Edge e) const { return end(e, 0); }
    [[nodiscard]] Vertex head(Edge e) const { return end(e, 1); }
    [[nodiscard]] Face left(Edge e) const { return end(e, 2); }
    [[nodiscard]] Face right(Edge e) const { return end(e, 3); }
    [[nodiscard]] Vec3<Compute> direction(Edge e) const {
        assert(e < facts_.edge_count());
        return read_vector<Compute>(loader_, at_.direction(e), Field::edge_direction);
    }

    [[nodiscard]] Plane<Compute> vertex_edge_plane(Edge e, End end) const {
        assert(e < facts_.edge_count());
        return read_plane<Compute>(loader_, at_.vertex_edge_plane(e, end), Field::voronoi_plane);
    }
    [[nodiscard]] Plane<Compute> edge_face_plane(Edge e, Side side) const {
        assert(e < facts_.edge_count());
        return read_plane<Compute>(loader_, at_.edge_face_plane(e, side), Field::voronoi_plane);
    }
    [[nodiscard]] Plane<Compute> face_plane(Face f) const {
        assert(f < facts_.face_count);
        return read_plane<Compute>(loader_, at_.face_plane(f), Field::face_plane);
    }

    void write_vertex(Index v, const Vec3d& point) { write_vector(at_.vertex(v), point); }
    void write_edge(Index e, const EdgeGeometry& g) { store_edge(at_, e, g); }
    void write_face(Index f, const Plane<double>& plane) { write_plane(at_.face_plane(f), plane); }

  protected:
    template <class, Precision, class>
    friend class StoredTable;

    Arrays at_;
    [[no_unique_address]] std::conditional_t<brings_rings<Arrays>, NoRings, Rings> rings_;

  private:
    [[nodiscard]] const auto& rings() const {
        if constexpr (brings_rings<Arrays>) {
            return at_;
        } else {
            return rings_;
        }
    }
    [[nodiscard]] Index end(Edge e, std::size_t k) const {
        assert(e < facts_.edge_count());
        return this->load(end_at(at_.ends(e), k), Field::edge_ends);
    }
};

}  // namespace edgewise
