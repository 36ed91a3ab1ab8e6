// SPDX-License-Identifier: MIT
//
// The page: the answer, what to look at, what passed, then the chapters; what is long is packed and made when
// it is opened. Its frame is page.html; its policy loads nothing from anywhere, and runs no scripts except
// the page's own, known by their hashes, and the code that these start from the page's own packed bundles.
#include "edgewise/reports/page/page.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/body/body_heat.hpp"
#include "edgewise/reports/page/html.hpp"
#include "edgewise/reports/results/export.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/reports/text/report_text.hpp"

namespace edgewise::reports {

namespace {

/// Scripts of the page; each script comes after the scripts that it uses.
constexpr const char* page_scripts[] = {"page.tables.js", "page.filter.js",   "page.cells.js",
                                        "page.body.js",   "page.question.js", "page.js"};

/// Writes chapters, and keeps the data of folded tables, which a script makes when they are opened.
class ChapterWriter {
  public:
    ChapterWriter(const std::vector<Chart>& charts, const StaticPictures& pictures, const Glossary& glossary)
        : charts_(charts), pictures_(pictures), glossary_(glossary) {}

    /// A chapter without contents is a line that opens to why.
    std::string chapter(const Chapter& chapter) {
        if (chapter.blocks.empty() && chapter.sentence.empty())
            return fmt::format(
                "<section><details class=\"empty\"><summary><h2 id=\"{}\">{}</h2> not measured</summary>\n{}"
                "</details></section>\n",
                chapter.id, html_text(chapter.title), paragraph(chapter.paragraph));
        std::string out = "<section>\n" + html_heading(chapter.id, chapter.title);
        if (!chapter.sentence.empty()) out += paragraph(chapter.sentence, "sentence");
        for (const ChapterBlock& block : chapter.blocks) out += this->block(block);
        if (!chapter.paragraph.empty()) out += paragraph(chapter.paragraph, "note");
        return out + "</section>\n";
    }

    [[nodiscard]] std::string packed() const {
        return packed_element("folds", input::json_text(folds_)) +
               packed_element("grids", grids_data(grids_));
    }

  private:
    /// The first use of each term in the page is a link: in every chapter, there would be too many to tab
    /// through.
    std::string paragraph(const std::string& text, const std::string& style = {}) {
        return html_element("p", glossary_.html(text, linked_), style);
    }

    std::string block(const ChapterBlock& block) {
        std::string out = block.title.empty() ? "" : "<h3>" + html_text(block.title) + "</h3>\n";
        // In a fold, which few open, no term is used for the first time.
        if (!block.paragraph.empty())
            out += block.fold.empty() ? paragraph(block.paragraph) : html_paragraph(block.paragraph);
        if (!block.section.empty()) out += section(block.section);
        out += block.elements;
        if (!block.fold.empty()) return fold(block.fold, out, block.grids);
        for (const TextGrid& grid : block.grids) out += this->grid(grid);
        return out;
    }

    /// The first rows, and all of them on demand.
    std::string grid(const TextGrid& grid) {
        // One row more than are shown is no reason to open anything.
        if (grid.rows.size() <= grid.shown_rows + 1) return grid_html(grid);
        return grid_html(grid, grid.shown_rows) +
               fold(fmt::format("All {} of this table", plural(grid.rows.size(), "row")), "", {grid});
    }

    std::string fold(const std::string& line, const std::string& html, const std::vector<TextGrid>& grids) {
        nlohmann::json places = nlohmann::json::array();
        for (const TextGrid& grid : grids) {
            places.push_back(grids_.size());
            grids_.push_back(grid);
        }
        folds_.push_back({{"html", html}, {"grids", places}});
        return fmt::format(
            "<details data-fold=\"{}\"><summary>{}</summary><p class=\"waiting note\">Made by a script when it "
            "is opened; results/ next to this page has the same figures.</p></details>\n",
            folds_.size() - 1, html_text(line));
    }

    std::string section(const std::string& name) {
        std::string out;
        for (const Chart& chart : charts_)
            if (chart.section == name) out += this->chart(chart);
        return out;
    }

    /// Title, words, picture or table, notes.
    std::string chart(const Chart& chart) {
        std::string out = "<h3>" + html_text(chart.title) + "</h3>\n";
        if (chart.spec.is_null())
            return out + html_paragraph("Nothing to draw: no cell has the figures of this chart.", "note");
        const auto still = pictures_.still.find(chart.name);
        out += fmt::format(
            "<div class=\"chart\" tabindex=\"0\" role=\"group\" aria-label=\"{0}\"><div "
            "id=\"chart-{1}\" data-chart=\"{1}\" data-label=\"{0}\"{2}>\n{3}</div></div>\n",
            html_text(chart.title), html_text(chart.name), room_for(chart),
            still != pictures_.still.end() ? still->second : grid_html(chart.fallback));
        out += shown_first(chart.spec) + paragraph(chart.how_to_read, "note");
        for (const std::string& note : chart.notes) out += html_paragraph(note, "note");
        return out;
    }

