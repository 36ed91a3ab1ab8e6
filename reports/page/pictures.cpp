// SPDX-License-Identifier: MIT
//
// Node is spawned with an argument list, never through a shell, so a path is only ever a
// path.
#include "edgewise/reports/page/pictures.hpp"

#include <fmt/core.h>

#include "edgewise/measure/process/child_process.hpp"
#include "edgewise/reports/page/bundles.hpp"
#include "edgewise/reports/page/files.hpp"

namespace edgewise::reports {

namespace {

/// Empty when node has drawn them, else why not.
std::string render(const std::vector<std::string>& names, const std::filesystem::path& figures,
                   const std::filesystem::path& bundles) {
    const std::filesystem::path script = bundles / "render_svg.mjs";
    if (!std::filesystem::exists(script) || !have_bundles(bundles)) return "the chart bundles are not there";
    std::vector<std::string> command{"node", std::filesystem::absolute(script).string(),
                                     std::filesystem::absolute(bundles).string(),
                                     std::filesystem::absolute(figures).string()};
    command.insert(command.end(), names.begin(), names.end());
    const auto outcome = measure::run_program(command);
    if (!outcome.value) return "node cannot be started: " + outcome.reason;
    const int code = outcome.value->exit_code;
    return code == 0 ? "" : fmt::format("node ended with exit code {}", code);
}

}  // namespace

StaticPictures write_pictures(const std::vector<Chart>& charts, const std::filesystem::path& out,
                              const std::filesystem::path& bundles) {
    const std::filesystem::path figures = out / "figures";
    std::error_code ignored;
    std::filesystem::create_directories(figures, ignored);
    std::vector<std::string> names;
    for (const Chart& chart : charts) {
        std::filesystem::remove(figures / (chart.name + ".svg"), ignored);
        std::filesystem::remove(figures / (chart.name + ".vl.json"), ignored);
        if (chart.spec.is_null()) continue;
        write_file(figures / (chart.name + ".vl.json"), spec_text(chart) + "\n");
        names.push_back(chart.name);
    }
    StaticPictures result;
    if (names.empty()) return result;
    result.note = render(names, figures, bundles);
    if (!result.note.empty())
        result.note = "No static pictures of the charts: " + result.note +
                      " (install nodejs 18 or newer and the chart bundles, then write the report again).";
    for (const std::string& name : names)
        if (auto svg = read_file(figures / (name + ".svg"))) result.svg[name] = std::move(*svg);
    return result;
}

}  // namespace edgewise::reports
