// SPDX-License-Identifier: MIT
//
// Counts fields that are read together: by the same query, by the same step of its algorithm, and of the same
// record in the same step. Only the last matters for a record: two fields may share a line if a step reads
// both of the same edge, not if it reads them of different edges.
#pragma once

#include <cstdint>
#include <vector>

#include "edgewise/studies/fields/field_trace.hpp"

namespace edgewise::studies {

/// [a][b] and [b][a]: number of times that fields a and b were both read; [a][a]: that field a was read.
using FieldCounts = std::vector<std::vector<std::uint64_t>>;

struct CoAccess {
    FieldCounts by_query;                  ///< queries
    FieldCounts by_step;                   ///< steps
    FieldCounts by_record;                 ///< records in steps; 0 for fields of different records
    std::uint64_t queries = 0, steps = 0;  ///< steps: those that read of a table

    /// Returns the share of the reads of a or b that read both (Jaccard); 0 if neither is read.
    [[nodiscard]] static double overlap(const FieldCounts& counts, std::size_t a, std::size_t b);
};

/// Counts which fields are read together. Reads before a query's first step form a step of their own. Fields
/// of a pair's two tables count as the same fields, but never share a record.
[[nodiscard]] CoAccess co_access(const FieldTrace& trace);

}  // namespace edgewise::studies
