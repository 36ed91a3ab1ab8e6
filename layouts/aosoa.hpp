// SPDX-License-Identifier: MIT
//
// Array of structures of arrays, in blocks. A block has one edge for each scalar of a cache line, 8 in
// double and 16 in single. In a block, scalar k of all its edges is one row, and a row of scalars is
// one 64-byte line (of indices, half a line in double): scalar k of edge e is block[e /
// lanes].row[k][e % lanes]. A pass over all edges reads whole lines as with `soa`, yet the twenty
// scalars of one edge lie in one place of 20 lines, not in twenty places. Vertices, faces and the
// edges' ends lie in blocks as well. The bytes are those of `soa`; only the lanes that the last block
// does not fill are padding.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string_view>

#include "edgewise/layout_parts/stored_table.hpp"

namespace edgewise {

/// A block with `Rows` scalars for each element; it holds one element for each `Stored` of a cache line.
template <class Stored, class Scalar, std::size_t Rows>
struct LaneBlock {
    static constexpr std::size_t lanes = BlockPlan::alignment / sizeof(Stored);

    Scalar row[Rows][lanes];

    /// Scalars of the element in this lane, from row `first` on.
    [[nodiscard]] Strided<Scalar> from(std::size_t first, std::size_t lane) {
        return {&row[first][lane], lanes};
    }
};

/// The edges of one block: planes in the order tail, head, left, right; ends likewise.
template <class Stored>
struct EdgeBlock {
    LaneBlock<Stored, Stored, 16> planes;
    LaneBlock<Stored, Stored, 4> geometry;
    LaneBlock<Stored, Index, 4> ends;
};

template <class Stored>
struct AosoaArrays {
    using Points = LaneBlock<Stored, Stored, 3>;
    using Planes = LaneBlock<Stored, Stored, 4>;
    using Edges = EdgeBlock<Stored>;
    static constexpr std::size_t lanes = Points::lanes;
    static_assert(sizeof(Edges) % BlockPlan::alignment == 0);

    Points* vertices = nullptr;
    Edges* edges = nullptr;
    Planes* faces = nullptr;

    void place(BlockPlan& plan, const BodyFacts& n) {
        place_blocks(plan, vertices, n.vertex_count, {{Component::vertex_coordinates, 3, sizeof(Stored)}});
        place_blocks(plan, edges, n.edge_count(),
                     {{Component::voronoi_planes, 16, sizeof(Stored)},
                      {Component::edge_geometry, 4, sizeof(Stored)},
                      {Component::topology, 4, sizeof(Index)}});
        place_blocks(plan, faces, n.face_count, {{Component::face_planes, 4, sizeof(Stored)}});
    }

    [[nodiscard]] auto vertex(Index v) const { return vertices[v / lanes].from(0, v % lanes); }
    [[nodiscard]] auto vertex_edge_plane(Index e, End end) const {
        return edges[e / lanes].planes.from(4 * static_cast<std::size_t>(end), e % lanes);
    }
    [[nodiscard]] auto edge_face_plane(Index e, Side side) const {
        return edges[e / lanes].planes.from(8 + 4 * static_cast<std::size_t>(side), e % lanes);
    }
    [[nodiscard]] auto direction(Index e) const { return edges[e / lanes].geometry.from(0, e % lanes); }
    [[nodiscard]] auto& length(Index e) const { return edges[e / lanes].geometry.row[3][e % lanes]; }
    [[nodiscard]] auto ends(Index e) const { return edges[e / lanes].ends.from(0, e % lanes); }
    [[nodiscard]] auto face_plane(Index f) const { return faces[f / lanes].from(0, f % lanes); }

  private:
    /// Rows of one kind in a block.
    struct Rows {
        Component component;
        std::size_t count, scalar;
    };

    /// Places elements in blocks; a last block that is not full goes row by row: its free lanes are padding.
    /// Blocks are whole lines, so it follows the other blocks without a gap.
    template <class Element>
    static void place_blocks(BlockPlan& plan, Element*& to, std::size_t count,
                             std::initializer_list<Rows> kinds) {
        Shares shares;
        for (const Rows& rows : kinds) shares.add({rows.component, rows.count * rows.scalar * lanes});
        plan.array(to, count / lanes, shares);
        const std::size_t rest = count % lanes;
        if (rest == 0) return;
        for (const Rows& rows : kinds) {
            for (std::size_t k = 0; k < rows.count; ++k)
                plan.append(rows.scalar * lanes, {{rows.component, rows.scalar * rest}});
        }
    }
};

template <Precision P, class Loader = Direct>
class aosoa : public StoredTable<AosoaArrays<typename P::Stored>, P, Loader> {
    using Base = StoredTable<AosoaArrays<typename P::Stored>, P, Loader>;

  public:
    static constexpr std::string_view name = "aosoa";
    static constexpr std::string_view stores =
        "blocks of edges, a cache line per scalar: 8 in f64, 16 in f32";

    using Base::Base;
};

}  // namespace edgewise