    /// Returns the style that keeps the room which the script's picture takes, so that nothing moves when it
    /// comes.
    [[nodiscard]] std::string room_for(const Chart& chart) const {
        const auto svg = pictures_.svg.find(chart.name);
        std::smatch height;
        if (svg == pictures_.svg.end() ||
            !std::regex_search(svg->second, height, std::regex(" height=\"(\\d+)")))
            return {};
        constexpr int choice_height = 34;
        const bool choice = input::json_text(chart.spec).find("\"shown_error\"") != std::string::npos;
        return fmt::format(" style=\"min-height:{}px\"", std::stoi(height[1]) + choice * choice_height);
    }

    /// Says which body or scene a chart of one shows before the bar chooses another.
    static std::string shown_first(const ChartJson& spec) {
        std::string shown;
        for (const ChartJson& param : spec.value("params", ChartJson::array()))
            if (const std::string name = param.value("name", "");
                name == "shown_shape" || name == "shown_scene")
                append(shown, param.value("value", ""));
        return shown.empty() ? shown : html_paragraph("Shown: " + shown + ".", "note shown");
    }

    const std::vector<Chart>& charts_;
    const StaticPictures& pictures_;
    const Glossary& glossary_;
    std::set<std::string> linked_;  ///< terms so far
    std::vector<TextGrid> grids_;
    nlohmann::json folds_ = nlohmann::json::array();
};

std::string contents(const std::vector<Chapter>& chapters) {
    std::string out = "<nav aria-label=\"Chapters\">";
    for (const Chapter& chapter : chapters)
        out += fmt::format("<a href=\"#{}\">{}</a>", chapter.id,
                           html_text(chapter.link.empty() ? chapter.title : chapter.link));
    return out + "<a href=\"#cells\">All cells</a></nav>\n";
}

std::string cells_html(const ReportData& data) {
    return "<section>\n" + html_heading("cells", "All cells") + html_paragraph(prose("cells.md")) +
           fmt::format(fmt::runtime(report_text("page.cells.html")),
                       fmt::arg("cells", plural(data.cell_count(), "cell"))) +
           "</section>\n";
}

std::string script_elements() {
    std::string out;
    for (const char* name : page_scripts) out += fmt::format("<script>{}</script>\n", report_text(name));
    return out;
}

std::string script_hashes() {
    std::string out;
    for (const char* name : page_scripts)
        append(out, fmt::format("'{}'", script_hash(report_text(fmt::format("{}.sha256", name)))), " ");
    return out;
}

}  // namespace

std::string page_html(const ReportData& data, const Answer& answer, const std::vector<Chapter>& chapters,
                      const std::vector<Chart>& charts, const StaticPictures& pictures,
                      const std::string& bundles) {
    const Glossary glossary(data);
    ChapterWriter writer(charts, pictures, glossary);
    std::string out = first_screen_html(answer, data) + contents(chapters);
    if (bundles.empty()) out += html_paragraph(prose("no_bundles.md"), "verdict part");
    if (!pictures.note.empty()) out += html_paragraph(pictures.note, "note");
    for (const Chapter& chapter : chapters) out += writer.chapter(chapter);
    out += cells_html(data);
    const std::string packed =
        packed_element("charts", bundles.empty() ? "{}" : charts_data(charts)) + writer.packed() +
        packed_element("cells", cells_data(data)) + packed_element("answers", answers_data(data)) +
        packed_element("maps", break_even_data(data)) + packed_element("statements", statements_data(data)) +
        packed_element("bodies", bodies_data(heat_on_bodies(data))) + bundles;
    return fmt::format(fmt::runtime(report_text("page.html")), fmt::arg("hashes", script_hashes()),
                       fmt::arg("style", report_text("page.css")), fmt::arg("chapters", out),
                       fmt::arg("scripts", packed + script_elements()));
}

namespace {

/// Seven digits: what a count up to ten million has, and more than any time.
ChartJson rounded(double value) { return std::stod(fmt::format("{:.7g}", value)); }

ChartJson identity_columns(const std::vector<const ReportCell*>& cells) {
    ChartJson columns = ChartJson::object();
    const auto add = [&](const char* name, const auto& get) {
        ChartJson values = ChartJson::array();
        for (const ReportCell* cell : cells) values.push_back(get(*cell));
        columns[name] = std::move(values);
    };
    add("cell", [](const ReportCell& cell) { return cell.hash.substr(0, 12); });
    add("scene", [](const ReportCell& cell) { return cell.scene_label; });
    add("shape", [](const ReportCell& cell) { return cell.shape; });
    add("vertices", [](const ReportCell& cell) { return cell.vertices; });
    add("edges", [](const ReportCell& cell) { return cell.edges; });
    add("algorithm", [](const ReportCell& cell) { return cell.algorithm; });
    add("table", [](const ReportCell& cell) { return cell.table; });
    add("queries", [](const ReportCell& cell) { return cell.queries; });
    add("status", [](const ReportCell& cell) { return std::string(to_string(cell.status)); });
    add("reason", [](const ReportCell& cell) { return cell.reason; });
    return columns;
}

/// A figure's values over all cells.
struct FigureValues {
    std::string unit;
    std::vector<ChartJson> values;
};

ChartJson value_json(const store::FigureRow& figure, DistinctTexts& reasons) {
    if (figure.value) return rounded(*figure.value);
    const std::string why = figure.remedy.empty() ? figure.reason : figure.reason + " – " + figure.remedy;
    return std::to_string(reasons.place(why));
}

/// Returns the values of a figure; if less than half of the cells have it, only those, with places in "at".
ChartJson figure_json(const std::string& name, FigureValues& column, std::size_t cells) {
    ChartJson json = {{"name", name}, {"unit", column.unit}};
    ChartJson at = ChartJson::array(), values = ChartJson::array();
    for (std::size_t i = 0; i < column.values.size(); ++i) {
        if (column.values[i].is_null()) continue;
        at.push_back(i);
        values.push_back(column.values[i]);
    }
    const bool is_rare = 2 * at.size() < cells;
    if (is_rare) json["at"] = std::move(at);
    json["values"] = is_rare ? std::move(values) : ChartJson(std::move(column.values));
    return json;
}

ChartJson grid_json(const TextGrid& grid) {
    ChartJson columns = ChartJson::array(), cells = ChartJson::array();
    for (std::size_t i = 0; i < grid.columns.size(); ++i) {
        columns.push_back({grid.columns[i].title, grid.columns[i].number});
        ChartJson column = ChartJson::array();
        for (const auto& row : grid.rows)
            column.push_back(row[i].why.empty() ? ChartJson(row[i].text)
                                                : ChartJson::array({row[i].text, row[i].why}));
        cells.push_back(std::move(column));
    }
    return {{"caption", grid.caption}, {"columns", columns}, {"cells", cells}};
}

/// Rows as columns; a row without a field has null there.
ChartJson columns_json(const ChartJson& rows) {
    ChartJson columns = ChartJson::object();
    std::size_t place = 0;
    for (const ChartJson& row : rows) {
        for (const auto& [name, value] : row.items()) {
            ChartJson& column = columns[name];
            while (column.size() < place) column.push_back(nullptr);
            column.push_back(value.is_number_float() ? rounded(value.get<double>()) : value);
        }
        ++place;
    }
    for (ChartJson& column : columns)
        while (column.size() < place) column.push_back(nullptr);
    return {{"columns", columns}, {"rows", place}};
}

}  // namespace

std::string cells_data(const ReportData& data) {
    const std::vector<const ReportCell*> cells = data.rows_and_peers();
    std::map<std::string, FigureValues> figures;
    DistinctTexts reasons;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        for (const store::FigureRow& figure : cells[i]->figures) {
            FigureValues& column = figures[figure_key(figure)];
            column.unit = figure.unit;
            column.values.resize(cells.size());
            column.values[i] = value_json(figure, reasons);
        }
    }
    ChartJson columns = ChartJson::array();
    for (auto& [name, column] : figures) columns.push_back(figure_json(name, column, cells.size()));
    return input::json_text(ChartJson{
        {"cells", identity_columns(cells)}, {"figures", std::move(columns)}, {"reasons", reasons.texts()}});
}

std::string grids_data(const std::vector<TextGrid>& grids) {
    ChartJson all = ChartJson::array();
    for (const TextGrid& grid : grids) all.push_back(grid_json(grid));
    return input::json_text(all);
}

std::string charts_data(const std::vector<Chart>& charts) {
    ChartJson all = ChartJson::object();
    for (const Chart& chart : charts) {
        if (chart.spec.is_null()) continue;
        ChartJson spec = chart.spec;
        if (spec.contains("data") && spec["data"].contains("values"))
            spec["data"]["values"] = columns_json(spec["data"]["values"]);
        all[chart.name] = std::move(spec);
    }
    return input::json_text(all);
}

}  // namespace edgewise::reports
