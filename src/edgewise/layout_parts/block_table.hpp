// SPDX-License-Identifier: MIT
//
// Common base of layouts that keep a body in one block of memory: the block, the body's facts, and the
// loader. A layout derives from one of its derived classes (PlacedTable, StoredTable, DerivedTable), and adds
// how it stores and reads vertices, edges and planes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/layout_parts/block.hpp"
#include "edgewise/layout_parts/write_geometry.hpp"
#include "edgewise/table/body_facts.hpp"
#include "edgewise/table/contract.hpp"
#include "edgewise/table/loader.hpp"

namespace edgewise {

/// Strictness: the scalar that decides by its rounding what is strictly convex. It is the scalar of the
/// stored planes, or the one that computes where planes are derived.
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

    /// Takes over the facts of a body of the same topology (write_geometry.hpp).
    void note_facts(const Polyhedron& body) {
        facts_ = facts_.refitted(body, Tolerance<Strictness>::strict_turn);
    }

  protected:
    template <Precision, class, class>
    friend class BlockTable;

    BlockTable(const Polyhedron& body, Parts parts, Loader loader)
        : loader_(loader), facts_(body, parts, Tolerance<Strictness>::strict_turn) {}

    /// A view of the same memory with another loader; it must not outlive the table.
    template <class OtherLoader>
    BlockTable(const BlockTable<P, OtherLoader, Strictness>& other, Loader loader)
        : loader_(loader), block_(other.block_.view()), facts_(other.facts_) {}

    /// Makes the block of all arrays; each names its parts by place(plan, facts).
    template <class... Arrays>
    void make_block(Arrays&... arrays) {
        block_ = Block([&](BlockPlan& plan) { (arrays.place(plan, facts_), ...); });
    }
    /// Pieces of the block of all arrays, in memory order.
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
    /// Last, so that members of a layout may begin in the padding at its end.
    [[no_unique_address]] BodyFacts facts_;
};

/// The shell of a table with arrays of its own: Places names them by place(plan, facts), and holds the start
/// of each in bytes from the block's start. A layout derives from it, inherits the constructor of a view, and
/// writes the arrays in its own constructor.
template <class Places, Precision P, class Loader>
class PlacedTable : public BlockTable<P, Loader> {
    using Base = BlockTable<P, Loader>;

  public:
    template <class OtherLoader>
    PlacedTable(const PlacedTable<Places, P, OtherLoader>& other, Loader loader)
        : Base(other, loader), places_(other.places_) {}

    [[nodiscard]] std::vector<Piece> pieces() const { return this->pieces_of(Places()); }
    [[nodiscard]] Ledger ledger() const { return ledger_of(pieces()); }

  protected:
    template <class, Precision, class>
    friend class PlacedTable;

    PlacedTable(const Polyhedron& body, Parts parts, Loader loader) : Base(body, parts, loader) {
        this->make_block(places_);
    }

    /// Elements of the array that starts there.
    template <class Element>
    [[nodiscard]] Element* array(std::uint32_t at) const {
        return reinterpret_cast<Element*>(this->block_.base() + at);
    }

    Places places_;
};

/// A table with the canonical body's numbers as handles of its edges and faces.
template <class Table>
class WithNumberedFeatures : public Table {
  public:
    using Edge = Index;
    using Face = Index;

    static constexpr Face no_face = edgewise::no_face;

    using Table::Table;

    [[nodiscard]] auto all_faces() const { return index_range(this->facts_.face_count); }
    [[nodiscard]] std::uint32_t edge_name(Edge e) const { return e; }
    [[nodiscard]] std::uint32_t face_name(Face f) const { return f; }
    [[nodiscard]] std::optional<Edge> edge_named(std::uint32_t name) const {
        return name < this->facts_.edge_count() ? std::optional<Edge>(name) : std::nullopt;
    }
    [[nodiscard]] std::optional<Face> face_named(std::uint32_t name) const {
        return name < this->facts_.face_count ? std::optional<Face>(name) : std::nullopt;
    }
};

}  // namespace edgewise
