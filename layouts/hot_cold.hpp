// SPDX-License-Identifier: MIT
//
// The record of `aos`, split in two. Hot: the four Voronoi planes, which V-Clip's tests read edge after edge
// along a ring. Cold: ends, direction and length. The split makes the hot record a round number of cache
// lines (128 bytes in double, two lines; 64 in single, one), so that no plane straddles two of them and a
// ring brings in planes and nothing else.
//
// Why direction is cold: rings of planes never need it. A vertex over a face (V-F) asks for the slopes of all
// edges at the vertex, and takes directions without planes; an edge over a face (E-F) asks for the slope of
// the edge whose ends it has just read. Only E-E reads it of an edge whose planes it tests, and only where
// the other edge is clipped by a face. Beside the planes it would spoil their alignment. Ends are cold for
// that reason alone: V-E, E-E and E-F read them of one edge a body in every test. Nothing reads the length;
// it is kept so that the two records hold the scalars of `aos`.
//
// Per edge 128 + 48 bytes in double, 64 + 32 in single: those of `aos`, to the byte.
#pragma once

#include "edgewise/layout_parts/hot_cold_table.hpp"

namespace edgewise {

template <Precision P, class Loader = Direct>
class hot_cold : public HotColdTable<P, Loader> {
    using Base = HotColdTable<P, Loader>;

  public:
    static constexpr std::string_view name = "hot_cold";
    static constexpr std::string_view stores =
        "two structs an edge: four Voronoi planes; and apart from them ends, direction, length";
    static constexpr std::string_view derives = "nothing";

    hot_cold(const Polyhedron& body, Parts parts, Loader loader = {}, WriteEdges write = WriteEdges::now)
        : Base(body, parts, loader, write) {}

    /// The same memory seen through another loader.
    template <class OtherLoader>
    hot_cold(const hot_cold<P, OtherLoader>& other, Loader loader) : Base(other, loader) {}
};

}  // namespace edgewise
