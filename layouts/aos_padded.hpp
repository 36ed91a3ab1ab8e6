// SPDX-License-Identifier: MIT
//
// The record of `aos` in three parts that never straddle a cache line: the vertex-edge planes; ends,
// direction and length; the edge-face planes. Each part starts at a multiple of the size of two planes: 64
// bytes in double, where the middle part needs 16 bytes of padding, and 32 in single, where it needs none. So
// queries read fewer lines, although the table is larger.
//
// Mean number of 64-byte lines that are touched, over all records of an array. `mean_lines` below computes it
// for contiguous pieces, and static assertions check some of the figures with it:
//
//                                    a plane   ends and    vertex-edge planes   all planes
//                                              direction   and ends             and ends
//     double, 176 bytes as in aos    1.25      1.50        2.75                 3.50
//     double, 176, order as here     1.25      1.50        2.00                 3.50
//     double, 192, order as here     1.00      1.00        2.00                 3.00        chosen
//     double, 256, order as here     1.00      1.00        2.00                 3.00
//     single,  96 bytes as in aos    1.00      1.00        2.00                 2.00
//     single,  96, order as here     1.00      1.00        1.50                 2.00        chosen
//     single, 128, order as here     1.00      1.00        1.00                 2.00
//
// Ring tests read a plane of each edge; V-F reads directions, E-F ends and direction; V-E and E-E read the
// vertex-edge planes, ends, and the rest if these decide nothing. In single, padding reduces lines only where
// a test ends at its vertex-edge planes, and would add a third to the bytes: the record keeps its natural
// size, and all of the gain comes from the order.
//
// Per edge 192 bytes in double instead of 176; 96 in single.
#pragma once

#include <cstddef>
#include <string_view>

#include "edgewise/layouts/aos.hpp"

namespace edgewise {

/// The record of one edge.
template <class Stored>
struct PaddedRecord {
    static constexpr std::size_t part = 2 * sizeof(Plane<Stored>);
    static constexpr std::size_t middle = 4 * sizeof(Index) + 4 * sizeof(Stored);

    alignas(part) Plane<Stored> vertex_edge[2];  // by End
    alignas(part) PolyhedronEdge ends;
    Vec3<Stored> direction;
    Stored length;
    alignas(part) Plane<Stored> edge_face[2];  // by Side

    static Shares shares() {
        return {{Component::voronoi_planes, part},
                {Component::topology, 4 * sizeof(Index)},
                {Component::edge_geometry, 4 * sizeof(Stored)},
                {Component::padding, part - middle},
                {Component::voronoi_planes, part}};
    }
};

/// Lines touched by bytes from .. from + bytes of a record, averaged over an array of records of this size.
[[nodiscard]] constexpr double mean_lines(std::size_t record, std::size_t from, std::size_t bytes) {
    constexpr std::size_t line = BlockPlan::alignment;
    std::size_t lines = 0;
    for (std::size_t i = 0; i < line; ++i) {  // offsets within lines repeat from here on
        const std::size_t start = i * record + from;
        lines += (start + bytes - 1) / line - start / line + 1;
    }
    return static_cast<double>(lines) / line;
}

static_assert(sizeof(PaddedRecord<double>) == 192 && sizeof(PaddedRecord<float>) == 96);
static_assert(mean_lines(176, 0, 32) == 1.25 && mean_lines(192, 0, 32) == 1);  // a plane in double
static_assert(mean_lines(176, 0, 80) == 2 && mean_lines(192, 0, 80) == 2);     // vertex-edge planes, ends
static_assert(mean_lines(176, 0, 176) == 3.5 && mean_lines(192, 0, 192) == 3);
static_assert(mean_lines(96, 0, 16) == 1 && mean_lines(128, 0, 16) == 1);  // in single
static_assert(mean_lines(96, 0, 48) == 1.5 && mean_lines(128, 0, 48) == 1);
static_assert(mean_lines(96, 0, 96) == 2 && mean_lines(128, 0, 96) == 2);

template <Precision P, class Loader = Direct>
class aos_padded
    : public StoredTable<AosArrays<typename P::Stored, PaddedRecord<typename P::Stored>>, P, Loader> {
    using Base = StoredTable<AosArrays<typename P::Stored, PaddedRecord<typename P::Stored>>, P, Loader>;

  public:
    static constexpr std::string_view name = "aos_padded";
    static constexpr std::string_view stores = "the struct of aos in three parts, each within a cache line";

    using Base::Base;
};

}  // namespace edgewise
