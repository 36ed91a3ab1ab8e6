// SPDX-License-Identifier: MIT
//
// Finds the groups of fields for which a trace's queries read the fewest lines: an exact search, not a rule
// of thumb. A group is an array of records, and arrays begin on lines of their own, so one group's cost does
// not depend on the others; the best way to part n fields into groups then follows from the cost of each of
// their 2^n - 1 sets (dynamic programming over sets). Only the order of fields within a group, where it
// decides which of them share a line, is found by exchanging two at a time.
//
// Vertical partitioning by affinity (Navathe et al., 1984; Chilimbi, Davidson and Larus, 1999, for
// structures) takes the counts of CoAccess for a model of the cost. We count the lines themselves.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>

#include "edgewise/layout_parts/field_groups.hpp"
#include "edgewise/studies/fields/field_trace.hpp"
#include "edgewise/table/field_map.hpp"

namespace edgewise::studies {

/// Number of queries that the search reads: the first ones of the trace.
inline constexpr std::uint64_t searched_queries = 2000;

/// Returns the best groups. Fields that no query reads form a group of their own, one for each kind of
/// record. Among equal numbers of lines fewer bytes win, then fewer groups.
[[nodiscard]] FieldGroups best_groups(const FieldTrace& trace);

/// Returns the groups that a table has now; nothing if fields of its records do not follow each other at one
/// distance, or are scattered scalar by scalar.
[[nodiscard]] std::optional<FieldGroups> groups_of(const FieldMap& map);

// Groups of fields as text: JSON for files, {"groups": [["tail_plane", "head_plane"], ["direction"]]}, and
// one line for people and for the store, "tail_plane,head_plane|direction".

[[nodiscard]] std::string groups_text(const FieldGroups& groups, std::span<const RecordField> fields);
[[nodiscard]] nlohmann::json groups_json(const FieldGroups& groups, std::span<const RecordField> fields);

/// Reads a file in the format of groups_json, with every field once and one kind of record per group.
/// Throws std::invalid_argument: file, what is wrong, which groups are expected.
[[nodiscard]] FieldGroups read_groups(const std::string& file, std::span<const RecordField> fields);

}  // namespace edgewise::studies
