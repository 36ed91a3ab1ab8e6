// SPDX-License-Identifier: MIT
#include "edgewise/reports/paper/chapter/paging_limits.hpp"

#include <algorithm>
#include <string>

namespace edgewise::reports {

std::vector<PagingLimit> paging_limits(const ReportCell& row) {
    std::vector<PagingLimit> limits;
    for (int i = 0;; ++i) {
        const std::string number = std::to_string(i);
        const std::string limit = store::FigureName("paging.limit_bytes.{limit}").of(number).name();
        const auto is_limit = [&](const store::FigureRow& figure) {
            return figure.probe == "paging" && figure.name == limit;
        };
        if (std::none_of(row.figures.begin(), row.figures.end(), is_limit)) return limits;
        const auto figure = [&](const store::FigureName& name) { return row.figure(name.of(number)); };
        limits.push_back(
            {figure("paging.limit_bytes.{limit}"), figure("paging.held_bytes.{limit}"),
             figure("paging.faults_per_query.{limit}"), figure("paging.predicted_at_held.{limit}"),
             figure("paging.predicted_at_limit.{limit}"), figure("paging.us_per_query.{limit}")});
    }
}

}  // namespace edgewise::reports
