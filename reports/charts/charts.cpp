// SPDX-License-Identifier: MIT
//
// What the charts share; see charts.hpp.
//
// Names are looked up from the inside out, so a part can use names that its user defines.
#include "edgewise/reports/charts/charts.hpp"

#include <fmt/core.h>

#include <cmath>
#include <set>
#include <stdexcept>

#include "edgewise/reports/additions.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/reports/text/report_text.hpp"
#include "edgewise/store/palette.hpp"

namespace edgewise::reports {

namespace {

struct Scope {
    const ChartJson* names;
    bool is_data;  ///< slots: inserted as they are
    const Scope* outer;
};

ChartJson fill(const ChartJson& node, const Scope& scope);

ChartJson value_of(const std::string& name, const Scope& scope) {
    if (name == "absent") return ChartJson(ChartJson::value_t::discarded);
    for (const Scope* at = &scope; at; at = at->outer)
        if (const auto found = at->names->find(name); found != at->names->end())
            return at->is_data ? *found : fill(*found, scope);
    throw std::out_of_range("a chart's specification names $" + name + ", which nothing gives");
}

void fill_item(const ChartJson& item, const Scope& scope, ChartJson& list) {
    if (item.is_object() && item.contains("$each")) {
        ChartJson rest = item;
        rest.erase("$each");
        for (const ChartJson& slots : fill(item["$each"], scope))
            list.push_back(fill(rest, {&slots, true, &scope}));
    } else if (item.is_string() && item.get_ref<const std::string&>().starts_with("$*")) {
        for (const ChartJson& one : value_of(item.get<std::string>().substr(2), scope)) list.push_back(one);
    } else {
        list.push_back(fill(item, scope));
    }
}

ChartJson fill_object(const ChartJson& node, const Scope& scope) {
    const auto let = node.find("$let");
    const Scope inner{let != node.end() ? &*let : &node, false, &scope};
    const Scope& own = let != node.end() ? inner : scope;
    ChartJson object = node.contains("$with") ? fill(node["$with"], own) : ChartJson::object();
    for (const auto& [key, member] : node.items()) {
        if (key == "$let" || key == "$with") continue;
        if (ChartJson value = fill(member, own); !value.is_discarded()) object[key] = std::move(value);
    }
    return object;
}

ChartJson fill(const ChartJson& node, const Scope& scope) {
    if (node.is_string() && node.get_ref<const std::string&>().starts_with("$"))
        return value_of(node.get<std::string>().substr(1), scope);
    if (node.is_object()) return fill_object(node, scope);
    if (!node.is_array()) return node;
    ChartJson list = ChartJson::array();
    for (const ChartJson& item : node) fill_item(item, scope, list);
    return list;
}

ChartJson spec_file(const std::string& name) { return ChartJson::parse(report_text(name + ".vl.json")); }

}  // namespace

ChartJson fill_spec(const ChartJson& file, const ChartJson& slots) {
    const ChartJson shared = spec_file("shared"), parts = file.value("parts", ChartJson::object());
    const Scope of_all{&shared, false, nullptr}, of_file{&parts, false, &of_all},
        of_code{&slots, true, &of_file};
    return fill(file["spec"], of_code);
}

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
    for (const ReportCell* row : cells_in({&data.cells, &data.stability, &data.from_files, &data.paging}))
        present.insert(row->*member);
    return charts_in_order(std::move(present), first);
}

/// Returns the distinct texts of `member` in the rows; the texts in `first` come before the rest.
std::vector<std::string> ordered_values(const ChartJson& values, const char* member,
                                        const std::vector<std::string>& first) {
    std::set<std::string> present;
    for (const ChartJson& row : values)
        if (row.contains(member)) present.insert(row[member].get<std::string>());
    return charts_in_order(std::move(present), first);
}

