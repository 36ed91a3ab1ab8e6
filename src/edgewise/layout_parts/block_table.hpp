// SPDX-License-Identifier: MIT
//
// What layouts have in common that keep a body in one block of memory: the block, the body's facts, and the
// loader. A layout derives from it, or from one of its heirs (IndexedTable, DerivedTable), and adds what is
// its own: how vertices, edges and planes are stored and read.
#pragma once

#include <string_view>
#include <utility>

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/layout_parts/block.hpp"
#include "edgewise/layout_parts/write_geometry.hpp"
#include "edgewise/table/body_facts.hpp"
#include "edgewise/table/contract.hpp"
#include "edgewise/table/loader.hpp"

namespace edgewise {

/// Strictness: the scalar whose rounding decides what is strictly convex, that of the stored planes, or that
/// which computes where planes are derived.
template <Precision P, class Loader, class Strictness = typename P::Stored>
class BlockTable {
  public:
    using PrecisionType = P;
    using Stored = typename P::Stored;
    using Compute = typename P::Compute;
    using Vertex = Index;

    [[nodiscard]] std::size_t vertex_count() const { return facts_.vertex_count; }
    [[nodiscard]] Vertex first_vertex() const { return 0; }
    [[nodiscard]] Index index_of(Vertex v) const { return v; }
    [[nodiscard]] auto all_vertices() const { return index_range(facts_.vertex_count); }
    [[nodiscard]] bool strictly_convex() const { return facts_.strictly_convex; }
    [[nodiscard]] double reach() const { return facts_.reach; }
    [[nodiscard]] const BodyFacts& facts() const { return facts_; }
    [[nodiscard]] Ledger ledger() const { return block_.ledger(); }
    [[nodiscard]] std::vector<Piece> pieces() const { return block_.pieces(); }

    /// The facts of a body of the same topology (write_geometry.hpp).
    void note_facts(const Polyhedron& body) {
        facts_ = BodyFacts(body, parts_, Tolerance<Strictness>::strict_turn);
    }

  protected:
    template <Precision, class, class>
    friend class BlockTable;

    explicit BlockTable(Loader loader) : loader_(loader) {}

    /// The same memory seen through another loader.
    template <class OtherLoader>
    BlockTable(const BlockTable<P, OtherLoader, Strictness>& other, Loader loader)
        : loader_(loader), block_(other.block_), facts_(other.facts_), parts_(other.parts_) {}

    /// Allocates what was planned. To be called once, before anything is filled.
    void allocate(BlockPlan plan, const Polyhedron& body, Parts parts) {
        block_ = Block(std::move(plan));
        parts_ = parts;
        note_facts(body);
    }

    template <class Value>
    const Value& load(const Value& location, Field field) const {
        return loader_.load(location, field);
    }

    [[no_unique_address]] Loader loader_;
    Block block_;
    BodyFacts facts_;
    Parts parts_ = Parts::support;
};

}  // namespace edgewise
