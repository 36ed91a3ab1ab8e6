// SPDX-License-Identifier: MIT
//
// What layouts have in common whose handles are positions in arrays: rings as compressed rows on top of the
// block. A layout derives from it and adds how vertices, edges and planes are stored and read.
#pragma once

#include "edgewise/layout_parts/block_table.hpp"
#include "edgewise/layout_parts/rings.hpp"

namespace edgewise {

template <Precision P, class Loader>
class IndexedTable : public BlockTable<P, Loader> {
    using Base = BlockTable<P, Loader>;

  protected:
    using Base::facts_;
    using Base::loader_;

  public:
    using typename Base::Vertex;
    using Edge = Index;
    using Face = Index;

    static constexpr Face no_face = edgewise::no_face;

    [[nodiscard]] auto all_faces() const { return index_range(facts_.face_count); }
    [[nodiscard]] auto neighbours(Vertex v) const { return rings_.neighbours(loader_, v); }
    [[nodiscard]] auto ring_of_vertex(Vertex v) const { return rings_.ring_of_vertex(loader_, v); }
    [[nodiscard]] auto ring_of_face(Face f) const { return rings_.ring_of_face(loader_, f); }

  protected:
    template <Precision, class>
    friend class IndexedTable;

    explicit IndexedTable(Loader loader) : Base(loader) {}
    template <class OtherLoader>
    IndexedTable(const IndexedTable<P, OtherLoader>& other, Loader loader)
        : Base(other, loader), rings_(other.rings_) {}

    /// How many edges and faces a table with these parts has.
    static std::size_t edges_of(const Polyhedron& body, Parts parts) {
        return parts == Parts::features ? body.edge_count() : 0;
    }
    static std::size_t faces_of(const Polyhedron& body, Parts parts) {
        return parts == Parts::features ? body.face_count() : 0;
    }

    Rings rings_;
};

}  // namespace edgewise
