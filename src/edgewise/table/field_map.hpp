// SPDX-License-Identifier: MIT
//
// Which field of which record lies where in a table's memory: what tells a trace of addresses what was read
// of which edge, and where it would have been had the fields been grouped otherwise.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace edgewise {

/// A field of a table's records: the least that a layout can keep elsewhere.
struct RecordField {
    std::string_view name, record;  ///< "tail_plane" of an "edge"
    std::uint32_t bytes = 0, alignment = 1;

    [[nodiscard]] bool operator==(const RecordField&) const = default;
};

/// A field of one record, or a part of it where its scalars are scattered.
struct FieldPlace {
    std::uint64_t at = 0;       ///< bytes from where the tables' memory starts
    std::uint32_t element = 0;  ///< which record of its kind
    std::uint8_t field = 0;     ///< number in FieldMap::fields
    std::uint8_t part = 0;      ///< bytes of the field before this part
    std::uint8_t bytes = 0;
};

struct FieldMap {
    std::vector<RecordField> fields;
    std::vector<FieldPlace> places;
};

}  // namespace edgewise
