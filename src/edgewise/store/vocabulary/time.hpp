// SPDX-License-Identifier: MIT
//
// Figures about time: what queries, tables and steps of a scene cost, and what the processor counted of it.
#pragma once

#include "edgewise/store/vocabulary/figure_info.hpp"

namespace edgewise::store::vocabulary {

// One figure a line.
// clang-format off
inline constexpr FigureInfo time[] = {
    {"counters.instructions", "1", Population::all, Repeats::timed, "instructions per query, in the steady state"},
    {"counters.cycles", "1", Population::all, Repeats::timed, "core cycles per query"},
    {"counters.branches", "1", Population::all, Repeats::timed, "branches per query"},
    {"counters.branch_misses", "1", Population::all, Repeats::timed, "mispredicted branches per query"},
    {"counters.loads", "1", Population::all, Repeats::timed, "loads per query"},
    {"counters.stores", "1", Population::all, Repeats::timed, "stores per query"},
    {"counters.l1d_fills", "1", Population::all, Repeats::timed, "lines brought into the first level per query"},
    {"counters.l1d_load_misses", "1", Population::all, Repeats::timed, "loads per query that miss the first level"},
    {"counters.l2_demand_misses", "1", Population::all, Repeats::timed, "demand misses of the second level per query"},
    {"counters.llc_misses", "1", Population::all, Repeats::timed, "misses of the last level per query"},
    {"counters.dtlb_walks", "1", Population::all, Repeats::timed, "page walks for data per query"},
    {"counters.line_crossing_loads", "1", Population::all, Repeats::timed, "loads per query that cross a cache line"},
    {"counters.minor_faults", "1", Population::all, Repeats::timed, "pages mapped in without reading a disk, per query"},
    {"counters.major_faults", "1", Population::all, Repeats::timed, "pages read from a disk, per query"},
    {"counters.context_switches", "1", Population::all, Repeats::timed, "times that the thread left its processor, per query"},
    {"counters.cpu_migrations", "1", Population::all, Repeats::timed, "times that the thread changed its processor, per query"},

    {"pairs.creation_ns", "ns", Population::none, Repeats::timed, "to make a pair's entry in a hash map, which an engine does at its first query"},
    {"pairs.find_ns", "ns", Population::none, Repeats::timed, "to find it there, which an engine does at every query"},
    {"support.query_ns.{start}", "ns", Population::named, Repeats::timed, "a support query by itself, of the cell's tables in turn, from the table's start or from the last answer a twentieth of a radian before"},
    {"scale.shared_query_ns", "ns", Population::all, Repeats::timed, "a GJK query of 64 instances, each at a scale of its own, over views of one table"},
    {"scale.own_query_ns", "ns", Population::all, Repeats::timed, "the same queries over a table for each instance, of the stretched body"},
    {"scale.shared_over_own", "1", Population::all, Repeats::timed, "one over the other, both of the same repetition: median"},
    {"scale.shared_over_own_low", "1", Population::all, Repeats::timed, "its 95 % interval over the repetitions of one process"},
    {"scale.shared_over_own_high", "1", Population::all, Repeats::timed, "likewise"},
    {"scale.shared_bytes", "B", Population::none, Repeats::exactly, "of the one table and the 64 views"},
    {"scale.own_bytes", "B", Population::none, Repeats::exactly, "of the 64 tables"},
    {"scale.build_ns", "ns", Population::none, Repeats::timed, "a table of a stretched body, from scratch"},
    {"scale.refit_ns", "ns", Population::none, Repeats::timed, "the same, in place"},
    {"scale.other_bits", "1", Population::all, Repeats::exactly, "distances over views that differ from those over tables, of all asked"},
    {"scale.worst_error", "1", Population::checked, Repeats::exactly, "of a distance over views against the exact one of the stretched points, over the size of the problem"},
    {"build.build_ns", "ns", Population::none, Repeats::timed, "median time to build a table from the canonical body"},
    {"build.refit_ns", "ns", Population::none, Repeats::timed, "median time to refit it in place to the body deformed"},
    {"build.refit_over_build", "1", Population::none, Repeats::timed, "median ratio of the two, timed in turn"},

    {"time.separated_ns", "ns", Population::steady, Repeats::timed, "median time per query of separated pairs over the rounds"},
    {"time.separated_ns_low", "ns", Population::steady, Repeats::timed, "lower end of its bootstrap 95 % interval"},
    {"time.separated_ns_high", "ns", Population::steady, Repeats::timed, "upper end of its bootstrap 95 % interval"},
    {"time.separated_ratio", "1", Population::steady, Repeats::timed, "median ratio to the baseline cell timed in the same rounds"},
    {"time.overlapping_ns", "ns", Population::steady, Repeats::timed, "the same of pairs in contact"},
    {"time.overlapping_ns_low", "ns", Population::steady, Repeats::timed, "lower end of its bootstrap 95 % interval"},
    {"time.overlapping_ns_high", "ns", Population::steady, Repeats::timed, "upper end of its bootstrap 95 % interval"},
    {"time.overlapping_ratio", "1", Population::steady, Repeats::timed, "median ratio to the baseline cell timed in the same rounds"},
    {"time.all_ns", "ns", Population::steady, Repeats::timed, "the same of pairs of both kinds as they come"},
    {"time.all_ns_low", "ns", Population::steady, Repeats::timed, "lower end of its bootstrap 95 % interval"},
    {"time.all_ns_high", "ns", Population::steady, Repeats::timed, "upper end of its bootstrap 95 % interval"},
    {"time.all_ratio", "1", Population::steady, Repeats::timed, "median ratio to the baseline cell timed in the same rounds"},
    {"time.query_ns.{start}", "ns", Population::named, Repeats::timed, "the next, of queries that start so"},
    {"time.query_ns", "ns", Population::all, Repeats::timed, "median time per query; of those of followed pairs that start cold each is timed by itself"},
    {"time.rounds", "rounds", Population::all, Repeats::exactly, "rounds timed"},

    {"cost.steps", "steps", Population::all, Repeats::exactly, "steps of the scene"},
    {"cost.bodies", "bodies", Population::none, Repeats::exactly, "bodies of the scene"},
    {"cost.pairs_per_step", "pairs", Population::all, Repeats::exactly, "N_p: pairs whose boxes overlap, per step"},
    {"cost.all_pairs", "pairs", Population::none, Repeats::exactly, "pairs that a scene without a broad phase would ask"},
    {"cost.box_tests_per_step", "tests", Population::all, Repeats::exactly, "N_v: pairs of boxes compared per step"},
    {"cost.moves_per_step", "moves", Population::all, Repeats::exactly, "places per step that sorting the boxes' ends moved"},
    {"cost.update_ns", "ns", Population::none, Repeats::timed, "C_u: time to update a body's box"},
    {"cost.box_test_ns", "ns", Population::none, Repeats::timed, "C_v: time per test of two boxes"},
    {"cost.pair_ns", "ns", Population::all, Repeats::timed, "C_p: time per query"},
    {"cost.step_ns", "ns", Population::all, Repeats::timed, "time of a whole step"},
    {"cost.equation_1_ns", "ns", Population::all, Repeats::timed, "the paper's first cost function of these parts"},
    {"cost.equation_2_ns", "ns", Population::all, Repeats::timed, "the paper's second cost function, with updates"},
    {"cost.equation_1_ratio", "1", Population::all, Repeats::timed, "the first over the time of the whole step"},
    {"cost.equation_2_ratio", "1", Population::all, Repeats::timed, "the second over the time of the whole step"},
};
// clang-format on

}  // namespace edgewise::store::vocabulary
