// SPDX-License-Identifier: MIT
//
// Node is spawned with an argument list, never through a shell, so a path is only ever a
// path.
#include "edgewise/reports/page/pictures.hpp"

#include <fmt/core.h>

#include "edgewise/measure/process/child_process.hpp"
#include "edgewise/reports/page/bundles.hpp"
#include "edgewise/reports/page/files.hpp"
#include "edgewise/reports/page/safe_svg.hpp"

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

/// Returns the chart with only the rows of these tables, or unchanged if no row is of them.
ChartJson of_tables(const Chart& chart, const std::set<std::string>& tables) {
    ChartJson kept = ChartJson::array();
    for (const ChartJson& row : chart.points)
        if (row.contains("table") && tables.contains(row["table"].get<std::string>())) kept.push_back(row);
    ChartJson spec = chart.spec;
    if (!kept.empty() && spec.contains("data")) spec["data"]["values"] = kept;
    return spec;
}

/// Adds slimmed pictures; a picture that is still too large is drawn again with a few table types.
void add_stills(const std::vector<Chart>& charts, const std::set<std::string>& tables,
                const std::filesystem::path& figures, const std::filesystem::path& bundles,
                StaticPictures& pictures) {
    const std::filesystem::path folder = figures / "still";
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
    std::vector<std::string> again;
    const auto keep = [&](const Chart& chart, const std::string& svg) {
        std::string slim = slim_svg(svg, chart.title + ". " + chart.how_to_read);
        if (slim.size() > most_still_bytes) return false;
        pictures.still[chart.name] = std::move(slim);
        return true;
    };
    for (const Chart& chart : charts) {
        const auto svg = pictures.svg.find(chart.name);
        if (svg == pictures.svg.end() || keep(chart, svg->second)) continue;
        Chart few = chart;
        few.spec = of_tables(chart, tables);
        write_file(folder / (chart.name + ".vl.json"), spec_text(few) + "\n");
        again.push_back(chart.name);
    }
    if (!again.empty() && render(again, folder, bundles).empty())
        for (const Chart& chart : charts)
            if (const auto svg = read_file(folder / (chart.name + ".svg"))) keep(chart, *svg);
    std::filesystem::remove_all(folder, ignored);
}

}  // namespace

StaticPictures write_pictures(const std::vector<Chart>& charts, const std::set<std::string>& tables,
                              const std::filesystem::path& out, const std::filesystem::path& bundles) {
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
    add_stills(charts, tables, figures, bundles, result);
    return result;
}

}  // namespace edgewise::reports
