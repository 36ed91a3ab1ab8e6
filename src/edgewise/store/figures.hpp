// SPDX-License-Identifier: MIT
//
// The vocabulary: every figure that a store can hold, one a line, with its unit and what it means.
#pragma once

#include <string_view>

namespace edgewise::store {

/// The queries that a figure counts. A query starts cold if it is its pair's first, or if the scene keeps no
/// answers; it starts warm from its pair's kept answer.
enum class Population {
    none,
    all,
    cold,
    warm,
    named,   ///< cold or warm, as the figure's name ends
    steady,  ///< warm where pairs are followed; else all, which are cold
    checked
};

[[nodiscard]] constexpr std::string_view to_string(Population population) {
    constexpr std::string_view names[] = {"none", "all", "cold", "warm", "named", "steady", "checked"};
    return names[static_cast<int>(population)];
}

enum class Repeats {
    exactly,  ///< the same bits in every run on every machine
    timed     ///< measured: another run gives another number
};

struct FigureInfo {
    std::string_view key;  ///< probe, a dot and the name: "time.all_ns", "heap.{structure}.slack_bytes"
    std::string_view unit;
    Population population;
    Repeats repeats;
    std::string_view meaning;

    [[nodiscard]] constexpr std::string_view probe() const { return key.substr(0, key.find('.')); }
    [[nodiscard]] constexpr std::string_view name() const { return key.substr(key.find('.') + 1); }
};

namespace vocabulary {

// clang-format off
// Memory: bytes of tables, the parts that queries touch, cache misses, and paging.
inline constexpr FigureInfo memory[] = {
    {"bytes.voronoi_planes", "B/edge", Population::none, Repeats::exactly, "Voronoi planes stored"},
    {"bytes.edge_geometry", "B/edge", Population::none, Repeats::exactly, "directions and lengths of edges"},
    {"bytes.vertex_coordinates", "B/edge", Population::none, Repeats::exactly, "coordinates of vertices"},
    {"bytes.face_planes", "B/edge", Population::none, Repeats::exactly, "planes of faces"},
    {"bytes.topology", "B/edge", Population::none, Repeats::exactly, "indices, rings, offsets and links"},
    {"bytes.input_order", "B/edge", Population::none, Repeats::exactly, "index of each vertex in the user's list, if the table keeps it"},
    {"bytes.padding", "B/edge", Population::none, Repeats::exactly, "bytes that hold nothing"},
    {"bytes.paper_bytes_per_edge", "B/edge", Population::none, Repeats::exactly, "slope of the paper's subtotal (Voronoi planes, edge geometry, coordinates) per additional edge"},
    {"bytes.total_bytes_per_edge", "B/edge", Population::none, Repeats::exactly, "bytes of the whole table divided by the shape's edges"},
    {"bytes.slope_bytes_per_edge", "B/edge", Population::none, Repeats::exactly, "slope of the whole table per additional edge"},
    {"bytes.table_bytes", "B", Population::none, Repeats::exactly, "bytes of the whole table"},
    {"bytes.object_bytes", "B", Population::none, Repeats::exactly, "bytes of the table's object, which the user's code holds, without the table's block of memory"},
    {"bytes.constant_bytes", "B", Population::none, Repeats::exactly, "cost of a body before its first edge: the object, plus the intercept of the fit of the whole table's slope"},
    {"bytes.pair_bytes", "B", Population::none, Repeats::exactly, "bytes that a pair keeps from one query to the next"},

    {"lines.lines_per_query.{start}", "lines", Population::named, Repeats::exactly, "as the next figure, for cold or warm queries only"},
    {"lines.lines_per_query", "lines", Population::all, Repeats::exactly, "distinct cache lines of 64 bytes that a query reads of both tables"},
    {"lines.line_bytes_per_query.{start}", "B", Population::named, Repeats::exactly, "as the next figure, for cold or warm queries only"},
    {"lines.line_bytes_per_query", "B", Population::all, Repeats::exactly, "bytes of the cache lines that a query reads"},
    {"lines.read_bytes_per_query.{start}", "B", Population::named, Repeats::exactly, "as the next figure, for cold or warm queries only"},
    {"lines.read_bytes_per_query", "B", Population::all, Repeats::exactly, "distinct bytes that a query reads"},
    {"lines.reads_per_query.{start}", "reads", Population::named, Repeats::exactly, "as the next figure, for cold or warm queries only"},
    {"lines.reads_per_query", "reads", Population::all, Repeats::exactly, "reads of both tables"},

    {"caches.misses_per_query", "misses", Population::all, Repeats::exactly, "only if nothing was traced: no value, and the reason"},
    {"caches.identity", "1", Population::none, Repeats::exactly, "hash of the modelled machines and of the number of queries"},
    {"caches.{machine}.{level}.misses_per_query.{start}", "misses", Population::named, Repeats::exactly, "as the next figure, for cold or warm queries only"},
    {"caches.{machine}.{level}.misses_per_query", "misses", Population::all, Repeats::exactly, "modelled misses of the steady pass; a machine name with /POLICY has that replacement policy"},
    {"caches.{machine}.{level}.capacity_per_query.{start}", "misses", Population::named, Repeats::exactly, "as the next figure, for cold or warm queries only"},
    {"caches.{machine}.{level}.capacity_per_query", "misses", Population::all, Repeats::exactly, "misses of the steady pass that a fully associative cache of the same size also has"},
    {"caches.{machine}.{level}.conflict_per_query.{start}", "misses", Population::named, Repeats::exactly, "as the next figure, for cold or warm queries only"},
    {"caches.{machine}.{level}.conflict_per_query", "misses", Population::all, Repeats::exactly, "misses of the steady pass that limited associativity causes"},
    {"caches.{machine}.{level}.first_pass_misses_per_query", "misses", Population::all, Repeats::exactly, "misses of the first pass, which starts with empty caches and fills them"},
    {"caches.{machine}.{level}.compulsory_per_query", "misses", Population::all, Repeats::exactly, "misses of the first pass on lines that were never touched before"},
    {"caches.{machine}.{level}.misses_per_edge", "misses", Population::all, Repeats::exactly, "misses of the steady pass per query and edge of the shape"},
    {"caches.{machine}.{level}.cold_verified", "1", Population::all, Repeats::exactly, "compulsory misses divided by first touches; 1 if the first pass started with empty caches"},
    {"caches.{machine}.{level}.emptied_misses_per_query.{start}", "misses", Population::named, Repeats::exactly, "as the next figure, for cold or warm queries only"},
    {"caches.{machine}.{level}.emptied_misses_per_query", "misses", Population::all, Repeats::exactly, "misses on tables alone if caches are emptied before each query"},
    {"caches.{machine}.{level}.field.{field}.{start}", "misses", Population::named, Repeats::exactly, "as the next figure, for cold or warm queries only"},
    {"caches.{machine}.{level}.field.{field}", "misses", Population::all, Repeats::exactly, "misses per query of the steady pass, by the data that was read"},
    {"caches.{machine}.{level}.step.{step}.{start}", "misses", Population::named, Repeats::exactly, "as the next figure, for cold or warm queries only"},
    {"caches.{machine}.{level}.step.{step}", "misses", Population::all, Repeats::exactly, "misses per query of the steady pass, by the algorithm's step that read"},
    {"caches.{machine}.fetched_bytes_per_query", "B", Population::all, Repeats::exactly, "bytes brought into the first level"},
    {"caches.{machine}.unused_bytes_per_query", "B", Population::all, Repeats::exactly, "bytes brought into the first level that were never read before their eviction"},
    {"caches.{machine}.modelled_memory_ns.{start}", "ns, model", Population::named, Repeats::exactly, "as the next figure, for cold or warm queries only"},
    {"caches.{machine}.modelled_memory_ns", "ns, model", Population::all, Repeats::exactly, "misses times latencies per query; the unit says if a latency is not verified"},

    {"reuse.lines_per_query.{start}", "lines", Population::named, Repeats::exactly, "as the next figure, for cold or warm queries only"},
    {"reuse.lines_per_query", "lines", Population::all, Repeats::exactly, "lines of 64 bytes that a query touches, in all data that the scene keeps"},
    {"reuse.lines_of_scene", "lines", Population::all, Repeats::exactly, "distinct lines in the whole pass"},
    {"reuse.lines_of_body", "lines", Population::all, Repeats::exactly, "lines per table"},
    {"reuse.lines_of_frame", "lines", Population::all, Repeats::exactly, "distinct lines per frame"},
    {"reuse.line_knee_bytes.{start}", "B", Population::named, Repeats::exactly, "as the next figure, for cold or warm queries only"},
    {"reuse.line_knee_bytes", "B", Population::all, Repeats::exactly, "cache size below which the scene thrashes, from reuse distances of lines"},
    {"reuse.line_misses_at_2^{power}.{start}", "misses", Population::named, Repeats::exactly, "as the next figure, for cold or warm queries only"},
    {"reuse.line_misses_at_2^{power}", "misses", Population::all, Repeats::exactly, "misses per query of lines in a fully associative LRU cache of 2^power bytes"},
    {"reuse.pages_per_query.{start}", "pages", Population::named, Repeats::exactly, "as the next figure, for cold or warm queries only"},
    {"reuse.pages_per_query", "pages", Population::all, Repeats::exactly, "pages of 4 KiB that a query touches"},
    {"reuse.pages_of_scene", "pages", Population::all, Repeats::exactly, "distinct pages in the whole pass"},
    {"reuse.pages_of_body", "pages", Population::all, Repeats::exactly, "pages per table"},
    {"reuse.pages_of_frame", "pages", Population::all, Repeats::exactly, "distinct pages per frame"},
    {"reuse.page_knee_bytes.{start}", "B", Population::named, Repeats::exactly, "as the next figure, for cold or warm queries only"},
    {"reuse.page_knee_bytes", "B", Population::all, Repeats::exactly, "memory size below which the scene thrashes, from reuse distances of pages"},
    {"reuse.page_misses_at_2^{power}.{start}", "misses", Population::named, Repeats::exactly, "as the next figure, for cold or warm queries only"},
    {"reuse.page_misses_at_2^{power}", "misses", Population::all, Repeats::exactly, "misses per query of pages in a fully associative LRU memory of 2^power bytes"},

    {"heat.touched_part", "1", Population::all, Repeats::exactly, "part of the tables' bytes that the scene ever touches"},
    {"heat.touched_bytes", "B", Population::all, Repeats::exactly, "bytes of the tables that the scene ever touches"},
    {"heat.lines_of_half_the_accesses", "lines", Population::all, Repeats::exactly, "fewest lines that take half of the accesses"},
    {"heat.lines_of_most_accesses", "lines", Population::all, Repeats::exactly, "fewest lines that take 90 % of the accesses"},
    {"heat.lines", "lines", Population::all, Repeats::exactly, "lines accessed at least once"},
    {"heat.touched_vertices", "1", Population::all, Repeats::exactly, "part of the vertices that the scene ever touches"},
    {"heat.touched_edges", "1", Population::all, Repeats::exactly, "part of the edges that the scene ever touches"},
    {"heat.touched_faces", "1", Population::all, Repeats::exactly, "part of the faces that the scene ever touches"},
    {"heat.touched_{component}", "1", Population::all, Repeats::exactly, "part of this component's bytes (names as in bytes.*) that the scene ever touches"},
    {"heat.lines_of_query.{start}", "lines", Population::named, Repeats::exactly, "as the next figure, for cold or warm queries only"},
    {"heat.lines_of_query", "lines", Population::all, Repeats::exactly, "distinct lines of tables that a query accesses"},
    {"heat.accesses.{field}.{start}", "accesses", Population::named, Repeats::exactly, "as the next figure, for cold or warm queries only"},
    {"heat.accesses.{field}", "accesses", Population::all, Repeats::exactly, "accesses per query, by the data that was read"},

    {"memory.tables", "tables", Population::none, Repeats::exactly, "tables of the scene"},
    {"memory.requested_bytes", "B", Population::none, Repeats::exactly, "bytes that all tables request"},
    {"memory.taken_bytes", "B", Population::none, Repeats::timed, "bytes that all tables take in the allocator"},
    {"memory.resident_bytes", "B", Population::none, Repeats::timed, "bytes of pages in memory"},
    {"memory.materialised", "1", Population::none, Repeats::exactly, "part of the tables' bytes that was ever made; less than 1 in lazy tables"},

    {"heap.{structure}.requested_bytes", "B", Population::none, Repeats::exactly, "bytes requested by one table, by the caches of all pairs, or by the arrays of the broad phase"},
    {"heap.{structure}.size_class_bytes", "B", Population::none, Repeats::timed, "bytes that the structure takes in jemalloc's size classes"},
    {"heap.{structure}.slack_bytes", "B", Population::none, Repeats::timed, "size-class bytes minus requested bytes"},
    {"heap.{structure}.resident_bytes", "B", Population::none, Repeats::timed, "bytes of pages in the structure's own arena"},

    {"paging.table_bytes", "B", Population::none, Repeats::exactly, "bytes of all tables"},
    {"paging.touched_bytes", "B", Population::all, Repeats::exactly, "bytes of the pages that a pass touches"},
    {"paging.keeps_recency", "1", Population::none, Repeats::timed, "1 if the kernel keeps track of which pages were used last"},
    {"paging.limit_bytes.{limit}", "B", Population::none, Repeats::exactly, "memory limit number {limit}"},
    {"paging.predicted_at_limit.{limit}.{start}", "faults", Population::named, Repeats::exactly, "as the next figure, for cold or warm queries only"},
    {"paging.predicted_at_limit.{limit}", "faults", Population::all, Repeats::exactly, "faults per query that reuse distances predict for the limit"},
    {"paging.held_bytes.{limit}", "B", Population::all, Repeats::timed, "bytes of tables that were really in memory"},
    {"paging.predicted_at_held.{limit}", "faults", Population::all, Repeats::timed, "faults per query predicted for the held bytes"},
    {"paging.faults_per_query.{limit}", "faults", Population::all, Repeats::timed, "faults per query that the kernel counted"},
    {"paging.us_per_query.{limit}", "us", Population::all, Repeats::timed, "time per query under the limit"},
};

// Time: cost of queries, tables and steps of a scene, and counts of the processor.
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

