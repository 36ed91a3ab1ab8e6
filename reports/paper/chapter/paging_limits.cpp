// SPDX-License-Identifier: MIT
//
// See paging_limits.hpp.
#include "edgewise/reports/paper/chapter/paging_limits.hpp"

#include <algorithm>
#include <string>

namespace edgewise::reports {

std::vector<PagingLimit> paging_limits(const ReportCell& row) {
    std::vector<PagingLimit> limits;
    for (int i = 0;; ++i) {
        const std::string end = "." + std::to_string(i);
        const auto is_limit = [&](const store::FigureRow& figure) {
            return figure.probe == "paging" && figure.name == "limit_bytes" + end;
        };
        if (std::none_of(row.figures.begin(), row.figures.end(), is_limit)) return limits;
        const auto figure = [&](const char* name) { return row.figure("paging", name + end); };
        limits.push_back({figure("limit_bytes"), figure("held_bytes"), figure("faults_per_query"),
                          figure("predicted_at_held"), figure("predicted_at_limit"), figure("us_per_query")});
    }
}

}  // namespace edgewise::reports
