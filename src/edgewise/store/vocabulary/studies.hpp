// SPDX-License-Identifier: MIT
//
// Figures about the work of queries as Callgrind counts it and traces tell it (studies/effort/effort.hpp): of
// our table types and of other libraries, per query over all queries, per step, and over a floor.
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

// Figures about what could have made the paper's figure 8 (studies/thrash): a row of the factorial sums over
// bodies, memory and the cost of a fault; a row of a realised cell has one point for each speed.
inline constexpr FigureInfo thrash[] = {
    {"thrash.settings", "settings", Population::none, Repeats::exactly, "combinations of bodies, memory and cost of a fault that were scored"},
    {"thrash.settings_with.{fact}", "settings", Population::all, Repeats::timed, "of them, those where this fact of figure 8 holds (a model; builds are measured)"},
    {"thrash.settings_with_all", "settings", Population::all, Repeats::timed, "those where all four facts hold"},
    {"thrash.facts.{setting}", "1", Population::all, Repeats::timed, "facts that hold with BODIES_MIB_COSTns: 1 rises, 2 takes as long, 4 spares GJK, 8 erratic, added"},
    {"thrash.best_facts", "1", Population::all, Repeats::timed, "the most facts that hold at once"},
    {"thrash.best.bodies", "bodies", Population::none, Repeats::timed, "of the setting with most facts whose rise is nearest to 12"},
    {"thrash.best.memory_bytes", "B", Population::none, Repeats::timed, "likewise"},
    {"thrash.best.fault_ns", "ns", Population::none, Repeats::timed, "likewise"},
    {"thrash.best.rise", "1", Population::all, Repeats::timed, "there: V-Clip's longest time at 386 vertices over that at 38"},
    {"thrash.best.top_us", "us", Population::all, Repeats::timed, "there: V-Clip's longest time at 386 vertices"},
    {"thrash.best.gjk_rise", "1", Population::all, Repeats::timed, "there: GJK's longest time at 386 vertices over that at 38"},
    {"thrash.best.fall", "1", Population::all, Repeats::timed, "there: the largest fall of V-Clip's time at 386 vertices as speed grows"},
    {"thrash.ns_per_read", "ns", Population::all, Repeats::exactly, "of the processor, such that figures 4, 6 and 7 are met on average"},
    {"thrash.calibrated.{figure}", "1", Population::all, Repeats::exactly, "the model over the top of that figure's axis"},
    {"thrash.predicted_us.{speed}", "us", Population::all, Repeats::timed, "time per query at so many rad per second: without the pager, and the faults of the same policy on a trace"},
    {"thrash.measured_us.{speed}", "us", Population::all, Repeats::timed, "time per query under the pager"},
    {"thrash.model_us.{speed}", "us", Population::all, Repeats::exactly, "time per query that the factorial has there, on a processor of the time"},
    {"thrash.in_memory_us.{speed}", "us", Population::all, Repeats::timed, "time per query without the pager"},
    {"thrash.predicted_faults.{speed}", "faults", Population::all, Repeats::exactly, "hard faults per query of the policy on a trace"},
    {"thrash.measured_faults.{speed}", "faults", Population::all, Repeats::timed, "hard faults per query that the pager served"},
    {"thrash.queries.{speed}", "queries", Population::all, Repeats::exactly, "that the times are means of"},
};
// clang-format on

}  // namespace edgewise::store::vocabulary
