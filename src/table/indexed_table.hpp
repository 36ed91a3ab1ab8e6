// SPDX-License-Identifier: MIT
//
// What layouts have in common whose handles are positions in arrays: one block of memory, the body's facts,
// rings as compressed rows, and the loader. A layout derives from it and adds what is its own: how vertices,
// edges and planes are stored and read.
#pragma once

#include <string_view>

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/table/block.hpp"
#include "edgewise/table/body_facts.hpp"
#include "edgewise/table/contract.hpp"
#include "edgewise/table/rings.hpp"
#include "edgewise/table/voronoi.hpp"

namespace edgewise {

template <Precision P, class Loader>
class IndexedTable {
  public:
    using PrecisionType = P;
    using Stored = typename P::Stored;
    using Compute = typename P::Compute;
    using Vertex = Index;
    using Edge = Index;
    using Face = Index;

    static constexpr Face no_face = edgewise::no_face;

    [[nodiscard]] std::size_t vertex_count() const { return facts_.vertex_count; }
    [[nodiscard]] Vertex first_vertex() const { return 0; }
    [[nodiscard]] Index index_of(Vertex v) const { return v; }
    [[nodiscard]] auto all_vertices() const { return index_range(facts_.vertex_count); }
    [[nodiscard]] auto all_faces() const { return index_range(facts_.face_count); }
    [[nodiscard]] bool strictly_convex() const { return facts_.strictly_convex; }
    [[nodiscard]] double reach() const { return facts_.reach; }
    [[nodiscard]] const Ledger& ledger() const { return block_.ledger(); }

    [[nodiscard]] auto neighbours(Vertex v) const { return rings_.neighbours(loader_, v); }
    [[nodiscard]] auto ring_of_vertex(Vertex v) const { return rings_.ring_of_vertex(loader_, v); }
    [[nodiscard]] auto ring_of_face(Face f) const { return rings_.ring_of_face(loader_, f); }

  protected:
    template <Precision, class>
    friend class IndexedTable;

    explicit IndexedTable(Loader loader) : loader_(loader) {}

    /// The same memory seen through another loader.
    template <class OtherLoader>
    IndexedTable(const IndexedTable<P, OtherLoader>& other, Loader loader)
        : loader_(loader), block_(other.block_), facts_(other.facts_), rings_(other.rings_) {}

    /// Allocates what was planned. To be called once, before anything is filled.
    void allocate(const BlockPlan& plan, const Polyhedron& body, Parts parts) {
        block_ = Block(plan);
        facts_ = BodyFacts(body, parts, Tolerance<Stored>::strict_turn);
    }

    template <class Value>
    const Value& load(const Value& location, Field field) const {
        return loader_.load(location, field);
    }

    [[no_unique_address]] Loader loader_;
    Block block_;
    BodyFacts facts_;
    Rings rings_;
};

}  // namespace edgewise
