// SPDX-License-Identifier: MIT
//
// Node is spawned with an argument list, never through a shell, so a path is only ever a
// path.
#include "edgewise/reports/page/page.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "edgewise/input/file_text.hpp"
#include "edgewise/input/json_text.hpp"
#include "edgewise/input/output_file.hpp"
#include "edgewise/input/shown_text.hpp"
#include "edgewise/measure/process/child_process.hpp"
#include "edgewise/reports/answer/answer_text.hpp"
#include "edgewise/reports/page/html.hpp"
#include "edgewise/reports/results/export.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/store/schema.hpp"

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

/// Returns the chart with only the rows of `tables`. If it has no such row, returns it unchanged.
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
        input::write_output(folder / (chart.name + ".vl.json"),
                            input::json_text(of_tables(chart, tables)) + "\n");
        again.push_back(chart.name);
    }
    if (!again.empty() && render(again, folder, bundles).empty())
        for (const Chart& chart : charts)
            if (const auto svg = input::read_file_text(folder / (chart.name + ".svg"))) keep(chart, *svg);
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
        input::write_output(figures / (chart.name + ".vl.json"), input::json_text(chart.spec) + "\n");
        names.push_back(chart.name);
    }
    StaticPictures result;
    if (names.empty()) return result;
    result.note = render(names, figures, bundles);
    if (!result.note.empty())
        result.note = "No static pictures of the charts: " + result.note +
                      " (install nodejs 18 or newer and the chart bundles, then write the report again).";
    for (const std::string& name : names)
        if (auto svg = input::read_file_text(figures / (name + ".svg"))) result.svg[name] = std::move(*svg);
    add_stills(charts, tables, figures, bundles, result);
    return result;
}

namespace {

namespace fs = std::filesystem;

/// Empty when the PDF is there, else why not. A PDF bears a date, which the store does not have: 0.
std::string convert(const fs::path& svg, const fs::path& pdf) {
    const auto outcome =
        measure::run_program({"env", "SOURCE_DATE_EPOCH=0", "rsvg-convert", "--format", "pdf", svg.string()});
    if (!outcome.value) return "env cannot be started: " + outcome.reason;
    if (outcome.value->exit_code == 127) return "rsvg-convert is not installed (Debian: librsvg2-bin)";
    if (outcome.value->exit_code != 0)
        return fmt::format("rsvg-convert ended with exit code {}", outcome.value->exit_code);
    input::write_output(pdf, outcome.value->out);
    return {};
}

std::string pdf_of(const Chart& chart, const StaticPictures& pictures, const fs::path& figures) {
    if (!pictures.svg.contains(chart.name)) return "there is no SVG to make it from";
    return convert(figures / (chart.name + ".svg"), figures / (chart.name + ".pdf"));
}

/// The sweeps that this build put into the store, as commands.
std::string commands_of(const ReportData& data) {
    std::string lines;
    for (const auto& [command, build] : data.meta_with(store::command_key))
        if (build == data.build.id) lines += "    edgewise " + command + "\n";
    if (!lines.empty()) return lines;
    return fmt::format("    (the store does not say; it is of plan {}, seed {})\n",
                       data.meta_value("plan").value_or("?"), data.meta_value("seed").value_or("?"));
}

/// The scenes that the points are of, by name and text.
std::string scenes_of(const ReportData& data, const Chart& chart) {
    std::set<std::string> names;
    for (const ChartJson& point : chart.points)
        if (const auto scene = point.find("scene"); scene != point.end() && scene->is_string())
            names.insert(scene->get<std::string>());
    std::string lines;
    for (const auto& [name, text] : data.scene_files)
        if (names.contains(name)) lines += fmt::format("    {}: {}\n", name, text);
    return lines;
}

std::string figure_text(const ReportData& data, const Chart& chart, const std::string& no_pdf) {
    std::string text = chart.title + "\n\n" + chart.how_to_read + "\n\n";
    for (const std::string& note : chart.notes) text += note + "\n";
    text += fmt::format("{}.csv has the {} that are drawn. Scenes:\n", chart.name,
                        plural(chart.points.size(), "point"));
    text += scenes_of(data, chart) + "\nCommands, in this order:\n" + commands_of(data);
    text += "    edgewise report STORE --out FOLDER\n";
    text += no_pdf.empty()
                ? fmt::format("    rsvg-convert --format pdf --output {0}.pdf {0}.svg\n", chart.name)
                : fmt::format("No {}.pdf: {}.\n", chart.name, no_pdf);
    const store::BuildRow& build = data.build;
    return text + fmt::format("\nBuild {}: revision {}, {}, {}, {}\nProcessor: {}\n", build.id,
                              build.git_revision, build.compiler, build.build_type, build.flags,
                              processor_text(data));
}

}  // namespace

std::string points_csv(const ChartJson& points) {
    std::vector<std::string> columns;
    for (const ChartJson& point : points)
        for (const auto& [name, value] : point.items())
            if (std::ranges::find(columns, name) == columns.end()) columns.push_back(name);
    CsvRow header;
    for (const std::string& name : columns) header.text(name);
    std::string text = header.line();
    for (const ChartJson& point : points) {
        CsvRow row;
        for (const std::string& name : columns) row.field(point.value(name, ChartJson()));
        text += row.line();
    }
    return text;
}

std::string write_cited_figures(const ReportData& data, const std::vector<Chart>& charts,
                                const StaticPictures& pictures, const fs::path& out) {
    const fs::path figures = out / "figures";
    std::string note;
    for (const Chart& chart : charts) {
        if (!chart.is_cited) continue;
        std::error_code ignored;
        for (const char* type : {".pdf", ".csv", ".txt"}) fs::remove(figures / (chart.name + type), ignored);
        if (chart.spec.is_null()) continue;
        input::write_output(figures / (chart.name + ".csv"), points_csv(chart.points));
        const std::string no_pdf = pdf_of(chart, pictures, figures);
        input::write_output(figures / (chart.name + ".txt"),
                            input::shown_text(figure_text(data, chart, no_pdf)));
        if (!no_pdf.empty()) note = "No PDF of the figures to cite: " + no_pdf + ".";
    }
    return note;
}

}  // namespace edgewise::reports
