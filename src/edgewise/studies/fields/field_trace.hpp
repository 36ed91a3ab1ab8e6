// SPDX-License-Identifier: MIT
//
// A trace that keeps accesses to tables as fields of records, not as addresses: the field and the
// edge that were read. It can be replayed as if the fields lay elsewhere.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "edgewise/bench/runner.hpp"
#include "edgewise/bench/trace/trace_extent.hpp"
#include "edgewise/layout_parts/field_groups.hpp"
#include "edgewise/measure/cache/trace.hpp"
#include "edgewise/table/field_map.hpp"

namespace edgewise::studies {

/// One access to a field of a table's record.
struct FieldAccess {
    std::uint32_t table = 0, element = 0;
    std::uint8_t field = 0, part = 0;  ///< as in FieldPlace

    [[nodiscard]] bool operator==(const FieldAccess&) const = default;
};

/// One event of a trace.
struct FieldEvent {
    enum class Kind : std::uint8_t { query_start, step_start, field, other, query_end, frame_end };

    Kind kind = Kind::frame_end;
    measure::QueryStart start{};     ///< of a query's start
    bool counts = false;             ///< of a query's end
    FieldAccess field = {};          ///< of a field
    measure::TracedAccess access{};  ///< of an access: as it was; of a step's start, its step
};

/// Fields of a table's records, and how many records have each.
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

/// Traces a runner with a loaded workload. Throws std::invalid_argument if its layout does not say where its
/// fields lie, or if the runner reads memory that is no field.
[[nodiscard]] FieldTrace trace_fields(const bench::Runner& runner, const bench::TraceExtent& extent,
                                      const std::string& table);

// Replays a trace as if its tables' fields lay elsewhere, access by access in the same order: the reads of
// the same queries on a table with other records. They are computed from the groups alone; the reads of a
// table that was really built this way are traced separately.

/// Records by groups in one block a table, the tables one after another in an arena: the layout `grouped`.
class GroupedPlaces {
  public:
    GroupedPlaces(const std::vector<TableFields>& tables, const FieldGroups& groups);

    /// Returns the address of the field.
    [[nodiscard]] std::uint64_t address(const FieldAccess& field) const {
        const Column& column = columns_[field.table][field.field];
        return column.first + field.element * column.stride + field.part;
    }

    /// Bytes from the first table's start to the last one's end.
    [[nodiscard]] std::uint64_t taken() const { return taken_; }

  private:
    struct Column {
        std::uint64_t first = 0, stride = 0;
    };
    std::vector<std::vector<Column>> columns_;  ///< by table and field
    std::uint64_t taken_ = 0;
};

/// Replays the trace. Everything behind the tables (pairs' caches, the broad phase) moves with their end.
void replay(const FieldTrace& trace, const GroupedPlaces& places, measure::TraceListener& listener);

}  // namespace edgewise::studies
