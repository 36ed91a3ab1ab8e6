// SPDX-License-Identifier: MIT
//
// What layouts have in common that keep a body in one block of memory: the block, the body's facts, and the
// loader. A layout derives from it, or from one of its derived classes (StoredTable, DerivedTable), and adds
// what is its own: how vertices, edges and planes are stored and read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "edgewise/geometry/polyhedron.hpp"
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
    static constexpr bool counts_vertices = true;

    [[nodiscard]] std::size_t vertex_count() const { return facts_.vertex_count; }
    [[nodiscard]] Vertex first_vertex() const { return 0; }
    [[nodiscard]] Index index_of(Vertex v) const { return v; }
    [[nodiscard]] auto all_vertices() const { return index_range(facts_.vertex_count); }
    [[nodiscard]] bool strictly_convex() const { return facts_.strictly_convex; }
    [[nodiscard]] bool climbable() const { return facts_.climbable; }
    [[nodiscard]] double reach() const { return facts_.reach; }
    [[nodiscard]] std::uint32_t identity() const { return facts_.identity; }
    [[nodiscard]] const BodyFacts& facts() const { return facts_; }

    /// The facts of a body of the same topology (write_geometry.hpp).
    void note_facts(const Polyhedron& body) {
        facts_ = facts_.refitted(body, Tolerance<Strictness>::strict_turn);
    }

  protected:
    template <Precision, class, class>
    friend class BlockTable;

    BlockTable(const Polyhedron& body, Parts parts, Loader loader)
        : loader_(loader), facts_(body, parts, Tolerance<Strictness>::strict_turn) {}

    /// The same memory seen through another loader: a view, which must not outlive the table.
    template <class OtherLoader>
    BlockTable(const BlockTable<P, OtherLoader, Strictness>& other, Loader loader)
        : loader_(loader), block_(other.block_.view()), facts_(other.facts_) {}

    /// The block of these arrays, each of which names what it holds by place(plan, facts).
    template <class... Arrays>
    void make_block(Arrays&... arrays) {
        block_ = Block([&](BlockPlan& plan) { (arrays.place(plan, facts_), ...); });
    }
    /// Of such a block, as they lie there.
    template <class... Arrays>
    [[nodiscard]] std::vector<Piece> pieces_of(Arrays... nowhere) const {
        BlockPlan plan;
        (nowhere.place(plan, facts_), ...);
        return plan.pieces(block_.base());
    }

    template <class Value>
    const Value& load(const Value& location, Field field) const {
        return loader_.load(location, field);
    }

    [[no_unique_address]] Loader loader_;
    Block block_;
    /// So that what a layout adds may begin in the padding at its end.
    [[no_unique_address]] BodyFacts facts_;
};

}  // namespace edgewise