    {"pairs.creation_ns", "ns", Population::none, Repeats::timed, "time to make a pair's entry in a hash map; an engine does this at the pair's first query"},
    {"pairs.find_ns", "ns", Population::none, Repeats::timed, "time to find a pair's entry in the hash map; an engine does this at every query"},
    {"support.query_ns.{start}", "ns", Population::named, Repeats::timed, "time of a support query alone, on the cell's tables in turn; cold: from the table's start; warm: from the last answer, a twentieth of a radian away"},
    {"scale.shared_query_ns", "ns", Population::all, Repeats::timed, "time of a GJK query on 64 instances, each with its own scale, over views of one table"},
    {"scale.own_query_ns", "ns", Population::all, Repeats::timed, "time of the same queries if each instance has a table of its stretched body"},
    {"scale.shared_over_own", "1", Population::all, Repeats::timed, "shared_query_ns divided by own_query_ns of the same repetition: median"},
    {"scale.shared_over_own_low", "1", Population::all, Repeats::timed, "lower end of its 95 % interval over the repetitions of one process"},
    {"scale.shared_over_own_high", "1", Population::all, Repeats::timed, "upper end of its 95 % interval over the repetitions of one process"},
    {"scale.shared_bytes", "B", Population::none, Repeats::exactly, "bytes of the one table and the 64 views"},
    {"scale.own_bytes", "B", Population::none, Repeats::exactly, "bytes of the 64 tables"},
    {"scale.build_ns", "ns", Population::none, Repeats::timed, "time to build a table of a stretched body from scratch"},
    {"scale.refit_ns", "ns", Population::none, Repeats::timed, "time to refit a table in place to a stretched body"},
    {"scale.other_bits", "1", Population::all, Repeats::exactly, "number of distances that differ between views and tables, out of all queries"},
    {"scale.worst_error", "1", Population::checked, Repeats::exactly, "error of a distance over views, against the exact distance of the stretched points, divided by the size of the problem"},
    {"build.build_ns", "ns", Population::none, Repeats::timed, "median time to build a table from the canonical body"},
    {"build.refit_ns", "ns", Population::none, Repeats::timed, "median time to refit a table in place to the deformed body"},
    {"build.refit_over_build", "1", Population::none, Repeats::timed, "median ratio of refit time to build time, timed in turn"},

