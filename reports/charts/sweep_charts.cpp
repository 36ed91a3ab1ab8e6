// SPDX-License-Identifier: MIT
//
// Charts of a sweep. Bytes per edge by component: a bar per table type, a panel per algorithm, one shape at a
// time. Times of separated and of overlapping pairs against vertices. The seed curve: time, steps and lines
// of a query against the bytes of the table's seeds. Wrong verdicts of the stability run against the distance
// up to which a pair counts as touching: too small a tolerance leaves rounding to decide, too large a one
// calls separated pairs touching.

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/store/palette.hpp"

namespace edgewise::reports {

namespace {

/// One row per component, once for each algorithm, table type and shape.
ChartRows component_rows(const ReportData& data, const std::vector<std::string>& components) {
    ChartRows rows;
    std::set<std::string> seen;
    for (const ReportCell* verified : verified_cells(data)) {
        const ReportCell& cell = *verified;
        if (!seen.insert(cell.algorithm + '\n' + cell.table + '\n' + cell.shape).second) continue;
        for (std::size_t i = 0; i < components.size(); ++i) {
            const measure::Figure figure = cell.figure("bytes", components[i]);
            if (!figure.value) {
                rows.omitted.add(in_words(components[i]) + ": " + figure.reason);
                continue;
            }
            add_point(rows.values, cell_json(cell),
                      {{"component", in_words(components[i])},
                       {"order", i},
                       {"bytes", *figure.value},
                       {"total", cell.figure("bytes.total_bytes_per_edge").value.value_or(0)}});
        }
    }
    return rows;
}

/// Returns one panel for each algorithm, with its own table types.
ChartJson panels_of(const ReportData& data, const ChartJson& pick) {
    ChartJson panels = ChartJson::array();
    // A parameter lives in one panel; the others refer to it by name.
    for (const std::string& algorithm : algorithm_names(data))
        panels.push_back({{"algorithm", algorithm},
                          {"picks", panels.empty() ? ChartJson::array({pick}) : ChartJson::array()}});
    return panels;
}

ChartJson bytes_slots_of(const ReportData& data, const std::vector<std::string>& components,
                         const ChartJson& pick) {
    ChartJson names = ChartJson::array(), colours = ChartJson::array();
    for (std::size_t i = 0; i < components.size(); ++i) {
        names.push_back(in_words(components[i]));
        colours.push_back(store::component_colour(components[i], i));
    }
    return {{"components", names},
            {"component_colours", colours},
            {"reference_shape", reference_shape(data)},
            {"panels", panels_of(data, pick)}};
}

}  // namespace

Chart bytes_chart(const ReportData& data) {
    Chart chart = chart_of_file("bytes");
    const auto components = byte_components(data);
    ChartRows rows = component_rows(data, components);
    if (!take_rows(chart, rows, "component bar")) return chart;
    ChartJson shown = ChartJson::array();
    for (const ChartJson& row : rows.values)
        if (row["shape"] == reference_shape(data)) shown.push_back(row);
    chart.fallback = data_grid(shown, chart.file["fallback"]);
    draw(chart, data, rows.values, bytes_slots_of(data, components, chart.file["parts"]["component_pick"]));
    return chart;
}

namespace {

/// Adds the rows of `add_row` for each verified cell and kind of pairs.
ChartRows rows_of_pairs(const ReportData& data, void (*add_row)(const ReportCell&, PairKind, ChartRows&)) {
    ChartRows rows;
    for (const PairKind kind : {PairKind::Separated, PairKind::Overlapping})
        for (const ReportCell* cell : verified_cells(data)) add_row(*cell, kind, rows);
    return rows;
}

void time_add_row(const ReportCell& cell, PairKind kind, ChartRows& rows) {
    const store::QueryTime& times = times_of(kind);
    const char* const when_zero = "a time of 0 has no place on a logarithmic axis";
    if (!rows.omitted.positive(cell.figure(times.ns), when_zero, pair_name(kind) + " pairs: ")) return;
    ChartJson row = cell_json(cell);
    row["pairs"] = pair_name(kind);
    // Sizes of one family are joined by a line; a mesh is a point of its own.
    row["family"] = cell.shape_source == "built-in";
    add_time(row, cell, times);
    rows.values.push_back(std::move(row));
}

/// Panels keep their rows and columns only if each has a row of data, even an empty one: else later panels
/// move up.
void fill_panels(const ReportData& data, ChartJson& values) {
    std::set<std::pair<std::string, std::string>> present;
    std::set<std::string> scenes;
    for (const ChartJson& row : values) {
        present.emplace(row["scene"].get<std::string>(), row["pairs"].get<std::string>());
        scenes.insert(row["scene"].get<std::string>());
    }
    for (const std::string& scene : scene_labels(data)) {
        for (const PairKind kind : {PairKind::Separated, PairKind::Overlapping}) {
            if (scenes.count(scene) && !present.count({scene, pair_name(kind)}))
                values.push_back(
                    ChartJson::object({{"scene", scene}, {"pairs", pair_name(kind)}, {"ns", nullptr}}));
        }
    }
}

}  // namespace

Chart time_chart(const ReportData& data) {
    Chart chart = chart_of_file("time");
    ChartRows rows = rows_of_pairs(data, time_add_row);
    if (!take_rows(chart, rows)) return chart;
    const ChartJson scenes = scenes_of_rows(data, rows.values);
    fill_panels(data, rows.values);
    draw(chart, data, rows.values, scene_slots(scenes));
    return chart;
}

namespace {

const FigureColumn numbers[] = {{"ns per query", "time.all_ns"},
                                {"steps per query", store::mean_steps.all},
                                {"lines of 64 bytes per query", store::lines_read.all}};

ChartRows seed_rows(const ReportData& data) {
    ChartRows rows;
    for (const SeededCell& of : seeded_cells(data)) {
        for (const FigureColumn& number : numbers) {
            const auto value =
                rows.omitted.positive(of.cell->figure(number.figure), "it is 0", number.title + ": ");
            if (!value) continue;
            add_point(rows.values, cell_json(*of.cell),
                      {{"of", of.starts + ", " + std::to_string(of.cell->vertices) + " vertices"},
                       {"number", number.title},
                       {"seed_bytes", of.seed_bytes},
                       {"value", *value}});
        }
    }
    return rows;
}

}  // namespace

Chart seeds_chart(const ReportData& data) {
    ChartRows rows = seed_rows(data);
    ChartJson panels = ChartJson::array();  // by start, then by size
    for (const ChartJson& row : rows.values)
        if (panels.empty() || panels.back() != row["of"]) panels.push_back(row["of"]);
    return drawn_chart(chart_of_file("seeds"), data, std::move(rows), {{"panels", panels}}, "number");
}

namespace {

/// Tolerance 0 has no place on a logarithmic axis; it is drawn left of all other tolerances.
constexpr double place_of_zero = 1e-18;

/// Number of wrong verdicts, and of the cases that gave a verdict.
struct WrongVerdicts {
    double wrong = 0, cases = 0;
};

/// Percent of wrong verdicts by tolerance.
using ToleranceCurve = std::map<double, double>;

/// Returns the curves by algorithm and table type.
std::map<std::pair<std::string, std::string>, ToleranceCurve> tolerance_curves(const ReportData& data) {
    constexpr store::FigureName failures("stability.failures_at_{tolerance}");
    std::map<std::pair<std::string, std::string>, std::map<double, WrongVerdicts>> sums;
    for (const ReportCell& row : data.stability) {
        const double cases = row.figure("stability.cases").value.value_or(0);
        for (const store::FigureRow& figure : row.figures) {
            const auto at = failures.value_in(figure.probe, figure.name);
            if (!at || !figure.value) continue;
            // By number: the names' order is not that of the tolerances.
            WrongVerdicts& sum = sums[{row.algorithm, row.table}][std::stod(*at)];
            sum.wrong += *figure.value, sum.cases += cases;
        }
    }
    std::map<std::pair<std::string, std::string>, ToleranceCurve> curves;
    for (const auto& [name, points] : sums)
        for (const auto& [tolerance, sum] : points)
            if (sum.cases > 0) curves[name][tolerance] = 100 * sum.wrong / sum.cases;
    return curves;
}

}  // namespace

Chart tolerance_chart(const ReportData& data) {
    std::map<std::pair<std::string, ToleranceCurve>, std::vector<std::string>> alike;
    for (const auto& [name, curve] : tolerance_curves(data))
        alike[{name.first, curve}].push_back(name.second);
    ChartRows rows;
    for (const auto& [key, tables] : alike) {
        const ReportCell& first = *std::ranges::find(data.stability, tables.front(), &ReportCell::table);
        std::string names;
        for (const std::string& table : tables) append(names, table);
        for (const auto& [tolerance, share] : key.second)
            rows.values.push_back({{"algorithm", key.first},
                                   {"table", names},
                                   {"layout", first.layout},
                                   {"precision", first.precision},
                                   {"tolerance", tolerance > 0 ? tolerance : place_of_zero},
                                   {"share", share}});
    }
    return drawn_chart(chart_of_file("tolerance"), data, std::move(rows));
}

}  // namespace edgewise::reports
