// SPDX-License-Identifier: MIT
//
// The table of `hot_cold`, with the planes, direction and length of an edge made when a query first asks for
// one of them. A scene that visits few edges pays only for these, in time and in touched pages of memory,
// since planes are separate from what every edge has. Vertices, face planes and topology are made at the
// start. Answers are those of the layout itself, bit by bit.
//
// The price: a bit per edge, read before every plane; the canonical body must live as long as the table,
// since planes are made from it (it is the application's, and not counted in the table's bytes); and
// queries write, so one table serves one thread at a time (table/contract.hpp), and query_batch_parallel
// refuses it.
#pragma once

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "edgewise/layouts/hot_cold.hpp"

namespace edgewise {

/// Table: any StoredTable. Its arrays are a handle of writable memory, through which queries make edges.
template <class Table, class Loader>
class Lazy : public Table {
  public:
    using typename Table::Compute, typename Table::Edge;

    static constexpr std::string_view name = "lazy";
    static constexpr std::string_view stores =
        "as hot_cold, an edge's planes from when they are first asked for; the body must stay at hand";
    static constexpr std::string_view derives = "an edge's planes, once";
    static constexpr bool queries_write = true;

    /// Borrows the body, which must outlive the table; a temporary one does not compile.
    Lazy(const Polyhedron& body, Parts parts, Loader loader = {})
        : Table(body, parts, loader, WriteEdges::when_asked),
          bits_([this](BlockPlan& plan) { place(plan, words_); }),
          body_(&body) {
        std::fill_n(words_, word_count(), Word{0});
    }
    Lazy(const Polyhedron&&, Parts, Loader = {}) = delete;
    /// A view of the same memory with another loader: an edge that either of them makes exists for both.
    template <class OtherTable, class OtherLoader>
    Lazy(const Lazy<OtherTable, OtherLoader>& other, Loader loader)
        : Table(other, loader), words_(other.words_), bits_(other.bits_.view()), body_(other.body_) {}

    [[nodiscard]] Vec3<Compute> direction(Edge e) const {
        make(e);
        return Table::direction(e);
    }
    [[nodiscard]] Plane<Compute> vertex_edge_plane(Edge e, End end) const {
        make(e);
        return Table::vertex_edge_plane(e, end);
    }
    [[nodiscard]] Plane<Compute> edge_face_plane(Edge e, Side side) const {
        make(e);
        return Table::edge_face_plane(e, side);
    }

    /// A layout's own ring functions would read planes that are not made yet.
    template <class... Any>
    void most_violated_vertex_plane(const Any&...) const = delete;
    template <class... Any>
    void most_violated_face_side(const Any&...) const = delete;
    template <class... Any>
    void steepest_descent(const Any&...) const = delete;

    /// Number of edges made so far, by all views of this table.
    [[nodiscard]] std::size_t made() const {
        std::size_t sum = 0;
        for (std::size_t i = 0; i < word_count(); ++i)
            sum += static_cast<std::size_t>(std::popcount(words_[i]));
        return sum;
    }
    /// Part of the table's bytes that is made: all except planes and geometry of the edges not made.
    [[nodiscard]] double materialised() const {
        const Ledger all = ledger();
        const std::size_t of_edges = all[Component::voronoi_planes] + all[Component::edge_geometry];
        if (of_edges == 0) return 1;
        const double missing =
            static_cast<double>(of_edges) *
            (1 - static_cast<double>(made()) / static_cast<double>(this->facts_.edge_count()));
        return 1 - missing / static_cast<double>(all.total());
    }

    [[nodiscard]] std::vector<Piece> pieces() const {
        BlockPlan plan;
        Word* words = nullptr;
        place(plan, words);
        std::vector<Piece> all = Table::pieces();
        for (const Piece& piece : plan.pieces(bits_.base())) all.push_back(piece);
        return all;
    }
    [[nodiscard]] Ledger ledger() const { return ledger_of(pieces()); }

    /// Takes another body, which must outlive the table; no edge is made yet.
    void write_body(const Polyhedron&&) = delete;
    void write_body(const Polyhedron& body) {
        write_geometry(static_cast<Table&>(*this), body, WriteEdges::when_asked);
        body_ = &body;
        std::fill_n(words_, word_count(), Word{0});
    }

  private:
    template <class, class>
    friend class Lazy;

    using Word = std::uint64_t;
    static constexpr Index word_bits = 64;

    [[nodiscard]] std::size_t word_count() const { return this->facts_.edge_count() / word_bits + 1; }
    void place(BlockPlan& plan, Word*& words) const {
        plan.array(words, word_count(), {{Component::topology, sizeof(Word)}});
    }

    void make(Edge e) const {
        assert(e < this->facts_.edge_count());
        Word& word = words_[e / word_bits];
        const Word bit = Word{1} << (e % word_bits);
        if ((this->loader_.load(word, Field::edge_made) & bit) != 0) return;
        word |= bit;
        store_edge(this->at_, e, edge_geometry(*body_, e));
    }

    Word* words_ = nullptr;  // a bit per edge
    Block bits_;
    const Polyhedron* body_;
};

template <Precision P, class Loader = Direct>
using lazy = Lazy<StoredTable<HotColdArrays<typename P::Stored>, P, Loader>, Loader>;

}  // namespace edgewise
