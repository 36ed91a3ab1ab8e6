// SPDX-License-Identifier: MIT
//
// Groups of the fields of nodes of which a trace's queries read fewer lines. Nodes lie where an allocator
// puts them, one kind between another, and a node's further records cost a pointer: what one kind's groups
// cost depends on all others, so this is a search from the nodes as they are, by moves of one field (to
// another place in its record, to another record, to one of its own), each judged by telling the trace again.
// It ends where no move saves a line, which need not be the best there is.
#pragma once

#include "edgewise/layout_parts/field_groups.hpp"
#include "edgewise/studies/fields/field_trace.hpp"

namespace edgewise::studies {

/// Queries that each move is judged by: the first ones.
inline constexpr std::uint64_t judged_queries = 300;

[[nodiscard]] FieldGroups best_node_groups(const FieldTrace& trace);

/// Of `linked`: a record for each kind of node, its fields in the order of the structs.
[[nodiscard]] FieldGroups whole_nodes();

}  // namespace edgewise::studies
