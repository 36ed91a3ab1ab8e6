// SPDX-License-Identifier: MIT
//
// Figures about answers: what algorithms do inside, and how right they are, in a sweep and in the stability
// run.
#pragma once

#include "edgewise/store/vocabulary/figure_info.hpp"

namespace edgewise::store::vocabulary {

// One figure a line.
// clang-format off
inline constexpr FigureInfo answers[] = {
    {"work.first_queries", "queries", Population::all, Repeats::exactly, "of followed pairs: queries that are their pair's first, and so start cold"},
    {"work.first_share", "1", Population::all, Repeats::exactly, "part of all queries that these are"},
    {"work.unchanged", "1", Population::warm, Repeats::exactly, "part of warm queries that end where they started"},
    {"work.told_by_bounds", "1", Population::warm, Repeats::exactly, "of needs=nearer: part of warm queries that the pair's bounds answer, without a look at a table"},
    {"work.support_unchanged", "1", Population::warm, Repeats::exactly, "of GJK: part of the last simplex's vertices that were in the one before"},
    {"work.support_near", "1", Population::warm, Repeats::exactly, "part of them that are beside a vertex of the one before"},
    {"work.hops_per_support", "1", Population::all, Repeats::exactly, "edges climbed per search of a support point"},
    {"work.vertices_per_support", "1", Population::all, Repeats::exactly, "vertices looked at per search of a support point"},
    {"work.subsets_tried", "1", Population::all, Repeats::exactly, "subsets of the simplex until the accepted one, in Johnson's order, per sub-distance"},
    {"work.accepted_{number}", "1", Population::all, Repeats::exactly, "part of sub-distances that end at a subset of so many points"},
    {"work.features_agree", "1", Population::checked, Repeats::exactly, "part of separated queries in which GJK ends on V-Clip's features"},

    {"error.checked", "queries", Population::checked, Repeats::exactly, "queries compared with exact answers"},
    {"error.worst_error_stored", "scale", Population::checked, Repeats::exactly, "largest error of a distance, against the exact answer of the bodies that the table holds"},
    {"error.worst_error_given", "scale", Population::checked, Repeats::exactly, "the same against the bodies as given"},
    {"error.p50_error_given", "scale", Population::checked, Repeats::exactly, "median error of a distance against the bodies as given"},
    {"error.p999_error_given", "scale", Population::checked, Repeats::exactly, "its 99.9th percentile; of 1000 checked queries or more: of fewer it would be the two largest errors, so it is left out"},
    {"error.p99_error_stored", "scale", Population::checked, Repeats::exactly, "99th percentile of the first"},
    {"error.witness_error", "scale", Population::checked, Repeats::exactly, "largest difference of the distance and that of the witness points"},
    {"error.wrong_verdicts", "queries", Population::checked, Repeats::exactly, "wrong verdicts outside the band where rounding decides"},
    {"error.wrong_answers", "queries", Population::checked, Repeats::exactly, "these, and distances or witness points further off than allowed"},
    {"error.verdicts_in_band", "queries", Population::checked, Repeats::exactly, "queries inside the band where rounding decides"},
    {"error.separated", "queries", Population::checked, Repeats::exactly, "pairs that are exactly separated"},
    {"error.touching", "queries", Population::checked, Repeats::exactly, "pairs that exactly touch"},
    {"error.overlapping", "queries", Population::checked, Repeats::exactly, "pairs that exactly overlap"},
    {"error.fallbacks", "queries", Population::all, Repeats::exactly, "V-Clip's answers that are not believed, asked of GJK"},
    {"error.refinements", "queries", Population::all, Repeats::exactly, "answers computed again in wide arithmetic"},
    {"error.escapes", "escapes", Population::all, Repeats::exactly, "escapes from local minima"},
    {"error.cycles", "queries", Population::all, Repeats::exactly, "queries that ran in a cycle"},
    {"error.mean_steps.{start}", "steps", Population::named, Repeats::exactly, "the next, of queries that start so"},
    {"error.mean_steps", "steps", Population::all, Repeats::exactly, "steps per query"},
    {"error.max_steps.{start}", "steps", Population::named, Repeats::exactly, "the next, of queries that start so"},
    {"error.max_steps", "steps", Population::all, Repeats::exactly, "most steps of a query"},
    {"error.control_checked", "queries", Population::checked, Repeats::exactly, "queries that the paper's control, Moore and Wilhelms's test, answers"},
    {"error.control_disagreements", "queries", Population::checked, Repeats::exactly, "of these, verdicts other than the control's"},
    {"error.control_disagreements_outside_band", "queries", Population::checked, Repeats::exactly, "of these, outside the band where rounding decides"},

    {"stability.cases", "queries", Population::cold, Repeats::exactly, "cases asked"},
    {"stability.refused", "queries", Population::cold, Repeats::exactly, "cases that the table or the query refused"},
    {"stability.separated", "queries", Population::cold, Repeats::exactly, "pairs that are exactly separated"},
    {"stability.touching", "queries", Population::cold, Repeats::exactly, "pairs that exactly touch"},
    {"stability.overlapping", "queries", Population::cold, Repeats::exactly, "pairs that exactly overlap"},
    {"stability.in_band", "queries", Population::cold, Repeats::exactly, "pairs inside the band where rounding decides"},
    {"stability.wrong_outside_band", "queries", Population::cold, Repeats::exactly, "wrong verdicts outside the band"},
    {"stability.wrong_inside_band", "queries", Population::cold, Repeats::exactly, "wrong verdicts inside the band"},
    {"stability.errors_beyond", "queries", Population::cold, Repeats::exactly, "distances or witness points further off than allowed"},
    {"stability.wrong_answers", "queries", Population::cold, Repeats::exactly, "cases with either: a wrong verdict outside the band, or such a distance or witness point"},
    {"stability.worst_error", "of scale", Population::cold, Repeats::exactly, "largest error of a distance beyond the band"},
    {"stability.p999_error", "of scale", Population::cold, Repeats::exactly, "its 99.9th percentile"},
    {"stability.worst_witness_error", "of scale", Population::cold, Repeats::exactly, "largest difference of the distance and that of the witness points"},
    {"stability.worst_depth_error", "of scale", Population::cold, Repeats::exactly, "largest error of a penetration depth"},
    {"stability.depths_beyond", "queries", Population::cold, Repeats::exactly, "depths further off than allowed"},
    {"stability.cap_hits", "queries", Population::cold, Repeats::exactly, "depths cut short by the cap on the polytope"},
    {"stability.worst_certificate_width", "of scale", Population::cold, Repeats::exactly, "widest certified interval of a distance"},
    {"stability.certificates", "queries", Population::cold, Repeats::exactly, "answers with a certificate"},
    {"stability.certificates_missed", "queries", Population::cold, Repeats::exactly, "certificates that do not hold the exact distance, or that the answer contradicts"},
    {"stability.control_asked", "queries", Population::cold, Repeats::exactly, "cases that the paper's control answers"},
    {"stability.control_disagrees", "queries", Population::cold, Repeats::exactly, "of these, verdicts other than the control's"},
    {"stability.control_disagrees_outside_band", "queries", Population::cold, Repeats::exactly, "of these, outside the band"},
    {"stability.control_wrong", "queries", Population::cold, Repeats::exactly, "cases outside the band where the control itself is wrong"},
    {"stability.escapes", "escapes", Population::cold, Repeats::exactly, "escapes from local minima"},
    {"stability.cycles", "queries", Population::cold, Repeats::exactly, "cases that ran in a cycle"},
    {"stability.fallbacks", "queries", Population::cold, Repeats::exactly, "V-Clip's answers that are not believed, asked of GJK"},
    {"stability.refinements", "queries", Population::cold, Repeats::exactly, "answers computed again in wide arithmetic"},
    {"stability.mean_steps", "steps", Population::cold, Repeats::exactly, "steps per case"},
    {"stability.max_steps", "steps", Population::cold, Repeats::exactly, "most steps of a case"},
    {"stability.failures_at_{tolerance}", "queries", Population::cold, Repeats::exactly, "wrong verdicts when distances up to {tolerance} of the scale count as contact"},
    {"stability.ns_at_{gap}", "ns", Population::cold, Repeats::timed, "time per query of cases with a gap from {gap} of the scale on"},
};
// clang-format on

}  // namespace edgewise::store::vocabulary