    {"time.separated_ns", "ns", Population::steady, Repeats::timed, "median time per query of separated pairs over the rounds"},
    {"time.separated_ns_low", "ns", Population::steady, Repeats::timed, "lower end of its bootstrap 95 % interval"},
    {"time.separated_ns_high", "ns", Population::steady, Repeats::timed, "upper end of its bootstrap 95 % interval"},
    {"time.separated_ratio", "1", Population::steady, Repeats::timed, "median ratio to the baseline cell timed in the same rounds"},
    {"time.overlapping_ns", "ns", Population::steady, Repeats::timed, "median time per query of pairs in contact over the rounds"},
    {"time.overlapping_ns_low", "ns", Population::steady, Repeats::timed, "lower end of its bootstrap 95 % interval"},
    {"time.overlapping_ns_high", "ns", Population::steady, Repeats::timed, "upper end of its bootstrap 95 % interval"},
    {"time.overlapping_ratio", "1", Population::steady, Repeats::timed, "median ratio to the baseline cell timed in the same rounds"},
    {"time.all_ns", "ns", Population::steady, Repeats::timed, "median time per query of pairs of both kinds, in the scene's order, over the rounds"},
    {"time.all_ns_low", "ns", Population::steady, Repeats::timed, "lower end of its bootstrap 95 % interval"},
    {"time.all_ns_high", "ns", Population::steady, Repeats::timed, "upper end of its bootstrap 95 % interval"},
    {"time.all_ratio", "1", Population::steady, Repeats::timed, "median ratio to the baseline cell timed in the same rounds"},
    {"time.query_ns.{start}", "ns", Population::named, Repeats::timed, "as the next figure, for cold or warm queries only"},
    {"time.query_ns", "ns", Population::all, Repeats::timed, "median time per query; cold queries of followed pairs are timed one by one"},
    {"time.rounds", "rounds", Population::all, Repeats::exactly, "number of timed rounds"},

