// SPDX-License-Identifier: MIT
//
// A trace told again as if its tables' fields lay elsewhere, access by access in the same order: what the
// queries would read of a table with other records. Computed, from the groups alone; what a table that was
// built so really reads is traced beside it.
#pragma once

#include <cstdint>
#include <vector>

#include "edgewise/layout_parts/field_groups.hpp"
#include "edgewise/measure/cache/trace.hpp"
#include "edgewise/studies/fields/field_trace.hpp"

namespace edgewise::studies {

class FieldPlaces {
  public:
    FieldPlaces() = default;
    FieldPlaces(const FieldPlaces&) = delete;
    FieldPlaces& operator=(const FieldPlaces&) = delete;
    virtual ~FieldPlaces() = default;

    /// Tells of all that is read for a field: its value, and before it what leads there. `as_was`: the access
    /// in the trace.
    virtual void tell(const measure::TracedAccess& as_was, const FieldAccess& field,
                      measure::TraceListener& listener) const = 0;

    /// Bytes from the first table's start to the last one's end.
    [[nodiscard]] virtual std::uint64_t taken() const = 0;
};

/// Records by groups in one block a table, the tables one after another in an arena: the layout `grouped`.
class GroupedPlaces final : public FieldPlaces {
  public:
    GroupedPlaces(const std::vector<TableFields>& tables, const FieldGroups& groups);

    void tell(const measure::TracedAccess& as_was, const FieldAccess& field,
              measure::TraceListener& listener) const override;
    [[nodiscard]] std::uint64_t taken() const override { return taken_; }

  private:
    struct Column {
        std::uint64_t first = 0, stride = 0;
    };
    std::vector<std::vector<Column>> columns_;  ///< by table and field
    std::uint64_t taken_ = 0;
};

/// What lies behind the tables (pairs' caches, the broad phase) moves with their end.
void replay(const FieldTrace& trace, const FieldPlaces& places, measure::TraceListener& listener);

}  // namespace edgewise::studies
