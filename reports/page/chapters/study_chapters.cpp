// SPDX-License-Identifier: MIT
//
// Chapters of studies that the report does not know: the store describes them (sweep/study.hpp).
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/page/chapters/chapters.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/store/schema.hpp"

namespace edgewise::reports {

namespace {

using StudyJson = nlohmann::json;

/// Returns a member if it has the type of `otherwise`, else that: another program may have written the store.
template <class Value>
Value member(const StudyJson& object, const char* name, const Value& otherwise) {
    const StudyJson value = object.is_object() ? object.value(name, StudyJson()) : StudyJson();
    const bool fits = StudyJson(otherwise).is_number() ? value.is_number() : value.is_string();
    return fits ? value.get<Value>() : otherwise;
}

/// Returns a row for each cell, with the figures that the chapter's columns name.
TextGrid study_grid(const std::vector<const ReportCell*>& cells, const StudyJson& columns) {
    TextGrid grid = cell_grid("", cell_names, std::vector<FigureColumn>(), cells);
    grid.columns.push_back({"status"});
    for (std::size_t i = 0; i < cells.size(); ++i)
        grid.rows[i].push_back(grid_cell(to_string(cells[i]->status)));
    for (const StudyJson& column : columns) {
        const std::string figure = member<std::string>(column, "figure", "");
        const std::size_t dot = std::min(figure.find('.'), figure.size());
        const double unit = member(column, "unit", 1.0);
        grid.columns.push_back({member(column, "title", figure), true});
        for (std::size_t i = 0; i < cells.size(); ++i)
            grid.rows[i].push_back(figure_cell(
                cells[i]->figure(figure.substr(0, dot), figure.substr(std::min(dot + 1, figure.size()))),
                unit > 0 ? unit : 1));
    }
    return grid;
}

/// Returns the name as the page's links have it: letters, digits and '-'.
std::string id_of(std::string name) {
    std::ranges::replace_if(
        name, [](unsigned char c) { return !std::isalnum(c); }, '-');
    return "study-" + name;
}

}  // namespace

std::vector<Chapter> study_chapters(const ReportData& data) {
    std::map<std::string, std::vector<const ReportCell*>> studies;
    for (const ReportCell& cell : data.other_studies) studies[cell.run].push_back(&cell);
    std::vector<Chapter> chapters;
    for (const auto& [name, cells] : studies) {
        const StudyJson about = input::json_or_null(data.meta_value(store::study_key + name).value_or(""));
        const StudyJson columns = about.is_object() ? about.value("columns", StudyJson()) : StudyJson();
        Chapter& chapter = chapters.emplace_back();
        chapter.id = id_of(name);
        chapter.title = member(about, "title", name);
        chapter.paragraph =
            member<std::string>(about, "text", "The store does not describe the figures of this study.");
        chapter.blocks = {{.grids = {study_grid(cells, columns.is_array() ? columns : StudyJson::array())}}};
        chapter.link = name;
    }
    return chapters;
}

}  // namespace edgewise::reports
