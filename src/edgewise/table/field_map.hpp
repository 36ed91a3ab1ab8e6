// SPDX-License-Identifier: MIT
//
// A map from a table's memory to the fields of its records. A trace of addresses uses it to find the field
// and the edge of a read, and the address that the field would have in other groups.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace edgewise {

/// A field of a table's records: the smallest unit that a layout can keep elsewhere.
struct RecordField {
    std::string_view name, record;  ///< for example "tail_plane" of an "edge"
    std::uint32_t bytes = 0, alignment = 1;

    [[nodiscard]] bool operator==(const RecordField&) const = default;
};

/// A field of one record, or a part of the field where its scalars are scattered.
struct FieldPlace {
    std::uint64_t at = 0;       ///< bytes from the start of the tables' memory
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