    {"cost.steps", "steps", Population::all, Repeats::exactly, "steps of the scene"},
    {"cost.bodies", "bodies", Population::none, Repeats::exactly, "bodies of the scene"},
    {"cost.pairs_per_step", "pairs", Population::all, Repeats::exactly, "N_p: pairs with overlapping boxes, per step"},
    {"cost.all_pairs", "pairs", Population::none, Repeats::exactly, "pairs that a scene without a broad phase would query"},
    {"cost.box_tests_per_step", "tests", Population::all, Repeats::exactly, "N_v: pairs of boxes compared per step"},
    {"cost.moves_per_step", "moves", Population::all, Repeats::exactly, "places that sorting moved the ends of boxes, per step"},
    {"cost.update_ns", "ns", Population::none, Repeats::timed, "C_u: time to update a body's box"},
    {"cost.box_test_ns", "ns", Population::none, Repeats::timed, "C_v: time per test of two boxes"},
    {"cost.pair_ns", "ns", Population::all, Repeats::timed, "C_p: time per query"},
    {"cost.step_ns", "ns", Population::all, Repeats::timed, "time of a whole step"},
    {"cost.equation_1_ns", "ns", Population::all, Repeats::timed, "the paper's first cost function, computed from the figures above"},
    {"cost.equation_2_ns", "ns", Population::all, Repeats::timed, "the paper's second cost function, with updates"},
    {"cost.equation_1_ratio", "1", Population::all, Repeats::timed, "equation_1_ns divided by the time of the whole step"},
    {"cost.equation_2_ratio", "1", Population::all, Repeats::timed, "equation_2_ns divided by the time of the whole step"},
};

// Answers: the work inside algorithms, and errors of answers in a sweep and in the stability run.
inline constexpr FigureInfo answers[] = {
    {"work.first_queries", "queries", Population::all, Repeats::exactly, "queries of followed pairs that are their pair's first, and so start cold"},
    {"work.first_share", "1", Population::all, Repeats::exactly, "first_queries divided by all queries"},
    {"work.unchanged", "1", Population::warm, Repeats::exactly, "part of warm queries that end where they started"},
    {"work.told_by_bounds", "1", Population::warm, Repeats::exactly, "needs=nearer: part of warm queries that the pair's bounds answer, without reading a table"},
    {"work.support_unchanged", "1", Population::warm, Repeats::exactly, "GJK: part of the last simplex's vertices that were also in the previous simplex"},
    {"work.support_near", "1", Population::warm, Repeats::exactly, "GJK: part of the last simplex's vertices that are neighbours of a vertex of the previous simplex"},
    {"work.hops_per_support", "1", Population::all, Repeats::exactly, "edges climbed per search of a support point"},
    {"work.vertices_per_support", "1", Population::all, Repeats::exactly, "vertices looked at per search of a support point"},
    {"work.subsets_tried", "1", Population::all, Repeats::exactly, "subsets of the simplex until the accepted one, in Johnson's order, per sub-distance"},
    {"work.accepted_{number}", "1", Population::all, Repeats::exactly, "part of sub-distances that end at a subset of {number} points"},
    {"work.features_agree", "1", Population::checked, Repeats::exactly, "part of separated queries in which GJK ends on V-Clip's features"},

    {"error.checked", "queries", Population::checked, Repeats::exactly, "queries compared with exact answers"},
    {"error.worst_error_stored", "scale", Population::checked, Repeats::exactly, "largest error of a distance, against the exact answer of the bodies that the table holds"},
    {"error.worst_error_given", "scale", Population::checked, Repeats::exactly, "largest error of a distance, against the exact answer of the bodies as given"},
    {"error.p50_error_given", "scale", Population::checked, Repeats::exactly, "median error of a distance against the bodies as given"},
    {"error.p999_error_given", "scale", Population::checked, Repeats::exactly, "99.9th percentile of the error against the bodies as given; only for 1000 checked queries or more"},
    {"error.p99_error_stored", "scale", Population::checked, Repeats::exactly, "99th percentile of the error against the bodies that the table holds"},
    {"error.witness_error", "scale", Population::checked, Repeats::exactly, "largest difference between the distance and the distance of the witness points"},
    {"error.wrong_verdicts", "queries", Population::checked, Repeats::exactly, "wrong verdicts outside the band where rounding decides"},
    {"error.wrong_answers", "queries", Population::checked, Repeats::exactly, "wrong verdicts outside the band, and distances or witness points with a larger error than allowed"},
    {"error.verdicts_in_band", "queries", Population::checked, Repeats::exactly, "queries inside the band where rounding decides"},
    {"error.separated", "queries", Population::checked, Repeats::exactly, "pairs that are exactly separated"},
    {"error.touching", "queries", Population::checked, Repeats::exactly, "pairs that exactly touch"},
    {"error.overlapping", "queries", Population::checked, Repeats::exactly, "pairs that exactly overlap"},
    {"error.fallbacks", "queries", Population::all, Repeats::exactly, "doubtful V-Clip answers, which GJK answers instead"},
    {"error.refinements", "queries", Population::all, Repeats::exactly, "answers computed again, with more care"},
    {"error.escapes", "escapes", Population::all, Repeats::exactly, "escapes from local minima"},
    {"error.cycles", "queries", Population::all, Repeats::exactly, "queries that ran in a cycle"},
    {"error.mean_steps.{start}", "steps", Population::named, Repeats::exactly, "as the next figure, for cold or warm queries only"},
    {"error.mean_steps", "steps", Population::all, Repeats::exactly, "steps per query"},
    {"error.max_steps.{start}", "steps", Population::named, Repeats::exactly, "as the next figure, for cold or warm queries only"},
    {"error.max_steps", "steps", Population::all, Repeats::exactly, "largest number of steps of a query"},
    {"error.control_checked", "queries", Population::checked, Repeats::exactly, "queries that the paper's control, Moore and Wilhelms's test, answers"},
    {"error.control_disagreements", "queries", Population::checked, Repeats::exactly, "verdicts that differ from the control's"},
    {"error.control_disagreements_outside_band", "queries", Population::checked, Repeats::exactly, "verdicts that differ from the control's, outside the band where rounding decides"},

    {"stability.cases", "queries", Population::cold, Repeats::exactly, "cases asked"},
    {"stability.refused", "queries", Population::cold, Repeats::exactly, "cases that the table or the query refused"},
    {"stability.separated", "queries", Population::cold, Repeats::exactly, "pairs that are exactly separated"},
    {"stability.touching", "queries", Population::cold, Repeats::exactly, "pairs that exactly touch"},
    {"stability.overlapping", "queries", Population::cold, Repeats::exactly, "pairs that exactly overlap"},
    {"stability.in_band", "queries", Population::cold, Repeats::exactly, "pairs inside the band where rounding decides"},
    {"stability.wrong_outside_band", "queries", Population::cold, Repeats::exactly, "wrong verdicts outside the band"},
    {"stability.wrong_inside_band", "queries", Population::cold, Repeats::exactly, "wrong verdicts inside the band"},
    {"stability.errors_beyond", "queries", Population::cold, Repeats::exactly, "distances or witness points with a larger error than allowed"},
    {"stability.wrong_answers", "queries", Population::cold, Repeats::exactly, "cases with a wrong verdict outside the band, or with a larger error of distance or witness points than allowed"},
    {"stability.worst_error", "of scale", Population::cold, Repeats::exactly, "largest error of a distance beyond the band"},
    {"stability.p999_error", "of scale", Population::cold, Repeats::exactly, "99.9th percentile of the error of a distance beyond the band"},
    {"stability.worst_witness_error", "of scale", Population::cold, Repeats::exactly, "largest difference between the distance and the distance of the witness points"},
    {"stability.worst_depth_error", "of scale", Population::cold, Repeats::exactly, "largest error of a penetration depth"},
    {"stability.depths_beyond", "queries", Population::cold, Repeats::exactly, "depths with a larger error than allowed"},
    {"stability.cap_hits", "queries", Population::cold, Repeats::exactly, "depths cut short by the cap on the polytope"},
    {"stability.worst_certificate_width", "of scale", Population::cold, Repeats::exactly, "widest certified interval of a distance"},
    {"stability.certificates", "queries", Population::cold, Repeats::exactly, "answers with a certificate"},
    {"stability.certificates_missed", "queries", Population::cold, Repeats::exactly, "certificates that do not contain the exact distance, or that the answer contradicts"},
    {"stability.control_asked", "queries", Population::cold, Repeats::exactly, "cases that the paper's control answers"},
    {"stability.control_disagrees", "queries", Population::cold, Repeats::exactly, "verdicts that differ from the control's"},
    {"stability.control_disagrees_outside_band", "queries", Population::cold, Repeats::exactly, "verdicts that differ from the control's, outside the band"},
    {"stability.control_wrong", "queries", Population::cold, Repeats::exactly, "cases outside the band where the control itself is wrong"},
    {"stability.escapes", "escapes", Population::cold, Repeats::exactly, "escapes from local minima"},
    {"stability.cycles", "queries", Population::cold, Repeats::exactly, "cases that ran in a cycle"},
    {"stability.fallbacks", "queries", Population::cold, Repeats::exactly, "doubtful V-Clip answers, which GJK answers instead"},
    {"stability.refinements", "queries", Population::cold, Repeats::exactly, "answers computed again, with more care"},
    {"stability.mean_steps", "steps", Population::cold, Repeats::exactly, "steps per case"},
    {"stability.max_steps", "steps", Population::cold, Repeats::exactly, "largest number of steps of a case"},
    {"stability.failures_at_{tolerance}", "queries", Population::cold, Repeats::exactly, "wrong verdicts when distances up to {tolerance} of the scale count as contact"},
    {"stability.ns_at_{gap}", "ns", Population::cold, Repeats::timed, "time per query of cases with a gap from {gap} of the scale on"},
};

// Work of queries (the study `effort`), counted by Callgrind and in traces: of table types and of other libraries, per
// query, per step, and over a floor.
inline constexpr FigureInfo effort[] = {
    {"effort.instructions", "1", Population::all, Repeats::timed, "instructions per query, counted by Callgrind as a difference of passes"},
    {"effort.mispredictions", "1", Population::all, Repeats::timed, "mispredicted branches per query, modelled by Callgrind's branch simulation"},
    {"effort.{machine}.d1_misses", "1", Population::all, Repeats::timed, "data misses per query of the machine's first level, modelled by Callgrind"},
    {"effort.{machine}.ll_misses", "1", Population::all, Repeats::timed, "data misses per query of the machine's second level, modelled by Callgrind as the last"},
    {"effort.steps", "steps", Population::all, Repeats::exactly, "V-Clip states or GJK iterations per query"},
    {"effort.vertices_read", "1", Population::all, Repeats::exactly, "vertices read of the two tables per query"},
    {"effort.lines_read", "lines", Population::all, Repeats::exactly, "distinct lines of the two tables that a query reads"},
    {"effort.instructions_per_step", "1", Population::all, Repeats::timed, "instructions divided by steps"},
    {"effort.mispredictions_per_step", "1", Population::all, Repeats::timed, "modelled mispredictions divided by steps"},
    {"effort.vertices_per_step", "1", Population::all, Repeats::exactly, "vertices read divided by steps"},
    {"effort.floor_vertices", "1", Population::all, Repeats::exactly, "floor: vertices that a proof of the known answer by heights of vertices reads"},
    {"effort.floor_flops", "1", Population::all, Repeats::exactly, "floating-point operations of the floor's proof"},
    {"effort.floor_lines", "lines", Population::all, Repeats::exactly, "fewest lines that the coordinates of the proof's vertices fill"},
    {"effort.instructions_over_floor", "1", Population::all, Repeats::timed, "instructions divided by floor_flops"},
    {"effort.vertices_over_floor", "1", Population::all, Repeats::exactly, "vertices read divided by floor_vertices"},
    {"effort.lines_over_floor", "1", Population::all, Repeats::exactly, "lines read divided by floor_lines"},
};

// Possible causes of the paper's figure 8 (studies/thrash): a row of the factorial sums over bodies, memory and the cost
// of a fault; a row of a realised cell has one point for each speed.
inline constexpr FigureInfo thrash[] = {
    {"thrash.settings", "settings", Population::none, Repeats::exactly, "combinations of bodies, memory and cost of a fault that were scored"},
    {"thrash.settings_with.{fact}", "settings", Population::all, Repeats::timed, "settings where this fact of figure 8 holds (a model; builds are measured)"},
    {"thrash.settings_with_all", "settings", Population::all, Repeats::timed, "settings where all four facts hold"},
    {"thrash.facts.{setting}", "1", Population::all, Repeats::timed, "sum of the facts that hold with BODIES_MIB_COSTns: 1 rises, 2 takes as long, 4 spares GJK, 8 erratic"},
    {"thrash.best_facts", "1", Population::all, Repeats::timed, "largest number of facts that hold at once"},
    {"thrash.best.bodies", "bodies", Population::none, Repeats::timed, "bodies of the best setting: the one with most facts and with the rise nearest to 12"},
    {"thrash.best.memory_bytes", "B", Population::none, Repeats::timed, "memory of the best setting"},
    {"thrash.best.fault_ns", "ns", Population::none, Repeats::timed, "cost of a fault in the best setting"},
    {"thrash.best.rise", "1", Population::all, Repeats::timed, "best setting: V-Clip's longest time at 386 vertices divided by its longest at 38"},
    {"thrash.best.top_us", "us", Population::all, Repeats::timed, "best setting: V-Clip's longest time at 386 vertices"},
    {"thrash.best.gjk_rise", "1", Population::all, Repeats::timed, "best setting: GJK's longest time at 386 vertices divided by its longest at 38"},
    {"thrash.best.fall", "1", Population::all, Repeats::timed, "best setting: largest fall of V-Clip's time at 386 vertices as speed grows"},
    {"thrash.ns_per_read", "ns", Population::all, Repeats::exactly, "processor time per read, fitted so that figures 4, 6 and 7 are met on average"},
    {"thrash.calibrated.{figure}", "1", Population::all, Repeats::exactly, "the model's time divided by the top of that figure's axis"},
    {"thrash.predicted_us.{speed}", "us", Population::all, Repeats::timed, "predicted time per query at {speed} rad per second: without the pager, plus the faults of the same policy on a trace"},
    {"thrash.measured_us.{speed}", "us", Population::all, Repeats::timed, "time per query under the pager"},
    {"thrash.model_us.{speed}", "us", Population::all, Repeats::exactly, "time per query in the factorial, on a processor of the paper's time"},
    {"thrash.in_memory_us.{speed}", "us", Population::all, Repeats::timed, "time per query without the pager"},
    {"thrash.predicted_faults.{speed}", "faults", Population::all, Repeats::exactly, "hard faults per query that the same policy has on a trace"},
    {"thrash.measured_faults.{speed}", "faults", Population::all, Repeats::timed, "hard faults per query that the pager served"},
    {"thrash.queries.{speed}", "queries", Population::all, Repeats::exactly, "number of queries in each mean time"},
};

// Fields of a table's records (studies/fields): which are read together, in which groups they should lie, and the
// result. {whose} is a table: original (as given), own_groups (the same groups, chosen at run time), control (the
// original a second time), predicted, advised (as it was built), beside (a table made by hand).
inline constexpr FigureInfo fields[] = {
    {"fields.bytes.{field}", "B", Population::none, Repeats::exactly, "bytes of the field; fields are numbered in the order of their records"},
    {"fields.number.{field}", "1", Population::none, Repeats::exactly, "number of the field, in the order of records"},
    {"fields.own_group.{field}", "1", Population::none, Repeats::exactly, "number of the record in which the table keeps the field"},
    {"fields.advised_group.{field}", "1", Population::all, Repeats::exactly, "number of the record in which queries read the fewest lines"},
    {"fields.query_part.{field}", "1", Population::all, Repeats::exactly, "part of the queries that read the field"},
    {"fields.step_part.{field}", "1", Population::all, Repeats::exactly, "part of the algorithm's steps that read the field, among the steps that read a table"},
    {"fields.same_query.{field}.{other}", "1", Population::all, Repeats::exactly, "queries that read both fields, divided by queries that read either field"},
    {"fields.same_step.{field}.{other}", "1", Population::all, Repeats::exactly, "steps that read both fields, divided by steps that read either field"},
    {"fields.same_record.{field}.{other}", "1", Population::all, Repeats::exactly, "the same for records in a step: 1 if a step that reads one field of a record also reads the other"},
    {"fields.lines.{whose}", "lines", Population::all, Repeats::exactly, "distinct lines of tables per query"},
    {"fields.unseen_lines.{whose}", "lines", Population::all, Repeats::exactly, "distinct lines of tables per query in the scene from another seed, which the advice never saw"},
    {"fields.misses.{machine}.{level}.{whose}", "1", Population::all, Repeats::exactly, "modelled misses per query of a machine's level in the steady state"},
    {"fields.table_bytes.{whose}", "B", Population::none, Repeats::exactly, "bytes of all tables"},
    {"fields.time_ratio.{whose}", "1", Population::all, Repeats::timed, "time divided by the time of own_groups, or of original if no groups give it: median over interleaved rounds"},
    {"fields.time_ratio_low.{whose}", "1", Population::all, Repeats::timed, "lower end of the ratio's 95 % interval over the rounds of one process"},
    {"fields.time_ratio_high.{whose}", "1", Population::all, Repeats::timed, "upper end of the ratio's 95 % interval over the rounds of one process"},
    {"fields.lines_held", "1", Population::all, Repeats::exactly, "1: the built table reads the predicted number of lines, fewer than the table asked about; otherwise 0"},
    {"fields.time_held", "1", Population::all, Repeats::timed, "1: faster by more than the noise; 0: within the noise; -1: slower"},
};
// clang-format on

}  // namespace vocabulary
}  // namespace edgewise::store
