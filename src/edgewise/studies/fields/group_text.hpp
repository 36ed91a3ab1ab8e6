// SPDX-License-Identifier: MIT
//
// Groups of fields as text: JSON for files, {"groups": [["tail_plane", "head_plane"], ["direction"]]}, and
// one line for people and for the store, "tail_plane,head_plane|direction".
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "edgewise/layout_parts/field_groups.hpp"
#include "edgewise/table/field_map.hpp"

namespace edgewise::studies {

[[nodiscard]] std::string groups_text(const FieldGroups& groups, std::span<const RecordField> fields);
[[nodiscard]] nlohmann::json groups_json(const FieldGroups& groups, std::span<const RecordField> fields);

/// Reads a file in the format of groups_json, with every field once and one kind of record per group.
/// Throws std::invalid_argument: file, what is wrong, which groups are expected.
[[nodiscard]] FieldGroups read_groups(const std::string& file, std::span<const RecordField> fields);

}  // namespace edgewise::studies