/// Returns the shapes by vertices, then name.
std::vector<std::string> shapes_by_size(const ReportData& data) {
    DistinctTexts names;
    for (const auto& [vertices, name] : shapes_by_vertices(data)) names.place(name);
    return names.texts();
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

/// Gives every layout its own colour, independent of the other layouts.
void add_colours(ChartJson& slots, const std::vector<std::string>& layouts) {
    slots["layouts"] = layouts;
    slots["layout_colours"] = ChartJson::array();
    for (const std::string& layout : layouts) slots["layout_colours"].push_back(store::layout_colour(layout));
}

const ChartJson dashes[] = {{1, 0}, {6, 3}, {2, 2}, {8, 3, 2, 3}, {1, 4}, {10, 2}, {4, 1, 1, 1, 1, 1}};
const char* const point_shapes[] = {"circle", "triangle-up", "square", "diamond", "cross", "triangle-down"};
const std::vector<std::string> first_precisions = {"f64", "f32", "mixed"};

}  // namespace

std::vector<Chart> all_charts(const ReportData& data) {
    std::vector<Chart> charts = {speed_error_chart(data), bytes_chart(data), time_chart(data)};
    if (!modelled_cells(data).empty()) charts.push_back(misses_chart(data));
    if (!seeded_cells(data).empty()) charts.push_back(seeds_chart(data));
    if (!data.stability.empty()) charts.push_back(tolerance_chart(data));
    for (const Addition& addition : additions())
        for (Chart& chart : addition.charts(data)) charts.push_back(std::move(chart));
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
    for (const ChartJson& line : file["how_to_read"]) append(how_to_read, line.get<std::string>(), " ");
    return {.name = name,
            .title = file["title"],
            .how_to_read = how_to_read,
            .section = file.value("section", ""),
            .file = file};
}

bool take_rows(Chart& chart, ChartRows& rows, const std::string& noun) {
    rows.omitted.write(noun, chart.notes);
    thin(rows.values, chart.file.value("most_rows", mark_limit), chart.notes);
    if (rows.values.empty()) return false;
    chart.fallback = data_grid(rows.values, chart.file["fallback"]);
    return true;
}

Chart drawn_chart(Chart chart, const ReportData& data, ChartRows rows, const ChartJson& slots,
                  const std::string& noun) {
    if (take_rows(chart, rows, noun)) draw(chart, data, rows.values, slots);
    return chart;
}

void draw(Chart& chart, const ReportData& data, const ChartJson& values, const ChartJson& slots) {
    ChartJson all = order_slots(data, values);
    all["values"] = values;
    all.update(slots);
    chart.spec = fill_spec(chart.file, all);
    chart.points = values;
}

ChartJson order_slots(const ReportData& data, const ChartJson& values) {
    ChartJson slots{{"scenes", scene_labels(data)}, {"shapes", shapes_by_size(data)}};
    add_colours(slots, ordered_names(data, &ReportCell::layout, {"aos", "soa"}));
    add_order(slots, "algorithms", algorithm_names(data), "algorithm_shapes", point_shapes);
    add_order(slots, "precisions", ordered_names(data, &ReportCell::precision, first_precisions),
              "precision_dashes", dashes);
    add_order(slots, "variants", ordered_values(values, "variant", first_precisions), "variant_dashes",
              dashes);
    add_order(slots, "points", ordered_values(values, "point", algorithm_names(data)), "point_shapes",
              point_shapes);
    return slots;
}

std::vector<std::string> algorithm_names(const ReportData& data) {
    return ordered_names(data, &ReportCell::algorithm, {"vclip", "gjk"});
}

void thin(ChartJson& values, std::size_t rows, std::vector<std::string>& notes) {
    if (values.size() <= rows || rows == 0) return;
    const std::size_t step = (values.size() + rows - 1) / rows;
    ChartJson kept = ChartJson::array();
    for (std::size_t i = 0; i < values.size(); i += step) kept.push_back(values[i]);
    notes.push_back(fmt::format("{} of {} rows are drawn, one of {}; the store has them all.", kept.size(),
                                values.size(), step));
    values = std::move(kept);
}

