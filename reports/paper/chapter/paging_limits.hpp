// SPDX-License-Identifier: MIT
//
// Rows of the paging run, limit by limit.
#pragma once

#include <vector>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

/// What one limit of a paging row says; null where the store has no value.
struct PagingLimit {
    measure::Figure limit, held, faults, predicted_at_held, predicted_at_limit, us;
};

/// In the order of the store's numbers, until one is not there.
[[nodiscard]] std::vector<PagingLimit> paging_limits(const ReportCell& row);

}  // namespace edgewise::reports
