// SPDX-License-Identifier: MIT
//
// The study of figure 8: where its facts hold (the region of the queries alone), and the cells that were made
// real.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/paper/chapter/thrash_study.hpp"
#include "edgewise/reports/paper/charts/paper_charts.hpp"

namespace edgewise::reports {

namespace {

std::string facts_text(unsigned facts) {
    constexpr std::pair<unsigned, const char*> names[] = {
        {rises, "rises"}, {takes_as_long, "takes as long"}, {spares_gjk, "spares GJK"}, {erratic, "erratic"}};
    std::vector<std::string> held;
    for (const auto& [fact, name] : names)
        if ((facts & fact) != 0) held.emplace_back(name);
    return held.empty() ? "none" : fmt::format("{}", fmt::join(held, ", "));
}

}  // namespace

Chart paper_region_chart(const ReportData& data) {
    Chart chart = chart_of_file("paper_thrash_region");
    ChartRows rows;
    for (const ThrashRow& row : thrash_rows(data)) {
        if (row.mechanism != "queries_alone") continue;
        for (const ScoredSetting& setting : row.settings)
            rows.values.push_back({{"tables", row.tables()},
                                   {"fault_us", setting.fault_ns / 1000},
                                   {"bodies", setting.bodies},
                                   {"memory", setting.memory_mib},
                                   {"facts", __builtin_popcount(setting.facts)},
                                   {"which", facts_text(setting.facts)}});
    }
    return drawn_chart(std::move(chart), data, std::move(rows), ChartJson::object(), "setting");
}

Chart paper_realised_chart(const ReportData& data) {
    Chart chart = chart_of_file("paper_thrash_realised");
    ChartRows rows;
    for (const RealisedRow& row : realised_rows(data)) {
        if (!row.cell->verified()) rows.omitted.add(row.cell->reason);
        for (const RealisedRow::Point& point : row.points)
            rows.values.push_back(
                {{"cell", row.what},
                 {"curve", fmt::format("{}, {} vertices", row.cell->algorithm, row.cell->vertices)},
                 {"speed", point.speed},
                 {"measured", point.measured_us},
                 {"predicted", point.predicted_us}});
    }
    return drawn_chart(std::move(chart), data, std::move(rows), ChartJson::object(), "point");
}

}  // namespace edgewise::reports
