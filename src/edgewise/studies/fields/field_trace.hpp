// SPDX-License-Identifier: MIT
//
// A trace whose accesses to tables are told as fields of records, not as addresses: what was read of which
// edge. So it can be told again as if the fields lay elsewhere (field_places.hpp).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "edgewise/bench/runner.hpp"
#include "edgewise/bench/trace/trace_extent.hpp"
#include "edgewise/measure/cache/trace.hpp"
#include "edgewise/table/field_map.hpp"

namespace edgewise::studies {

/// One access to a field of a table's record.
struct FieldAccess {
    std::uint32_t table = 0, element = 0;
    std::uint8_t field = 0, part = 0;  ///< as in FieldPlace

    [[nodiscard]] bool operator==(const FieldAccess&) const = default;
};

/// What a trace is made of.
struct FieldEvent {
    enum class Kind : std::uint8_t { query_start, step_start, field, other, query_end, frame_end };

    Kind kind = Kind::frame_end;
    measure::QueryStart start{};     ///< of a query's start
    bool counts = false;             ///< of a query's end
    FieldAccess field = {};          ///< of a field
    measure::TracedAccess access{};  ///< of an access: as it was; of a step's start, its step
};

/// What a table's records are: their fields, and how many records have each.
struct TableFields {
    std::vector<RecordField> fields;
    std::vector<std::uint32_t> records;  ///< by field

    [[nodiscard]] std::size_t count() const { return fields.size(); }
};

struct FieldTrace {
    std::vector<FieldMap> maps;       ///< of the tables
    std::vector<TableFields> tables;  ///< the same in short
    std::vector<FieldEvent> events;
    std::uint64_t taken = 0;  ///< bytes of memory from the first table's start to the last one's end
    std::uint64_t queries = 0;

    [[nodiscard]] const std::vector<RecordField>& fields() const { return tables.front().fields; }
};

/// Of a runner that a workload was loaded into. Throws std::invalid_argument where its layout does not say
/// where its fields lie, or reads what is none.
[[nodiscard]] FieldTrace trace_fields(const bench::Runner& runner, const bench::TraceExtent& extent,
                                      const std::string& table);

}  // namespace edgewise::studies
