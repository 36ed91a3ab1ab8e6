// SPDX-License-Identifier: MIT
#include "edgewise/reports/answer/sweep_runs.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "edgewise/store/schema.hpp"

namespace edgewise::reports {

std::vector<SweepRun> sweep_runs(const ReportData& data) {
    const std::string prefix = store::run_key;
    std::vector<SweepRun> runs;
    for (const auto& [key, value] : data.meta) {
        if (!key.starts_with(prefix)) continue;
        const auto json = nlohmann::json::parse(value, nullptr, false);
        const auto text = [&](const char* name) {
            return json.is_object() && json.contains(name) && json[name].is_string()
                       ? json[name].get<std::string>()
                       : std::string();
        };
        if (text("build") != data.build.id) continue;
        const bool counted = json.contains("cells") && json["cells"].is_number_unsigned();
        runs.push_back({key.substr(prefix.size()), counted ? json["cells"].get<std::size_t>() : 0,
                        text("started"), text("ended")});
    }
    return runs;
}

std::size_t missing_cells(const std::vector<SweepRun>& runs, std::size_t stored) {
    std::size_t planned = 0;
    for (const SweepRun& run : runs)
        if (!run.finished()) planned = std::max(planned, run.planned);
    return planned > stored ? planned - stored : 0;
}

}  // namespace edgewise::reports
