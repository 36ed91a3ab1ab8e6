// SPDX-License-Identifier: MIT
#include "edgewise/reports/answer/sweep_runs.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "edgewise/input/json_text.hpp"
#include "edgewise/store/schema.hpp"

namespace edgewise::reports {

std::vector<SweepRun> sweep_runs(const ReportData& data) {
    const std::string prefix = store::run_key;
    std::vector<SweepRun> runs;
    for (const auto& [key, value] : data.meta) {
        if (!key.starts_with(prefix)) continue;
        const auto json = input::json_or_null(value);
        const auto text = [&](const char* name) {
            return json.is_object() && json.contains(name) && json[name].is_string()
                       ? json[name].get<std::string>()
                       : std::string();
        };
        if (text("build") != data.build.id) continue;
        const auto count = [&](const char* name) {
            return json.contains(name) && json[name].is_number_unsigned() ? json[name].get<std::size_t>() : 0;
        };
        runs.push_back(
            {key.substr(prefix.size()), count("cells"), count("done"), text("started"), text("ended")});
    }
    return runs;
}

bool any_unfinished(const std::vector<SweepRun>& runs) {
    return std::any_of(runs.begin(), runs.end(), [](const SweepRun& run) { return !run.finished(); });
}

std::size_t missing_cells(const std::vector<SweepRun>& runs) {
    std::size_t missing = 0;
    for (const SweepRun& run : runs)
        if (!run.finished() && run.planned > run.done) missing += run.planned - run.done;
    return missing;
}

}  // namespace edgewise::reports
