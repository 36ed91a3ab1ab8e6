// SPDX-License-Identifier: MIT
#include "edgewise/reports/results/export.hpp"

#include <fmt/core.h>
#include <fnmatch.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "edgewise/input/json_text.hpp"
#include "edgewise/input/known_names.hpp"
#include "edgewise/input/output_file.hpp"

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
    for (const ReportCell* cell : data.rows_and_peers()) {
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
    std::vector<const ReportCell*> chosen = data.rows_and_peers();
    std::erase_if(chosen, [&](const ReportCell* cell) { return !is_chosen(*cell, choice); });
    return chosen;
}

std::string export_text(const ReportData& data, const ExportChoice& choice) {
    const std::vector<Chosen> chosen = chosen_figures(data, choice);
    return choice.format == ExportFormat::csv ? csv_of(data, chosen) : json_of(data, chosen);
}

namespace {

/// Place in the vocabulary, and key: the order of columns.
using Columns = std::set<std::pair<std::size_t, std::string>>;

struct ResultFile {
    std::vector<const ReportCell*> cells;
    Columns columns;
};

/// Their names; a user's scene that is called like a study is another file.
std::map<std::pair<std::string, std::string>, std::string> names_of(const ReportData& data) {
    std::map<std::pair<std::string, std::string>, std::string> names;
    std::set<std::string> taken;
    const std::vector<const ReportCell*> cells = data.rows_and_peers();
    for (const bool swept : {false, true}) {
        for (const ReportCell* cell : cells) {
            if ((cell->run == store::sweep_run) != swept || names.contains({cell->run, cell->scene}))
                continue;
            const bool plain = swept || cell->scene == cell->run;  // else "effort_tumble"
            const std::string name = file_name_of(plain ? cell->scene : cell->run + "_" + cell->scene, taken);
            taken.insert(name);
            names[{cell->run, cell->scene}] = name + ".csv";
        }
    }
    return names;
}

std::map<std::string, ResultFile> result_files(const ReportData& data) {
    const auto names = names_of(data);
    std::map<std::string, ResultFile> files;
    for (const ReportCell* cell : data.rows_and_peers()) {
        ResultFile& file = files[names.at({cell->run, cell->scene})];
        file.cells.push_back(cell);
        for (const store::FigureRow& figure : cell->figures) {
            const std::string key = figure_key(figure);
            if (const auto place = main_place(key)) file.columns.emplace(*place, key);
        }
    }
    return files;
}

/// Units of each column, as stored; how many cells of a file lack it, by why and what would help.
struct About {
    std::map<std::pair<std::size_t, std::string>, std::set<std::string>> units;
    std::map<std::tuple<std::string, std::string, std::string, std::string>, std::int64_t> missing;
};

std::string row_of(const ReportData& data, const ReportCell& cell, const std::string& name,
                   const Columns& columns, About& about) {
    CsvRow row;
    add_identity(row, data, cell);
    std::map<std::string, const store::FigureRow*> by_key;
    for (const store::FigureRow& figure : cell.figures) by_key.emplace(figure_key(figure), &figure);
    for (const auto& column : columns) {
        const auto found = by_key.find(column.second);
        // Why there is none, where there is none.
        const measure::Figure figure =
            found == by_key.end() ? cell.figure("", "") : measure::Figure(*found->second);
        row.number(figure.value);
        if (!figure.unit.empty()) about.units[column].insert(figure.unit);
        if (!figure.value) ++about.missing[{name, column.second, figure.reason, figure.remedy}];
    }
    return row.line();
}

std::string file_text(const ReportData& data, const std::string& name, const ResultFile& file, About& about) {
    CsvRow header;
    add_identity_header(header);
    for (const auto& [place, key] : file.columns) header.text(key);
    std::string text = header.line();
    for (const ReportCell* cell : file.cells) text += row_of(data, *cell, name, file.columns, about);
    return text;
}

std::string columns_text(const About& about) {
    std::string text =
        CsvRow().text("figure").text("unit").text("population").text("repeats").text("meaning").line();
    for (const auto& [column, units] : about.units) {
        const store::FigureInfo& info = *main_info(column.second);
        std::string unit;
        for (const std::string& one : units) unit += (unit.empty() ? "" : " or ") + one;
        text += CsvRow()
                    .text(column.second)
                    .text(unit)
                    .text(to_string(info.population))
                    .text(info.repeats == store::Repeats::exactly ? "exactly" : "timed")
                    .text(info.meaning)
                    .line();
    }
    return text;
}

std::string missing_text(const About& about) {
    std::string text =
        CsvRow().text("file").text("figure").text("cells").text("reason").text("remedy").line();
    for (const auto& [what, cells] : about.missing) {
        const auto& [file, figure, reason, remedy] = what;
        text += CsvRow().text(file).text(figure).field(cells).text(reason).text(remedy).line();
    }
    return text;
}

void remove_old(const std::filesystem::path& folder) {
    std::error_code ignored;
    std::vector<std::filesystem::path> old;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
        if (entry.path().extension() == ".csv") old.push_back(entry.path());
    for (const auto& path : old) std::filesystem::remove(path, ignored);
}

}  // namespace

std::map<std::string, std::string> wide_results(const ReportData& data) {
    std::map<std::string, std::string> texts;
    About about;
    for (const auto& [name, file] : result_files(data)) texts[name] = file_text(data, name, file, about);
    texts["about/columns.csv"] = columns_text(about);
    texts["about/not_measured.csv"] = missing_text(about);
    return texts;
}

void write_results(const ReportData& data, const std::filesystem::path& out) {
    const std::filesystem::path folder = out / "results";
    std::error_code failed;
    std::filesystem::create_directories(folder / "about", failed);  // write_file says what is wrong
    remove_old(folder);
    for (const auto& [name, text] : wide_results(data)) input::write_output(folder / name, text);
}

}  // namespace edgewise::reports
