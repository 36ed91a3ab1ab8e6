// SPDX-License-Identifier: MIT
//
// The line under the title; declared in page.hpp.
#include <fmt/core.h>

#include <algorithm>

#include "edgewise/reports/page/page.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

std::string stability_line(const ReportData& data) {
    if (data.stability.empty()) return {};
    const auto failed = std::count_if(data.stability.begin(), data.stability.end(),
                                      [](const ReportCell& row) { return row.status == "failed"; });
    return fmt::format(" Of {}, {} failed.", plural(data.stability.size(), "stability row"), failed);
}

}  // namespace

std::string verdict_line(const ReportData& data) {
    const std::size_t failed = data.count("failed"), unavailable = data.count("unavailable");
    const std::size_t verified = data.count("verified");
    std::string cells = failed == 0 && unavailable == 0
                            ? fmt::format("All {} verified.", plural(verified, "cell"))
                            : fmt::format("{} verified, {} failed, {} unavailable.", plural(verified, "cell"),
                                          failed, unavailable);
    if (data.cell_count() == 0) cells = "No cells.";
    return cells + stability_line(data);
}

}  // namespace edgewise::reports
