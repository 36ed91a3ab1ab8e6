// SPDX-License-Identifier: MIT
//
// One figure over several rows of the store: a sum of counts, or the worst.
#pragma once

#include <vector>

#include "edgewise/reports/reader.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

struct SummaryColumn {
    const char* title;
    store::FigureName figure;
    bool sum;  ///< add up, else take the worst
};

/// Over the rows that have the figure; says so where some lack it.
[[nodiscard]] GridCell summary_cell(const std::vector<const ReportCell*>& rows, const SummaryColumn& column);

}  // namespace edgewise::reports
