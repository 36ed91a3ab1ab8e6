// SPDX-License-Identifier: MIT
//
// A storing layout whose Voronoi planes, directions and lengths are made when an edge is first asked for one
// of them: a scene that walks over few edges pays for few, in time and in pages of memory touched. Vertices,
// face planes and topology stand from the start. Answers are those of the layout itself, bit by bit.
//
// The price: a bit an edge, read before every plane; the canonical body must live as long as the table, since
// planes are made from it (it is the application's, and not counted in the table's bytes); and queries write,
// so one table serves one thread at a time.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>

#include "edgewise/layout_parts/block_table.hpp"

namespace edgewise {

/// What all views of a lazy table share.
struct LazyState {
    const Polyhedron* body = nullptr;
    std::size_t made = 0;  ///< edges
};

/// Table: a layout with write_edge and handles that are the body's edge numbers.
template <class Table, class Loader>
class Lazy : public Table {
  public:
    using typename Table::Compute;
    using typename Table::Edge;

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

    /// A layout's own answers to ring questions would read planes that are not there yet.
    template <class... Any>
    void most_violated_vertex_plane(const Any&...) const = delete;
    template <class... Any>
    void most_violated_face_side(const Any&...) const = delete;
    template <class... Any>
    void steepest_descent(const Any&...) const = delete;

    /// Edges made so far, of all views of this table.
    [[nodiscard]] std::size_t made() const { return state_->made; }
    /// The part of the table's bytes that stands: all but the planes and the geometry of edges not made.
    [[nodiscard]] double materialised() const {
        const Ledger all = ledger();
        const std::size_t of_edges = all[Component::voronoi_planes] + all[Component::edge_geometry];
        if (of_edges == 0) return 1;
        const double missing =
            static_cast<double>(of_edges) *
            (1 - static_cast<double>(made()) / static_cast<double>(this->facts_.edge_count));
        return 1 - missing / static_cast<double>(all.total());
    }

    [[nodiscard]] Ledger ledger() const {
        Ledger sum = Table::ledger();
        for (const Piece& piece : bits_.pieces()) piece.add_to(sum);
        return sum;
    }
    [[nodiscard]] std::vector<Piece> pieces() const {
        std::vector<Piece> all = Table::pieces();
        for (const Piece& piece : bits_.pieces()) all.push_back(piece);
        return all;
    }

    /// Of another body, which must live on, nothing is made yet.
    void write_body(const Polyhedron& body) {
        write_geometry(static_cast<Table&>(*this), body, WriteEdges::when_asked);
        state_->body = &body;
        state_->made = 0;
        std::fill_n(words_, word_count(), Word{0});
    }

  protected:
    template <class, class>
    friend class Lazy;

    /// Keeps a reference to the body.
    Lazy(const Polyhedron& body, Parts parts, Loader loader)
        : Table(body, parts, loader, WriteEdges::when_asked), state_(std::make_shared<LazyState>()) {
        BlockPlan plan;
        const auto words = plan.array<Word>(word_count(), {{Component::topology, sizeof(Word)}});
        bits_ = Block(std::move(plan));
        words_ = bits_.fill(words, [](Index) { return Word{0}; });
        state_->body = &body;
    }
    template <class OtherTable, class OtherLoader>
    Lazy(const Lazy<OtherTable, OtherLoader>& other, Loader loader)
        : Table(other, loader), bits_(other.bits_), words_(other.words_), state_(other.state_) {}

  private:
    using Word = std::uint64_t;
    static constexpr Index word_bits = 64;

    [[nodiscard]] std::size_t word_count() const { return this->facts_.edge_count / word_bits + 1; }

    void make(Index e) const {
        Word& word = words_[e / word_bits];
        const Word bit = Word{1} << (e % word_bits);
        if ((this->loader_.load(word, Field::edge_made) & bit) != 0) return;
        word |= bit;
        ++state_->made;
        // Views share the memory: what one makes is there for all.
        const_cast<Lazy&>(*this).write_edge(e, edge_geometry(*state_->body, e));
    }

    Block bits_;
    Word* words_ = nullptr;
    std::shared_ptr<LazyState> state_;
};

}  // namespace edgewise
