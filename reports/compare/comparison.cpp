// SPDX-License-Identifier: MIT
#include "edgewise/reports/compare/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/answer/answer.hpp"
#include "edgewise/reports/answer/answer_text.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

namespace {

using measure::ComparedRow, measure::Outcome;

constexpr const char* time_figure = "time.all_ratio";
constexpr store::FigureName steps_figure("error.mean_steps"), lines_figure("lines.lines_per_query");

std::string key_of(const ReportCell& cell) {
    return fmt::format("{} {} {} {} {}", cell.scene, cell.scene_parameters, cell.shape, cell.algorithm,
                       cell.table);
}

/// Figures compared exactly: costs that a layout or an algorithm decides, each less when it is better.
constexpr store::FigureName exact_costs[] = {
    "error.mean_steps",           "error.fallbacks",        "lines.lines_per_query", "lines.reads_per_query",
    "bytes.total_bytes_per_edge", "bytes.table_bytes",      "bytes.voronoi_planes",  "bytes.edge_geometry",
    "bytes.vertex_coordinates",   "bytes.face_planes",      "bytes.topology",        "bytes.padding",
    "bytes.pair_bytes",           "error.worst_error_given"};

void add_rows(const ReportCell& cell, std::vector<measure::RecordRow>& rows) {
    const std::string key = key_of(cell);
    const auto add = [&](std::string figure, const measure::Figure& value) {
        if (value.value) rows.push_back({key, std::move(figure), *value.value});
    };
    for (const store::FigureName& name : exact_costs)
        add(name.probe() + "." + name.name(), cell.figure(name));
    for (const store::FigureRow& figure : cell.figures)  // by machine and level
        if (figure.probe == "caches" && figure.name.ends_with(".misses_per_query"))
            add("caches." + figure.name, figure);
    if (const auto timed = ranked_cell(cell, 1))
        rows.push_back({key, time_figure, timed->ratio, timed->low(), timed->high(), true});
}

measure::FigureRecord record_of(const ReportData& data, double slack) {
    measure::FigureRecord record{"store",
                                 {},
                                 {{"seed", data.meta_value("seed").value_or("?")},
                                  {"bodies", "as they are"},
                                  {"processor", processor_text(data)},
                                  {"compiler", data.build.compiler},
                                  {"flags", data.build.flags},
                                  {"build type", data.build.build_type},
                                  {"source", data.build.git_revision}},
                                 slack,
                                 {}};
    for (const ReportCell* cell : data.swept()) add_rows(*cell, record.rows);
    return record;
}

/// The baseline's own cells are timed in the same rounds as the baseline, so their difference is noise.
void widen_noise(const ReportData& data, StoreComparison& comparison) {
    const Baseline baseline = baseline_of(data);
    for (const ReportCell* cell : data.swept()) {
        if (!baseline.is(cell->algorithm, cell->table)) continue;
        const auto itself = ranked_cell(*cell, 1);
        if (!itself) continue;
        comparison.noise_low = std::min(comparison.noise_low, itself->ratio);
        comparison.noise_high = std::max(comparison.noise_high, itself->ratio);
    }
}

/// Returns true if the cells that both stores have are of the same bodies. Another seed makes other bodies,
/// and is a condition of its own.
bool has_same_bodies(const ReportData& before, const ReportData& after) {
    std::map<std::string, const ReportCell*> cells;
    for (const ReportCell* cell : before.swept()) cells.emplace(key_of(*cell), cell);
    return std::ranges::all_of(after.swept(), [&](const ReportCell* cell) {
        const auto was = cells.find(key_of(*cell));
        return was == cells.end() || was->second->hash == cell->hash || was->second->seed != cell->seed;
    });
}

/// Rows of one cell, by figure.
using CellRows = std::map<std::string, const ComparedRow*>;

/// The factors of a change of time: steps, lines per step, time per line.
std::string factors_text(const ComparedRow& time, const CellRows& cell) {
    const auto change = [&](const store::FigureName& figure) {
        const auto row = cell.find(figure.probe() + "." + figure.name());
        return row == cell.end() ? 0 : row->second->change();
    };
    const double steps = change(steps_figure), lines = change(lines_figure);
    if (!(steps > 0 && lines > 0))
        return "what it is made of is not known: no steps or lines in one of the stores";
    const bool exact_same = std::ranges::all_of(cell, [](const auto& row) {
        return row.second->outcome == Outcome::equal || row.second->is.has_interval;
    });
    return fmt::format("= {:.3f} (steps) x {:.3f} (lines per step) x {:.3f} (time per line){}", steps,
                       lines / steps, time.change() / lines,
                       exact_same ? "; no exact figure of the cell changed: code or machine" : "");
}

void explain_times(measure::RecordComparison& found) {
    std::map<std::string, CellRows> cells;
    for (const ComparedRow& row : found.rows) cells[row.is.cell][row.is.figure] = &row;
    for (ComparedRow& row : found.rows)
        if (row.is.figure == time_figure && row.outcome != Outcome::missing && row.outcome != Outcome::added)
            row.note = factors_text(row, cells[row.is.cell]);
}

void name_cells(measure::RecordComparison& found, const ReportData& before, const ReportData& after) {
    std::map<std::string, std::string> titles;
    for (const ReportData* data : {&after, &before})
        for (const ReportCell* cell : data->swept())
            titles.emplace(key_of(*cell), fmt::format("{} {} {} {}", cell->scene_label, cell->shape,
                                                      cell->algorithm, cell->table));
    for (ComparedRow& row : found.rows) row.was.cell = row.is.cell = titles.at(row.is.cell);
}

// Documents of the formats: github.com/benchmark-action/github-action-benchmark (README, custom benchmarks),
// bencher.dev/docs/reference/bencher-metric-format, and the JUnit XML that CI servers read.

using measure::RecordComparison;
using Json = nlohmann::ordered_json;

/// A row of the table in a pull request.
struct HeadRow {
    const char* name;
    std::size_t count = 0;
    std::vector<double> changes = {};  ///< ratios; a change from or to 0 has none
};

bool is_number_in_both(const ComparedRow& row) {
    return row.outcome != Outcome::missing && row.outcome != Outcome::added && row.is.text.empty() &&
           row.was.text.empty();
}

std::string percent(double change) { return fmt::format("{:+.1f} %", 100 * (change - 1)); }

/// The geometric mean.
std::string mean_text(const std::vector<double>& changes) {
    double logarithms = 0;
    for (const double change : changes) logarithms += std::log(change);
    return changes.empty() ? "" : percent(std::exp(logarithms / static_cast<double>(changes.size())));
}

std::string range_text(const std::vector<double>& changes) {
    if (changes.empty()) return "";
    const auto [least, most] = std::ranges::minmax(changes);
    return fmt::format("{} to {}", percent(least), percent(most));
}

std::string markdown(const RecordComparison& found, const std::string& old_name) {
    HeadRow head[] = {{"regressions of exact figures"},
                      {"improvements of exact figures"},
                      {"regressions of times"},
                      {"improvements of times"},
                      {"missing, new, or another word"}};
    for (const ComparedRow& row : found.rows) {
        if (row.outcome >= Outcome::within) continue;
        const std::size_t place = (row.is.has_interval ? 2 : 0) + (row.is.value < row.was.value ? 1 : 0);
        HeadRow& in = head[is_number_in_both(row) ? place : 4];
        ++in.count;
        if (is_number_in_both(row) && row.change() > 0) in.changes.push_back(row.change());
    }
    TextGrid grid{"", columns_of("what changed|#mean|#range|#count")};
    for (const HeadRow& row : head)
        if (row.count > 0) grid.add(row.name, mean_text(row.changes), range_text(row.changes), row.count);
    const std::string text = to_text(found, old_name);
    const std::size_t verdict = text.rfind('\n', text.size() - 2) + 1;  // the last line
    return fmt::format(
        "{}{}\n\n<details><summary>Rows that differ, and possible causes</summary>\n\n```\n{}"
        "```\n\n</details>\n",
        grid.rows.empty() ? "" : grid_markdown(grid),
        markdown_text(text.substr(verdict, text.size() - verdict - 1)), text);
}

/// The cell's name; for a record with one cell, "lean" of "locks/lean.lock.json".
std::string cell_of(const ComparedRow& row, const std::string& old_name) {
    const std::string file = std::filesystem::path(old_name).filename().string();
    return row.is.cell.empty() ? file.substr(0, file.find('.')) : row.is.cell;
}

/// The unit that a figure's name ends with or begins with; the chart of github-action-benchmark needs one.
std::string unit_of(const measure::RecordRow& row) {
    if (row.has_interval) return "ratio";
    for (const char* unit : {"bytes_per_edge", "bytes", "misses", "lines", "reads", "steps", "queries"})
        if (row.figure.find(unit) != std::string::npos) return unit;
    return "1";
}

std::string github(const RecordComparison& found, const std::string& old_name) {
    Json figures = Json::array();
    for (const ComparedRow& row : found.rows) {
        if (!is_number_in_both(row)) continue;
        Json one = {{"name", cell_of(row, old_name) + ": " + row.is.figure},
                    {"unit", unit_of(row.is)},
                    {"value", row.is.value}};
        if (row.is.has_interval) one["range"] = fmt::format("{:.4g} to {:.4g}", row.is.low, row.is.high);
        one["extra"] = to_text(row);
        figures.push_back(std::move(one));
    }
    return input::json_text(figures, 2) + "\n";
}

std::string bencher(const RecordComparison& found, const std::string& old_name) {
    Json cells = Json::object();
    for (const ComparedRow& row : found.rows) {
        if (!is_number_in_both(row)) continue;
        Json& figure = cells[cell_of(row, old_name)][row.is.figure];
        figure["value"] = row.is.value;
        if (!row.is.has_interval) continue;
        figure["lower_value"] = row.is.low;
        figure["upper_value"] = row.is.high;
    }
    return input::json_text(cells, 2) + "\n";
}

std::string junit(const RecordComparison& found, const std::string& old_name) {
    std::string cases;
    std::size_t tests = 0, failures = 0;
    const auto add = [&](const std::string& cell, const std::string& name, const std::string& why) {
        cases += fmt::format("    <testcase classname=\"{}\" name=\"{}\"", html_text(cell), html_text(name));
        cases += why.empty() ? "/>\n" : fmt::format("><failure>{}</failure></testcase>\n", html_text(why));
        ++tests;
        failures += !why.empty();
    };
    for (const ComparedRow& row : found.rows)
        add(cell_of(row, old_name), row.is.figure.empty() ? "cell" : row.is.figure,
            found.fails(row) ? to_text(row) : "");
    for (const std::string& fault : found.faults) add("fault", fault, fault);
    if (found.compared() == 0) add("records", "something is compared", "nothing in common");
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n  <testsuite name=\"{}\" tests=\"{}\" "
        "failures=\"{}\">\n{}  </testsuite>\n</testsuites>\n",
        html_text(old_name), tests, failures, cases);
}

}  // namespace

StoreComparison compare(const ReportData& before, const ReportData& after, double slack) {
    StoreComparison comparison;
    widen_noise(before, comparison);
    widen_noise(after, comparison);
    const double noise = comparison.noise_high / comparison.noise_low - 1;
    const measure::FigureRecord was = record_of(before, std::max(slack, noise));
    measure::FigureRecord is = record_of(after, slack);
    if (!has_same_bodies(before, after)) is.with[1].second = "others";
    comparison.found = compare(was, is);
    explain_times(comparison.found);
    name_cells(comparison.found, before, after);
    return comparison;
}

std::string noise_text(const StoreComparison& comparison) {
    return fmt::format(
        "times are ratios to the baseline of the same run; its own cells differ from it by {:.2f} to {:.2f}\n",
        comparison.noise_low, comparison.noise_high);
}

std::string ci_text(const RecordComparison& found, const std::string& format, const std::string& old_name) {
    return format == ci_markdown  ? markdown(found, old_name)
           : format == ci_github  ? github(found, old_name)
           : format == ci_bencher ? bencher(found, old_name)
                                  : junit(found, old_name);
}

}  // namespace edgewise::reports
