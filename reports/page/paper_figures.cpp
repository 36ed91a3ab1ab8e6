// SPDX-License-Identifier: MIT
#include "edgewise/reports/page/paper_figures.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "edgewise/input/json_text.hpp"
#include "edgewise/input/shown_text.hpp"
#include "edgewise/measure/process/child_process.hpp"
#include "edgewise/reports/page/files.hpp"
#include "edgewise/reports/results/csv_row.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/store/schema.hpp"

namespace edgewise::reports {

namespace {

namespace fs = std::filesystem;

void add_field(CsvRow& row, const ChartJson& value) {
    if (value.is_number())
        row.number(value.get<double>());
    else if (value.is_string())
        row.text(value.get<std::string>());
    else
        row.text(value.is_null() ? "" : value.dump());
}

/// Empty when the PDF is there, else why not. A PDF bears a date, which the store does not have: 0.
std::string convert(const fs::path& svg, const fs::path& pdf) {
    const auto outcome =
        measure::run_program({"env", "SOURCE_DATE_EPOCH=0", "rsvg-convert", "--format", "pdf", svg.string()});
    if (!outcome.value) return "env cannot be started: " + outcome.reason;
    if (outcome.value->exit_code == 127) return "rsvg-convert is not installed (Debian: librsvg2-bin)";
    if (outcome.value->exit_code != 0)
        return fmt::format("rsvg-convert ended with exit code {}", outcome.value->exit_code);
    write_file(pdf, outcome.value->out);
    return {};
}

std::string pdf_of(const Chart& chart, const StaticPictures& pictures, const fs::path& figures) {
    if (!pictures.svg.contains(chart.name)) return "there is no SVG to make it from";
    return convert(figures / (chart.name + ".svg"), figures / (chart.name + ".pdf"));
}

/// The sweeps that this build put into the store, as commands.
std::string commands_of(const ReportData& data) {
    std::string lines;
    const std::string prefix = store::command_key;
    for (const auto& [key, value] : data.meta) {
        if (key.starts_with(prefix) && value == data.build.id)
            lines += "    edgewise " + key.substr(prefix.size()) + "\n";
    }
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

std::string cpu_of(const ReportData& data) {
    const auto machine = input::json_or_null(data.build.machine_json);
    const auto cpu = machine.is_object() ? machine.value("cpu", nlohmann::json()) : nlohmann::json();
    if (cpu.is_string()) return cpu;
    return cpu.is_object() ? cpu.value("name", "unknown") : "unknown";
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
                              cpu_of(data));
}

}  // namespace

std::string points_csv(const ChartJson& points) {
    std::vector<std::string> columns;
    for (const ChartJson& point : points)
        for (const auto& [name, value] : point.items())
            if (std::find(columns.begin(), columns.end(), name) == columns.end()) columns.push_back(name);
    CsvRow header;
    for (const std::string& name : columns) header.text(name);
    std::string text = header.line();
    for (const ChartJson& point : points) {
        CsvRow row;
        for (const std::string& name : columns) add_field(row, point.value(name, ChartJson()));
        text += row.line();
    }
    return text;
}

std::string write_paper_figures(const ReportData& data, const std::vector<Chart>& charts,
                                const StaticPictures& pictures, const fs::path& out) {
    const fs::path figures = out / "figures";
    std::string note;
    for (const Chart& chart : charts) {
        if (chart.figure == 0) continue;
        std::error_code ignored;
        for (const char* type : {".pdf", ".csv", ".txt"}) fs::remove(figures / (chart.name + type), ignored);
        if (chart.spec.is_null()) continue;
        write_file(figures / (chart.name + ".csv"), points_csv(chart.points));
        const std::string no_pdf = pdf_of(chart, pictures, figures);
        write_file(figures / (chart.name + ".txt"), input::shown_text(figure_text(data, chart, no_pdf)));
        if (!no_pdf.empty()) note = "No PDF of the paper's figures: " + no_pdf + ".";
    }
    return note;
}

}  // namespace edgewise::reports
