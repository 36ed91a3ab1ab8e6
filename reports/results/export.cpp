// SPDX-License-Identifier: MIT
#include "edgewise/reports/results/export.hpp"

#include <fmt/core.h>
#include <fnmatch.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "edgewise/input/json_text.hpp"
#include "edgewise/input/known_names.hpp"
#include "edgewise/reports/results/csv_row.hpp"
#include "edgewise/reports/results/main_figures.hpp"

namespace edgewise::reports {

namespace {

using Json = nlohmann::ordered_json;

/// A cell's chosen figures; one without a value where it has none of them.
struct Chosen {
    const ReportCell* cell;
    std::vector<store::FigureRow> figures;
};

bool names_one(const std::vector<std::string>& names, const std::string& name) {
    return std::ranges::find(names, name) != names.end();
}

/// Every wanted name must be one of the store's.
void check_names(const std::vector<std::string>& wanted, const std::set<std::string>& there,
                 const char* what) {
    for (const std::string& name : wanted)
        if (!there.contains(name))
            throw std::runtime_error(unknown_name(what, name, {there.begin(), there.end()}));
}

void check_choice(const ReportData& data, const ExportChoice& choice) {
    std::set<std::string> scenes, layouts;
    for (const ReportCell* cell : every_cell(data)) {
        scenes.insert(cell->scene);
        layouts.insert({cell->layout, cell->layout + "_" + cell->precision, cell->table});
    }
    check_names(choice.scenes, scenes, "scene of the store");
    check_names(choice.layouts, layouts, "layout or table type of the store");
}

bool is_chosen(const ReportCell& cell, const ExportChoice& choice) {
    if (!choice.scenes.empty() && !names_one(choice.scenes, cell.scene)) return false;
    return choice.layouts.empty() || names_one(choice.layouts, cell.layout) ||
           names_one(choice.layouts, cell.layout + "_" + cell.precision) ||
           names_one(choice.layouts, cell.table);
}

/// Returns true if a pattern matches; removes each matching pattern from `unmatched`.
bool is_chosen(const std::string& key, const ExportChoice& choice, std::set<std::string>& unmatched) {
    if (choice.figures.empty()) return main_place(key).has_value();
    bool chosen = false;
    for (const std::string& pattern : choice.figures)
        if (::fnmatch(pattern.c_str(), key.c_str(), 0) == 0) {
            chosen = true;
            unmatched.erase(pattern);
        }
    return chosen;
}

std::vector<Chosen> chosen_figures(const ReportData& data, const ExportChoice& choice) {
    std::set<std::string> unmatched(choice.figures.begin(), choice.figures.end());
    std::vector<Chosen> all;
    for (const ReportCell* cell : chosen_cells(data, choice)) {
        Chosen& one = all.emplace_back(Chosen{cell, {}});
        for (const store::FigureRow& figure : cell->figures)
            if (is_chosen(figure_key(figure), choice, unmatched)) one.figures.push_back(figure);
    }
    if (!unmatched.empty())
        throw std::runtime_error(
            fmt::format("no figure of the chosen cells matches '{}'; edgewise list figures names all",
                        *unmatched.begin()));
    for (Chosen& one : all)
        if (one.figures.empty()) one.figures.push_back({one.cell->figure("", ""), ""});
    return all;
}

std::string csv_of(const ReportData& data, const std::vector<Chosen>& chosen) {
    CsvRow header;
    add_identity_header(header);
    for (const char* name : {"probe", "figure", "state", "value", "unit", "reason", "remedy"})
        header.text(name);
    std::string out = header.line();
    for (const auto& [cell, figures] : chosen)
        for (const store::FigureRow& figure : figures) {
            CsvRow row;
            add_identity(row, data, *cell);
            row.text(figure.probe).text(figure.name).text(figure.value ? "measured" : "not measured");
            row.number(figure.value).text(figure.unit).text(figure.reason).text(figure.remedy);
            out += row.line();
        }
    return out;
}

Json figure_json(const store::FigureRow& figure) {
    Json json = {{"figure", figure.probe.empty() ? "" : figure_key(figure)}};
    json["value"] = figure.value ? Json(*figure.value) : Json();
    json["unit"] = figure.unit;
    if (!figure.value) {
        json["reason"] = figure.reason;
        json["remedy"] = figure.remedy;
    }
    return json;
}

std::string json_of(const ReportData& data, const std::vector<Chosen>& chosen) {
    Json cells = Json::array();
    for (const auto& [cell, figures] : chosen) {
        Json one = identity_json(data, *cell);
        one["figures"] = Json::array();
        for (const store::FigureRow& figure : figures) one["figures"].push_back(figure_json(figure));
        cells.push_back(std::move(one));
    }
    return input::json_text(Json{{"cells", std::move(cells)}}) + "\n";
}

}  // namespace

std::vector<const ReportCell*> chosen_cells(const ReportData& data, const ExportChoice& choice) {
    check_choice(data, choice);
    std::vector<const ReportCell*> chosen = every_cell(data);
    std::erase_if(chosen, [&](const ReportCell* cell) { return !is_chosen(*cell, choice); });
    return chosen;
}

std::string export_text(const ReportData& data, const ExportChoice& choice) {
    const std::vector<Chosen> chosen = chosen_figures(data, choice);
    return choice.format == ExportFormat::csv ? csv_of(data, chosen) : json_of(data, chosen);
}

}  // namespace edgewise::reports
