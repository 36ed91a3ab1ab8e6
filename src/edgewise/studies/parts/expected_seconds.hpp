// SPDX-License-Identifier: MIT
//
// Expected time of the runs besides the sweep if no store has it: seconds on two cores of one
// machine. Only progress and the weights of shards use these numbers; those of a sweep's own groups are in
// sweep/expected_work.hpp.
#pragma once

namespace edgewise::studies {

inline constexpr double stability_case_seconds = 0.0007,  ///< of a row, per hard case of its family
    paging_row_seconds = 6,                               ///< mostly of waiting for a disk
    thrash_unit_seconds = 5,                              ///< a scene traced for figure 8
    effort_query_seconds = 0.02,                          ///< of a row, per query under Callgrind
    fields_cell_seconds = 10;

}  // namespace edgewise::studies
