// SPDX-License-Identifier: MIT
//
// Tables about the cells themselves (scenes, problems, the full list), and what ran, on what machine, built
// how. The program that wrote the store decides what the JSON of the machine holds: members next to those
// that the store promises (cpu, caches, counters) are shown as they are.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/store/schema.hpp"

namespace edgewise::reports {

namespace {

/// Cells of one shape with one reason: a mesh that is not there is one problem, not hundreds.
struct Problem {
    std::set<std::string> scenes, algorithms, tables;
    std::size_t cells = 0;
};

/// The name, or how many there are.
std::string one_or_many(const std::set<std::string>& names, const char* noun) {
    return names.size() == 1 ? *names.begin() : plural(names.size(), noun);
}

void add_status(TextGrid& grid, const ReportData& data, store::CellStatus status) {
    std::vector<std::pair<std::string, std::string>> order;
    std::map<std::pair<std::string, std::string>, Problem> problems;
    for (const ReportCell* row : data.rows()) {
        if (row->status != status) continue;
        const auto key = std::make_pair(row->shape, row->reason);
        Problem& problem = problems[key];
        if (problem.cells++ == 0) order.push_back(key);
        problem.scenes.insert(row->scene_label);
        problem.algorithms.insert(row->algorithm);
        problem.tables.insert(row->table);
    }
    for (const auto& key : order) {
        const Problem& problem = problems[key];
        grid.add(to_string(status), problem.cells, one_or_many(problem.scenes, "scene"), key.first,
                 one_or_many(problem.algorithms, "algorithm"), one_or_many(problem.tables, "table type"),
                 key.second.empty() ? std::string("no reason stored") : key.second);
    }
}

}  // namespace

const store::QueryTime& times_of(PairKind kind) {
    return kind == PairKind::Separated ? store::separated_time : store::overlapping_time;
}

std::string pair_name(PairKind kind) { return kind == PairKind::Separated ? "separated" : "overlapping"; }

std::vector<const ReportCell*> verified_cells(const ReportData& data, const std::string& shape,
                                              const std::string& scene_label) {
    std::vector<const ReportCell*> cells;
    for (const ReportCell* cell : data.swept())
        if (cell->verified() && (shape.empty() || cell->shape == shape) &&
            (scene_label.empty() || cell->scene_label == scene_label))
            cells.push_back(cell);
    return cells;
}

std::vector<std::string> scene_labels(const ReportData& data) {
    std::vector<std::string> labels;
    for (const ReportCell* cell : data.swept())
        if (std::ranges::find(labels, cell->scene_label) == labels.end()) labels.push_back(cell->scene_label);
    return labels;
}

std::vector<std::pair<std::int64_t, std::string>> shapes_by_vertices(const ReportData& data) {
    std::set<std::pair<std::int64_t, std::string>> shapes;
    for (const ReportCell* cell : data.swept()) shapes.emplace(cell->vertices, cell->shape);
    return {shapes.begin(), shapes.end()};
}

TextGrid scenes_grid(const ReportData& data) {
    TextGrid grid{"", columns_of("scene|parameters|#cells|#queries per cell")};
    for (const std::string& label : scene_labels(data)) {
        std::size_t cells = 0;
        std::int64_t least = 0, most = 0;
        std::string parameters;
        for (const ReportCell* cell : data.swept()) {
            if (cell->scene_label != label) continue;
            least = cells == 0 ? cell->queries : std::min(least, cell->queries);
            most = std::max(most, cell->queries);
            parameters = cell->scene_parameters;
            ++cells;
        }
        const std::string queries =
            least == most ? std::to_string(most) : std::to_string(least) + " to " + std::to_string(most);
        grid.add(label, parameters, cells, queries);
    }
    return grid;
}

TextGrid problems_grid(const ReportData& data) {
    TextGrid grid{"", columns_of("status|#cells|scene|shape|algorithm|table type|reason")};
    add_status(grid, data, store::CellStatus::failed);
    add_status(grid, data, store::CellStatus::unavailable);
    return grid;
}

namespace {

using FactsJson = nlohmann::json;

/// A row for each member; the machine says why one is not known.
TextGrid members_grid(std::string caption, const FactsJson& facts, const FactsJson& unreadable) {
    FactsJson rows = FactsJson::array();
    if (facts.is_object())
        for (const auto& [key, value] : facts.items())
            rows.push_back({{"fact", key}, {"value", value}, {"reason", input::member_of(unreadable, key)}});
    if (!facts.is_object() && !facts.is_null()) rows.push_back({{"fact", caption}, {"value", facts}});
    TextGrid grid = member_grid(rows, "fact|value");
    grid.caption = std::move(caption), grid.shown_rows = rows.size();
    return grid;
}

void add(TextGrid& grid, const std::string& key, const std::string& value) {
    grid.rows.push_back({{key}, value.empty() ? missing_cell("not stored") : GridCell{value}});
}

std::string seeds(const ReportData& data) {
    std::map<std::uint64_t, std::size_t> distinct;
    for (const ReportCell* cell : data.swept()) ++distinct[cell->seed];
    std::string out;
    std::size_t shown = 0;
    for (const auto& [seed, cells] : distinct) {
        if (++shown > 4) return out + fmt::format(", ... ({} in all)", distinct.size());
        append(out, std::to_string(seed));
    }
    return out;
}

}  // namespace

std::vector<TextGrid> machine_grids(const FactsJson& machine) {
    const auto part = [&](const char* key) { return input::member_of(machine, key); };
    FactsJson further = machine;
    for (const char* apart : {"cpu", "caches", "cores", "counters", "unreadable"})
        if (further.is_object()) further.erase(apart);
    TextGrid caches = member_grid(
        part("caches"),
        "#cache level = level|type|#bytes|#ways|#line = line_bytes|#sets|shared by = shared_cpus");
    TextGrid counters = member_grid(part("counters"), "event|level|by|#counted = value|unit|meaning");
    caches.caption = "Caches", counters.caption = "Hardware counters";
    counters.shown_rows = counters.rows.size();
    TextGrid facts = members_grid("Processor", part("cpu"), part("unreadable"));
    const TextGrid others = members_grid("Machine", further, part("unreadable"));
    FactsJson kinds = FactsJson::object();  // none in stores of earlier versions
    for (const auto& kind : part("cores"))
        kinds[fmt::format("cores {}", kind.value("processors", ""))] =
            fmt::format("{}; allowed: {}; {}", kind.value("caches", ""), kind.value("allowed", ""),
                        kind.value("bind", ""));
    const TextGrid cores = members_grid("", kinds, {});
    facts.rows.insert(facts.rows.end(), cores.rows.begin(), cores.rows.end());
    facts.rows.insert(facts.rows.end(), others.rows.begin(), others.rows.end());
    facts.caption = others.caption;
    facts.shown_rows = facts.rows.size();
    return {std::move(facts), std::move(caches), std::move(counters)};
}

TextGrid facts_grid(const ReportData& data) {
    TextGrid grid{"", columns_of("fact|value")};
    add(grid, "compiler", data.build.compiler);
    add(grid, "flags", data.build.flags);
    add(grid, "build type", data.build.build_type);
    add(grid, "git revision", data.build.git_revision);
    add(grid, "build", data.build.id);
    add(grid, "seed", seeds(data));
    bool plan = false;
    for (const auto& [key, value] : data.meta) {
        constexpr const char* elsewhere[] = {store::drawing_key, store::scene_file_key, store::scene_path_key,
                                             store::peer_key,    store::run_key,        store::layout_key,
                                             store::body_key,    store::heat_key,       store::study_key,
                                             store::took_key,    store::others_key};
        if (std::ranges::any_of(elsewhere, [&](const char* start) { return key.starts_with(start); }) ||
            key == "build" || key == "seed" || key == store::shard_key || key == store::complete_key)
            continue;
        if (key.starts_with(store::command_key)) {
            if (value == data.build.id)
                add(grid, "filled by", "edgewise " + key.substr(std::string(store::command_key).size()));
            continue;
        }
        plan = plan || key == "plan";
        add(grid, key, value);
    }
    if (!plan) add(grid, "plan", "");
    std::string others;
    for (const std::string& id : data.other_builds) append(others, id);
    if (!others.empty()) add(grid, "other builds in the store, not shown", others);
    return grid;
}

// The tables of errors and of the stability run. Sums and worst values run over the cells that have the
// figure; how many lack it is shown.

namespace {

using Rows = std::vector<const ReportCell*>;

struct SummaryColumn : FigureColumn {
    bool sum;  ///< add up over cells, else take the worst
};

const SummaryColumn error_columns[] = {{{"checked", "error.checked"}, true},
                                       {{"separated", "error.separated"}, true},
                                       {{"touching", "error.touching"}, true},
                                       {{"overlapping", "error.overlapping"}, true},
                                       {{"worst error, given bodies", "error.worst_error_given"}, false},
                                       {{"worst error, stored bodies", "error.worst_error_stored"}, false},
                                       {{"p99 error, stored bodies", "error.p99_error_stored"}, false},
                                       {{"witness error", "error.witness_error"}, false},
                                       {{"wrong verdicts", "error.wrong_verdicts"}, true},
                                       {{"verdicts in band", "error.verdicts_in_band"}, true},
                                       {{"fallbacks", "error.fallbacks"}, true},
                                       {{"refinements", "error.refinements"}, true},
                                       {{"escapes", "error.escapes"}, true},
                                       {{"cycles", "error.cycles"}, true},
                                       {{"mean steps", "error.mean_steps"}, false},
                                       {{"max steps", "error.max_steps"}, false}};

const SummaryColumn stability_columns[] = {
    {{"cases", "stability.cases"}, true},
    {{"refused", "stability.refused"}, true},
    {{"in the band", "stability.in_band"}, true},
    {{"wrong verdicts outside the band", "stability.wrong_outside_band"}, true},
    {{"differing inside the band", "stability.wrong_inside_band"}, true},
    {{"errors beyond the bound", "stability.errors_beyond"}, true},
    {{"worst error beyond the band", "stability.worst_error"}, false},
    {{"p99.9 error beyond the band", "stability.p999_error"}, false},
    {{"witness error beyond the bound", "stability.worst_witness_error"}, false},
    {{"depth error beyond the bound", "stability.worst_depth_error"}, false},
    {{"depths beyond the bound", "stability.depths_beyond"}, true},
    {{"cap hits", "stability.cap_hits"}, true},
    {{"certificate width", "stability.worst_certificate_width"}, false},
    {{"certificates that miss", "stability.certificates_missed"}, true},
    {{"asked of the control", "stability.control_asked"}, true},
    {{"control disagrees", "stability.control_disagrees"}, true},
    {{"... outside the band", "stability.control_disagrees_outside_band"}, true},
    {{"control wrong", "stability.control_wrong"}, true},
    {{"escapes", "stability.escapes"}, true},
    {{"cycles", "stability.cycles"}, true},
    {{"fallbacks", "stability.fallbacks"}, true},
    {{"refinements", "stability.refinements"}, true},
    {{"max steps", "stability.max_steps"}, false}};

/// Sums up a figure over the rows that have it; the cell says how many rows lack it.
GridCell summary_cell(const Rows& rows, const SummaryColumn& column) {
    measure::Figure total{column.figure.name(), std::nullopt, ""};
    std::size_t missing = 0;
    for (const ReportCell* cell : rows) {
        const measure::Figure figure = cell->figure(column.figure);
        if (!figure.value) {
            ++missing;
            if (!total.value) total.reason = figure.reason, total.remedy = figure.remedy;
            continue;
        }
        const double so_far = total.value.value_or(*figure.value);
        const bool first = !total.value;
        total.value = column.sum && !first ? so_far + *figure.value : std::max(so_far, *figure.value);
        total.unit = figure.unit;
    }
    GridCell shown = figure_cell(total);
    if (total.value && missing) shown.text += fmt::format(" ({} of {})", rows.size() - missing, rows.size());
    return shown;
}

/// A row for each algorithm and table type: its names, `counts` of its cells, and its columns.
template <class Columns, class Counts>
void add_summary(TextGrid& grid, const Rows& cells, const Columns& columns, const Counts& counts) {
    std::map<std::pair<std::string, std::string>, Rows> groups;
    for (const ReportCell* cell : cells) groups[{cell->algorithm, cell->table}].push_back(cell);
    for (const auto& [name, rows] : groups) {
        std::vector<GridCell> row = grid_row(name.first, name.second);
        for (const auto count : counts(rows)) row.push_back(grid_cell(count));
        for (const SummaryColumn& column : columns) row.push_back(summary_cell(rows, column));
        grid.rows.push_back(std::move(row));
    }
}

}  // namespace

TextGrid error_summary_grid(const ReportData& data) {
    TextGrid grid = figure_grid("Over all verified cells: sums of counts, worst of the rest",
                                "algorithm|table type|#cells", error_columns);
    add_summary(grid, verified_cells(data), error_columns,
                [](const Rows& rows) { return std::array{rows.size()}; });
    return grid;
}

TextGrid error_grid(const ReportData& data) {
    return cell_grid("Every cell", "scene|shape|algorithm|table type|status", error_columns, data.swept());
}

TextGrid stability_summary_grid(const ReportData& data) {
    TextGrid grid = figure_grid("Over all families: sums of counts, worst of the rest",
                                "algorithm|table type|#families|#failed", stability_columns);
    add_summary(grid, cells_in({&data.stability}), stability_columns, [](const Rows& rows) {
        const auto failed = std::ranges::count_if(rows, [](const ReportCell* row) { return row->failed(); });
        return std::array{rows.size(), static_cast<std::size_t>(failed)};
    });
    return grid;
}

TextGrid stability_grid(const ReportData& data) {
    return cell_grid("Family by family", "family|algorithm|table type|status", stability_columns,
                     cells_in({&data.stability}));
}

}  // namespace edgewise::reports
