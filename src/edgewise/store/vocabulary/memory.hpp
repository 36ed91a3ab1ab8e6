// SPDX-License-Identifier: MIT
//
// Figures about memory: what tables take, what queries touch of it, what caches make of that, and paging.
#pragma once

#include "edgewise/store/vocabulary/figure_info.hpp"

namespace edgewise::store::vocabulary {

// One figure a line.
// clang-format off
inline constexpr FigureInfo memory[] = {
    {"bytes.voronoi_planes", "B/edge", Population::none, Repeats::exactly, "Voronoi planes stored"},
    {"bytes.edge_geometry", "B/edge", Population::none, Repeats::exactly, "directions and lengths of edges"},
    {"bytes.vertex_coordinates", "B/edge", Population::none, Repeats::exactly, "coordinates of vertices"},
    {"bytes.face_planes", "B/edge", Population::none, Repeats::exactly, "planes of faces"},
    {"bytes.topology", "B/edge", Population::none, Repeats::exactly, "indices, rings, offsets and links"},
    {"bytes.input_order", "B/edge", Population::none, Repeats::exactly, "which vertex of the user's list each vertex is, where the table keeps it"},
    {"bytes.padding", "B/edge", Population::none, Repeats::exactly, "bytes that hold nothing"},
    {"bytes.paper_bytes_per_edge", "B/edge", Population::none, Repeats::exactly, "slope of the paper's subtotal (Voronoi planes, edge geometry, coordinates) per additional edge"},
    {"bytes.total_bytes_per_edge", "B/edge", Population::none, Repeats::exactly, "the whole table over the shape's edges"},
    {"bytes.slope_bytes_per_edge", "B/edge", Population::none, Repeats::exactly, "slope of the whole table per additional edge"},
    {"bytes.table_bytes", "B", Population::none, Repeats::exactly, "the whole table"},
    {"bytes.object_bytes", "B", Population::none, Repeats::exactly, "the table's object beside its block: what its user holds"},
    {"bytes.constant_bytes", "B", Population::none, Repeats::exactly, "the object, and the intercept of the whole table's slope: what a body costs before its first edge"},
    {"bytes.pair_bytes", "B", Population::none, Repeats::exactly, "what a pair keeps from one query to the next"},

    {"lines.lines_per_query.{start}", "lines", Population::named, Repeats::exactly, "the next, of queries that start so"},
    {"lines.lines_per_query", "lines", Population::all, Repeats::exactly, "distinct cache lines of 64 bytes that a query reads of both tables"},
    {"lines.line_bytes_per_query.{start}", "B", Population::named, Repeats::exactly, "the next, of queries that start so"},
    {"lines.line_bytes_per_query", "B", Population::all, Repeats::exactly, "the bytes of these lines"},
    {"lines.read_bytes_per_query.{start}", "B", Population::named, Repeats::exactly, "the next, of queries that start so"},
    {"lines.read_bytes_per_query", "B", Population::all, Repeats::exactly, "distinct bytes that a query asks for"},
    {"lines.reads_per_query.{start}", "reads", Population::named, Repeats::exactly, "the next, of queries that start so"},
    {"lines.reads_per_query", "reads", Population::all, Repeats::exactly, "reads of both tables"},

    {"caches.misses_per_query", "misses", Population::all, Repeats::exactly, "stands alone, with the reason, where nothing was traced"},
    {"caches.identity", "1", Population::none, Repeats::exactly, "hash of what was modelled: the machines, and how many queries"},
    {"caches.{machine}.{level}.misses_per_query.{start}", "misses", Population::named, Repeats::exactly, "the next, of queries that start so"},
    {"caches.{machine}.{level}.misses_per_query", "misses", Population::all, Repeats::exactly, "modelled misses of the steady pass; a machine with /POLICY: under that replacement"},
    {"caches.{machine}.{level}.capacity_per_query.{start}", "misses", Population::named, Repeats::exactly, "the next, of queries that start so"},
    {"caches.{machine}.{level}.capacity_per_query", "misses", Population::all, Repeats::exactly, "of these, misses that a fully associative cache of that size has too"},
    {"caches.{machine}.{level}.conflict_per_query.{start}", "misses", Population::named, Repeats::exactly, "the next, of queries that start so"},
    {"caches.{machine}.{level}.conflict_per_query", "misses", Population::all, Repeats::exactly, "of these, misses for want of ways"},
    {"caches.{machine}.{level}.first_pass_misses_per_query", "misses", Population::all, Repeats::exactly, "misses of the first pass, which starts with empty caches and fills them"},
    {"caches.{machine}.{level}.compulsory_per_query", "misses", Population::all, Repeats::exactly, "of the first pass, misses of lines never touched before"},
    {"caches.{machine}.{level}.misses_per_edge", "misses", Population::all, Repeats::exactly, "misses of the steady pass per query and edge of the shape"},
    {"caches.{machine}.{level}.cold_verified", "1", Population::all, Repeats::exactly, "compulsory misses over first touches: 1 when the first pass did start with empty caches"},
    {"caches.{machine}.{level}.emptied_misses_per_query.{start}", "misses", Population::named, Repeats::exactly, "the next, of queries that start so"},
    {"caches.{machine}.{level}.emptied_misses_per_query", "misses", Population::all, Repeats::exactly, "misses when caches are emptied before each query, of tables alone"},
    {"caches.{machine}.{level}.field.{field}.{start}", "misses", Population::named, Repeats::exactly, "the next, of queries that start so"},
    {"caches.{machine}.{level}.field.{field}", "misses", Population::all, Repeats::exactly, "misses per query of the steady pass, by what was read"},
    {"caches.{machine}.{level}.step.{step}.{start}", "misses", Population::named, Repeats::exactly, "the next, of queries that start so"},
    {"caches.{machine}.{level}.step.{step}", "misses", Population::all, Repeats::exactly, "misses per query of the steady pass, by the algorithm's step that read"},
    {"caches.{machine}.fetched_bytes_per_query", "B", Population::all, Repeats::exactly, "bytes brought into the first level"},
    {"caches.{machine}.unused_bytes_per_query", "B", Population::all, Repeats::exactly, "of these, bytes never read before they left"},
    {"caches.{machine}.modelled_memory_ns.{start}", "ns, model", Population::named, Repeats::exactly, "the next, of queries that start so"},
    {"caches.{machine}.modelled_memory_ns", "ns, model", Population::all, Repeats::exactly, "misses times latencies per query; the unit says when a latency is not verified"},

    {"reuse.lines_per_query.{start}", "lines", Population::named, Repeats::exactly, "the next, of queries that start so"},
    {"reuse.lines_per_query", "lines", Population::all, Repeats::exactly, "lines of 64 bytes that a query touches, of all that the scene keeps"},
    {"reuse.lines_of_scene", "lines", Population::all, Repeats::exactly, "distinct lines in the whole pass"},
    {"reuse.lines_of_body", "lines", Population::all, Repeats::exactly, "lines per table"},
    {"reuse.lines_of_frame", "lines", Population::all, Repeats::exactly, "distinct lines per frame"},
    {"reuse.line_knee_bytes.{start}", "B", Population::named, Repeats::exactly, "the next, of queries that start so"},
    {"reuse.line_knee_bytes", "B", Population::all, Repeats::exactly, "the cache below which the scene thrashes, in lines"},
    {"reuse.line_misses_at_2^{power}.{start}", "misses", Population::named, Repeats::exactly, "the next, of queries that start so"},
    {"reuse.line_misses_at_2^{power}", "misses", Population::all, Repeats::exactly, "misses per query of lines in a fully associative LRU cache of 2^power bytes"},
    {"reuse.pages_per_query.{start}", "pages", Population::named, Repeats::exactly, "the next, of queries that start so"},
    {"reuse.pages_per_query", "pages", Population::all, Repeats::exactly, "pages of 4 KiB that a query touches"},
    {"reuse.pages_of_scene", "pages", Population::all, Repeats::exactly, "distinct pages in the whole pass"},
    {"reuse.pages_of_body", "pages", Population::all, Repeats::exactly, "pages per table"},
    {"reuse.pages_of_frame", "pages", Population::all, Repeats::exactly, "distinct pages per frame"},
    {"reuse.page_knee_bytes.{start}", "B", Population::named, Repeats::exactly, "the next, of queries that start so"},
    {"reuse.page_knee_bytes", "B", Population::all, Repeats::exactly, "the memory below which the scene thrashes, in pages"},
    {"reuse.page_misses_at_2^{power}.{start}", "misses", Population::named, Repeats::exactly, "the next, of queries that start so"},
    {"reuse.page_misses_at_2^{power}", "misses", Population::all, Repeats::exactly, "misses per query of pages in a fully associative LRU memory of 2^power bytes"},

    {"heat.touched_part", "1", Population::all, Repeats::exactly, "part of the tables' bytes that the scene ever touches"},
    {"heat.touched_bytes", "B", Population::all, Repeats::exactly, "these bytes"},
    {"heat.lines_of_half_the_accesses", "lines", Population::all, Repeats::exactly, "fewest lines that take half of the accesses"},
    {"heat.lines_of_most_accesses", "lines", Population::all, Repeats::exactly, "fewest lines that take 90 % of the accesses"},
    {"heat.lines", "lines", Population::all, Repeats::exactly, "lines accessed at all"},
    {"heat.touched_vertices", "1", Population::all, Repeats::exactly, "part of the vertices that the scene ever touches"},
    {"heat.touched_edges", "1", Population::all, Repeats::exactly, "part of the edges"},
    {"heat.touched_faces", "1", Population::all, Repeats::exactly, "part of the faces"},
    {"heat.touched_{component}", "1", Population::all, Repeats::exactly, "part of this component's bytes (names as in bytes.*) that the scene ever touches"},
    {"heat.lines_of_query.{start}", "lines", Population::named, Repeats::exactly, "the next, of queries that start so"},
    {"heat.lines_of_query", "lines", Population::all, Repeats::exactly, "distinct lines of tables that a query accesses"},
    {"heat.accesses.{field}.{start}", "accesses", Population::named, Repeats::exactly, "the next, of queries that start so"},
    {"heat.accesses.{field}", "accesses", Population::all, Repeats::exactly, "accesses per query, by what was read"},

    {"memory.tables", "tables", Population::none, Repeats::exactly, "tables of the scene"},
    {"memory.requested_bytes", "B", Population::none, Repeats::exactly, "bytes that all tables ask for"},
    {"memory.taken_bytes", "B", Population::none, Repeats::timed, "bytes that these take in the allocator"},
    {"memory.resident_bytes", "B", Population::none, Repeats::timed, "bytes of pages that are really there"},
    {"memory.materialised", "1", Population::none, Repeats::exactly, "part of the tables that ever stood; less than 1 in lazy ones"},

    {"heap.{structure}.requested_bytes", "B", Population::none, Repeats::exactly, "bytes asked for by one table, the caches of all pairs or the broad phase's arrays"},
    {"heap.{structure}.size_class_bytes", "B", Population::none, Repeats::timed, "what these take in jemalloc's size classes"},
    {"heap.{structure}.slack_bytes", "B", Population::none, Repeats::timed, "size classes less what was asked for"},
    {"heap.{structure}.resident_bytes", "B", Population::none, Repeats::timed, "pages of the structure's own arena"},

    {"paging.table_bytes", "B", Population::none, Repeats::exactly, "bytes of all tables"},
    {"paging.touched_bytes", "B", Population::all, Repeats::exactly, "pages that a pass touches, in bytes"},
    {"paging.keeps_recency", "1", Population::none, Repeats::timed, "1 when the kernel keeps track of which pages were used last"},
    {"paging.limit_bytes.{limit}", "B", Population::none, Repeats::exactly, "memory limit number {limit}"},
    {"paging.predicted_at_limit.{limit}.{start}", "faults", Population::named, Repeats::exactly, "the next, of queries that start so"},
    {"paging.predicted_at_limit.{limit}", "faults", Population::all, Repeats::exactly, "faults per query that reuse distances predict for the limit"},
    {"paging.held_bytes.{limit}", "B", Population::all, Repeats::timed, "bytes of tables that were really held"},
    {"paging.predicted_at_held.{limit}", "faults", Population::all, Repeats::timed, "faults per query predicted for what was held"},
    {"paging.faults_per_query.{limit}", "faults", Population::all, Repeats::timed, "faults per query that the kernel counted"},
    {"paging.us_per_query.{limit}", "us", Population::all, Repeats::timed, "time per query under the limit"},
};
// clang-format on

}  // namespace edgewise::store::vocabulary
