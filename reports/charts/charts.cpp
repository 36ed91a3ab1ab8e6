// SPDX-License-Identifier: MIT
//
// What the charts share; see charts.hpp.
#include "edgewise/reports/charts/charts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "edgewise/reports/charts/spec_file.hpp"
#include "edgewise/reports/paper/charts/paper_charts.hpp"
#include "edgewise/reports/tables/cache_tables.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/store/palette.hpp"

namespace edgewise::reports {

namespace {

std::vector<std::string> charts_in_order(std::set<std::string> present,
                                         const std::vector<std::string>& first) {
    std::vector<std::string> names;
    for (const std::string& name : first)
        if (present.erase(name)) names.push_back(name);
    names.insert(names.end(), present.begin(), present.end());
    return names;
}

/// The distinct values of a member, those in `first` before the rest, the rest in order of name.
std::vector<std::string> ordered_names(const ReportData& data, std::string ReportCell::*member,
                                       const std::vector<std::string>& first) {
    std::set<std::string> present;
    for (const auto* rows : {&data.cells, &data.stability, &data.from_files, &data.paging})
        for (const ReportCell& row : *rows) present.insert(row.*member);
    return charts_in_order(std::move(present), first);
}

/// Those of the values' member that are in `first` before the rest.
std::vector<std::string> ordered_values(const ChartJson& values, const char* member,
                                        const std::vector<std::string>& first) {
    std::set<std::string> present;
    for (const ChartJson& row : values)
        if (row.contains(member)) present.insert(row[member].get<std::string>());
    return charts_in_order(std::move(present), first);
}

/// One of `list` for each name; beyond its end they repeat.
template <class List>
void add_order(ChartJson& slots, const std::string& names_slot, const std::vector<std::string>& names,
               const std::string& list_slot, const List& list) {
    ChartJson range = ChartJson::array();
    for (std::size_t i = 0; i < names.size(); ++i) range.push_back(list[i % std::size(list)]);
    slots[names_slot] = names;
    slots[list_slot] = range;
}

const ChartJson dashes[] = {{1, 0}, {6, 3}, {2, 2}, {8, 3, 2, 3}, {1, 4}, {10, 2}, {4, 1, 1, 1, 1, 1}};
const char* const point_shapes[] = {"circle", "triangle-up", "square", "diamond", "cross", "triangle-down"};
const std::vector<std::string> first_precisions = {"f64", "f32", "mixed"};

}  // namespace

std::vector<Chart> all_charts(const ReportData& data) {
    std::vector<Chart> charts = {bytes_chart(data), time_chart(data), speed_error_chart(data),
                                 ratio_chart(data)};
    if (!modelled_cells(data).empty()) charts.push_back(misses_chart(data));
    if (!data.stability.empty()) charts.insert(charts.end(), {tolerance_chart(data), gap_chart(data)});
    for (Chart& chart : chapter_charts(data)) charts.push_back(std::move(chart));
    return charts;
}

ChartJson cell_json(const ReportCell& cell) {
    return {{"scene", cell.scene_label},   {"shape", cell.shape},   {"vertices", cell.vertices},
            {"algorithm", cell.algorithm}, {"layout", cell.layout}, {"precision", cell.precision},
            {"table", cell.table}};
}

Chart chart_of_file(const std::string& name) {
    ChartJson file = spec_file(name);
    std::string how_to_read;
    for (const ChartJson& line : file["how_to_read"])
        how_to_read += (how_to_read.empty() ? "" : " ") + line.get<std::string>();
    return {name, file["title"], how_to_read, nullptr, {}, {}, file.value("section", ""), file};
}

bool take_rows(Chart& chart, ChartJson& values, const Omissions& omitted, const std::string& noun) {
    omitted.write(noun, chart.notes);
    thin(values, chart.file.value("most_rows", mark_limit), chart.notes);
    if (values.empty()) return false;
    chart.fallback = data_grid(values, chart.file["fallback"]);
    return true;
}

void draw(Chart& chart, const ReportData& data, const ChartJson& values, const ChartJson& slots) {
    ChartJson all = order_slots(data, values);
    all["values"] = values;
    all.update(slots);
    chart.spec = fill_spec(chart.file, all);
}

ChartJson order_slots(const ReportData& data, const ChartJson& values) {
    ChartJson slots{{"scenes", scene_labels(data)}, {"shapes", shapes_by_size(data)}};
    add_order(slots, "layouts", ordered_names(data, &ReportCell::layout, {"aos", "soa"}), "layout_colours",
              store::layout_colours);
    add_order(slots, "algorithms", algorithm_names(data), "algorithm_shapes", point_shapes);
    add_order(slots, "precisions", ordered_names(data, &ReportCell::precision, first_precisions),
              "precision_dashes", dashes);
    add_order(slots, "variants", ordered_values(values, "variant", first_precisions), "variant_dashes",
              dashes);
    add_order(slots, "points", ordered_values(values, "point", algorithm_names(data)), "point_shapes",
              point_shapes);
    return slots;
}

std::vector<std::string> shapes_by_size(const ReportData& data) {
    std::set<std::pair<std::int64_t, std::string>> shapes;
    for (const ReportCell& cell : data.cells) shapes.emplace(cell.vertices, cell.shape);
    std::vector<std::string> names;
    for (const auto& [vertices, name] : shapes)
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    return names;
}

std::vector<std::string> algorithm_names(const ReportData& data) {
    return ordered_names(data, &ReportCell::algorithm, {"vclip", "gjk"});
}

void thin(ChartJson& values, std::size_t rows, std::vector<std::string>& notes) {
    if (values.size() <= rows || rows == 0) return;
    const std::size_t step = (values.size() + rows - 1) / rows;
    ChartJson kept = ChartJson::array();
    for (std::size_t i = 0; i < values.size(); i += step) kept.push_back(values[i]);
    notes.push_back(fmt::format("{} of {} rows are drawn, every {}th; results.csv has them all.", kept.size(),
                                values.size(), step));
    values = std::move(kept);
}

void Omissions::add(const std::string& reason) {
    for (auto& [known, count] : counts_)
        if (known == reason) {
            ++count;
            return;
        }
    counts_.emplace_back(reason, 1);
}

void Omissions::write(const std::string& noun, std::vector<std::string>& notes) const {
    for (const auto& [reason, count] : counts_)
        notes.push_back(fmt::format("Not measured, so not drawn: {} ({}).", plural(count, noun), reason));
}

TextGrid data_grid(const ChartJson& values, const std::vector<std::string>& fields) {
    constexpr std::size_t rows = 30;
    TextGrid grid;
    for (const std::string& field : fields)
        grid.columns.push_back({field, !values.empty() && values[0].value(field, ChartJson()).is_number()});
    for (std::size_t i = 0; i < std::min(rows, values.size()); ++i) {
        std::vector<GridCell> row;
        for (const std::string& field : fields) {
            const ChartJson value = values[i].value(field, ChartJson());
            if (value.is_number())
                row.push_back({number_text(value.get<double>())});
            else
                row.push_back({value.is_string() ? value.get<std::string>() : "–"});
        }
        grid.rows.push_back(std::move(row));
    }
    if (values.size() > rows)
        grid.caption = fmt::format("The first {} of {} rows; results.csv has them all.", rows, values.size());
    return grid;
}

std::vector<StabilityFigure> stability_figures(const ReportData& data, const store::FigureName& family) {
    std::vector<StabilityFigure> result;
    for (const ReportCell& row : data.stability) {
        for (const store::FigureRow& figure : row.figures) {
            const auto at = family.value_in(figure.probe, figure.name);
            if (at && figure.value) result.push_back({&row, *at, *figure.value});
        }
    }
    return result;
}

ChartJson table_json(const ReportData& data, const std::string& algorithm, const std::string& table) {
    ChartJson result{{"algorithm", algorithm}, {"table", table}};
    for (const ReportCell& row : data.stability) {
        if (row.table != table) continue;
        result["layout"] = row.layout;
        result["precision"] = row.precision;
        break;
    }
    return result;
}

}  // namespace edgewise::reports
