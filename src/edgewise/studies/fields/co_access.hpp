// SPDX-License-Identifier: MIT
//
// Which fields are read together: by the same query, by the same step of its algorithm, and of the same
// record in the same step. The last is what a record can use: two fields of an edge that a step reads of the
// same edge may share its line; two that it reads of different edges cannot.
#pragma once

#include <cstdint>
#include <vector>

#include "edgewise/studies/fields/field_trace.hpp"

namespace edgewise::studies {

/// How often fields a and b were both read, at [a][b] and [b][a]; how often a was, at [a][a].
using FieldCounts = std::vector<std::vector<std::uint64_t>>;

struct CoAccess {
    FieldCounts by_query;                  ///< queries
    FieldCounts by_step;                   ///< steps
    FieldCounts by_record;                 ///< records in steps; 0 for fields of different records
    std::uint64_t queries = 0, steps = 0;  ///< steps: those that read of a table

    /// Of all that read a or b, the part that read both (Jaccard); 0 where nobody reads either.
    [[nodiscard]] static double overlap(const FieldCounts& counts, std::size_t a, std::size_t b);
};

/// Reads before a query's first step are a step of their own. The two tables of a pair are not told apart by
/// fields, and never share a record.
[[nodiscard]] CoAccess co_access(const FieldTrace& trace);

}  // namespace edgewise::studies
