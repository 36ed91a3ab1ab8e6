// SPDX-License-Identifier: MIT
//
// Figures about the work of queries as Callgrind counts it and traces tell it (studies/effort.hpp): of our
// table types and of other libraries, per query over all queries, per step, and over a floor.
#pragma once

#include "edgewise/store/vocabulary/figure_info.hpp"

namespace edgewise::store::vocabulary {

// One figure a line.
// clang-format off
inline constexpr FigureInfo effort[] = {
    {"effort.instructions", "1", Population::all, Repeats::timed, "instructions per query, counted by Callgrind as a difference of passes"},
    {"effort.mispredictions", "1", Population::all, Repeats::timed, "mispredicted branches per query, modelled by Callgrind's branch simulation"},
    {"effort.{machine}.d1_misses", "1", Population::all, Repeats::timed, "data misses per query of the machine's first level, modelled by Callgrind"},
    {"effort.{machine}.ll_misses", "1", Population::all, Repeats::timed, "data misses per query of its second level, modelled by Callgrind as the last"},
    {"effort.steps", "steps", Population::all, Repeats::exactly, "V-Clip states or GJK iterations per query"},
    {"effort.supports", "1", Population::all, Repeats::exactly, "of GJK: searches of a support point per query"},
    {"effort.vertices_read", "1", Population::all, Repeats::exactly, "vertices read per query: of GJK one dot product each"},
    {"effort.lines_read", "lines", Population::all, Repeats::exactly, "distinct lines of the two tables that a query reads"},
    {"effort.instructions_per_step", "1", Population::all, Repeats::timed, "instructions divided by steps"},
    {"effort.mispredictions_per_step", "1", Population::all, Repeats::timed, "modelled mispredictions divided by steps"},
    {"effort.vertices_per_step", "1", Population::all, Repeats::exactly, "vertices read divided by steps"},
    {"effort.floor_vertices", "1", Population::all, Repeats::exactly, "vertices that a proof of the known answer by heights of vertices reads"},
    {"effort.floor_flops", "1", Population::all, Repeats::exactly, "floating-point operations of that proof"},
    {"effort.floor_lines", "lines", Population::all, Repeats::exactly, "fewest lines that the coordinates of its vertices fill"},
    {"effort.instructions_over_floor", "1", Population::all, Repeats::timed, "instructions divided by the operations of that proof"},
    {"effort.vertices_over_floor", "1", Population::all, Repeats::exactly, "vertices read divided by those of that proof"},
    {"effort.lines_over_floor", "1", Population::all, Repeats::exactly, "lines read divided by those of that proof"},
};
// clang-format on

}  // namespace edgewise::store::vocabulary
