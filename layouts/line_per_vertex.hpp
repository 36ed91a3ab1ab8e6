// SPDX-License-Identifier: MIT
//
// One cache line of 64 bytes per vertex: its coordinates, its number of neighbours, and their indices: 9 in
// double, 12 in single. A climb that reaches a vertex has both on the line that it read to get there.
// Greer proposed it (arXiv 2509.03753, 2025) and reports support queries up to five times as fast; the idea
// and the size come from that paper, the fields are ours. For GJK only: no plane is stored, and none derived.
//
// The price: 21.4 bytes per edge in double and in single, and a scan reads a line per vertex. If a vertex has
// more neighbours than fit, the last index of its line is the start of the rest, in an array behind the
// lines.
#pragma once

#include <cassert>
#include <cstddef>
#include <string_view>
#include <vector>

#include "edgewise/layout_parts/block_table.hpp"

namespace edgewise {

/// A vertex and its neighbours, in ring order.
template <class Stored>
struct VertexLine {
    static constexpr std::size_t room =
        (BlockPlan::alignment - sizeof(Vec3<Stored>) - sizeof(Index)) / sizeof(Index);

    alignas(BlockPlan::alignment) Vec3<Stored> point;
    Index degree;
    Index neighbour[room];  ///< if there are more neighbours, the last index is the start of the rest

    /// Number of neighbours on the line, of a vertex with `degree` neighbours.
    [[nodiscard]] static Index here(Index degree) {
        return degree <= room ? degree : static_cast<Index>(room - 1);
    }
};

template <Precision P, class Loader = Direct>
class line_per_vertex : public BlockTable<P, Loader> {
    using Base = BlockTable<P, Loader>;
    using Base::block_, Base::facts_, Base::load;

  public:
    using typename Base::Compute, typename Base::Stored, typename Base::Vertex;

    static constexpr std::string_view name = "line_per_vertex";
    static constexpr std::string_view stores =
        "a 64-byte line per vertex: coordinates and neighbours (arXiv 2509.03753)";
    static constexpr std::string_view derives = "nothing";

    /// Both kinds of parts are the same here: nothing can be left out.
    line_per_vertex(const Polyhedron& body, Parts parts, Loader loader = {}) : Base(body, parts, loader) {
        const auto degree_of = [&](Index v) { return static_cast<Index>(body.ring_of_vertex(v).size()); };
        block_ = Block([&](BlockPlan& plan) { place(plan, degree_of); });
        Index beyond = 0;
        for (Index v = 0; v < facts_.vertex_count; ++v) {
            Line& to = line(v);
            to.degree = degree_of(v);
            const Index here = Line::here(to.degree);
            if (here < to.degree) to.neighbour[here] = beyond;
            for (Index i = 0; i < to.degree; ++i)
                (i < here ? to.neighbour[i] : others()[beyond++]) = body.head(body.ring_of_vertex(v)[i]);
        }
        write_geometry(*this, body);
    }

    template <class OtherLoader>
    line_per_vertex(const line_per_vertex<P, OtherLoader>& other, Loader loader) : Base(other, loader) {}

    [[nodiscard]] std::vector<Piece> pieces() const {
        BlockPlan plan;
        place(plan, [this](Index v) { return line(v).degree; });
        return plan.pieces(block_.base());
    }
    [[nodiscard]] Ledger ledger() const { return ledger_of(pieces()); }

    void write_vertex(Index v, const Vec3d& point) { line(v).point = cast<Stored>(point); }

    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const {
        return cast<Compute>(load(line(v).point, Field::vertex));
    }
    [[nodiscard]] auto neighbours(Vertex v) const {
        const Line& from = line(v);
        const Index degree = load(from.degree, Field::neighbour), here = Line::here(degree);
        const Index* const rest =
            here < degree ? others() + load(from.neighbour[here], Field::neighbour) - here : nullptr;
        return IndexedRing(0, degree, [this, on_line = from.neighbour, rest, here](Index i) {
            return load((i < here ? on_line : rest)[i], Field::neighbour);
        });
    }

  private:
    template <Precision, class>
    friend class line_per_vertex;

    using Line = VertexLine<Stored>;
    static_assert(sizeof(Line) == BlockPlan::alignment);

    /// degree_of(v): number of neighbours of each vertex of the body.
    template <class DegreeOf>
    void place(BlockPlan& plan, const DegreeOf& degree_of) const {
        std::size_t beyond = 0;
        for (Index v = 0; v < facts_.vertex_count; ++v) {
            const Index degree = degree_of(v), here = Line::here(degree);
            const std::size_t indices = std::size_t{here} + (here < degree ? 1 : 0);
            beyond += degree - here;
            plan.append(sizeof(Line), {{Component::vertex_coordinates, sizeof(Vec3<Stored>)},
                                       {Component::topology, (1 + indices) * sizeof(Index)}});
        }
        Index* nowhere = nullptr;
        plan.array(nowhere, beyond, {{Component::topology, sizeof(Index)}});
    }

    [[nodiscard]] Line& line(Index v) const {
        assert(v < facts_.vertex_count);
        return reinterpret_cast<Line*>(block_.base())[v];
    }
    /// Array of the neighbours that are on no line.
    [[nodiscard]] Index* others() const {
        return reinterpret_cast<Index*>(block_.base() + sizeof(Line) * facts_.vertex_count);
    }
};

}  // namespace edgewise
