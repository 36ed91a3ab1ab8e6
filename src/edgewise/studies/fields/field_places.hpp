// SPDX-License-Identifier: MIT
//
// Replays a trace as if its tables' fields lay elsewhere, access by access in the same order: the reads of
// the same queries on a table with other records. They are computed from the groups alone; the reads of a
// table that was really built this way are traced separately.
#pragma once

#include <cstdint>
#include <vector>

#include "edgewise/layout_parts/field_groups.hpp"
#include "edgewise/measure/cache/trace.hpp"
#include "edgewise/studies/fields/field_trace.hpp"

namespace edgewise::studies {

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