std::optional<double> Omissions::positive(const measure::Figure& figure, const char* when_zero,
                                          const std::string& what) {
    if (figure.value && *figure.value > 0) return figure.value;
    add(what + (figure.value ? when_zero : figure.reason));
    return std::nullopt;
}

void Omissions::write(const std::string& noun, std::vector<std::string>& notes) const {
    for (const auto& [reason, count] : counts_)
        notes.push_back(fmt::format("Not measured, so not drawn: {} ({}).", plural(count, noun), reason));
}

TextGrid data_grid(const ChartJson& values, const std::vector<std::string>& fields) {
    constexpr std::size_t rows = 6;
    nlohmann::json shown = values;
    if (shown.size() > rows) shown.erase(shown.begin() + rows, shown.end());
    std::string columns;
    for (const std::string& field : fields)
        append(columns,
               !shown.empty() && shown[0].value(field, nlohmann::json()).is_number() ? "#" + field : field,
               "|");
    TextGrid grid = member_grid(shown, columns);
    if (values.size() > rows)
        grid.caption = fmt::format("The first {} of {} rows; the store has them all.", rows, values.size());
    return grid;
}

void add_time(ChartJson& row, const ReportCell& cell, const store::QueryTime& time) {
    const auto ns = cell.figure(time.ns).value;
    row["ns"] = *ns;
    for (const auto& [key, name] : {std::pair("low", time.low), std::pair("high", time.high)}) {
        const auto end = cell.figure(name).value;
        row[key] = end && *end > 0 ? *end : *ns;
    }
}

void add_misses(const ReportCell& cell, const ChartJson& named, Starts starts, ChartJson& values) {
    constexpr int least = 10, most = 30;  // as the probe `reuse` makes them
    for (const store::ReuseNames& family : store::reuse_names) {
        for (int power = least; power <= most; ++power) {
            const std::string exponent = std::to_string(power);
            const store::StartNames names = family.misses.of(exponent);
            const measure::Figure misses = cell.figure(starts == Starts::warm ? names.warm() : names.all);
            if (misses.value)
                add_point(
                    values, named,
                    {{"unit", family.units}, {"bytes", std::ldexp(1.0, power)}, {"misses", *misses.value}});
        }
    }
}

Chart misses_chart(const ReportData& data) {
    ChartRows rows;
    for (const ReportCell* cell : modelled_cells(data))
        add_misses(*cell, cell_json(*cell), Starts::all, rows.values);
    Chart chart = chart_of_file("misses");
    if (take_rows(chart, rows))
        draw(chart, data, rows.values, scene_slots(scenes_of_rows(data, rows.values)));
    return chart;
}

ChartJson scenes_of_rows(const ReportData& data, const ChartJson& values) {
    std::set<std::string> present;
    for (const ChartJson& row : values) present.insert(row["scene"].get<std::string>());
    ChartJson scenes = ChartJson::array();
    for (const std::string& scene : scene_labels(data))
        if (present.contains(scene)) scenes.push_back(scene);
    return scenes;
}

ChartJson scene_slots(const ChartJson& scenes) {
    return {{"drawn_scenes", scenes}, {"first_scene", scenes.back()}};
}

ChartJson curve_json(const ReportCell& cell) {
    ChartJson row = cell_json(cell);
    row["scene"] = cell.scene;
    row["variant"] = cell.axes.empty() ? cell.precision : cell.precision + " " + cell.axes;
    row["point"] = cell.algorithm;
    row["stroke"] = cell.algorithm + " " + cell.table;
    return row;
}

ChartJson timed_row(const ReportCell& cell, Omissions& omitted) {
    if (cell.judged()) return nullptr;
    if (!cell.verified()) {
        omitted.add(fmt::format("the cell is {}: {}", to_string(cell.status), cell.reason));
        return nullptr;
    }
    if (!omitted.positive(cell.figure(store::all_time.ns), "a time of 0")) return nullptr;
    ChartJson row = curve_json(cell);
    add_time(row, cell, store::all_time);
    return row;
}

}  // namespace edgewise::reports
