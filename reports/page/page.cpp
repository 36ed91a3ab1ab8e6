// SPDX-License-Identifier: MIT
//
// The page: the answer, what to look at, what passed, then the chapters; what is long is packed and made when
// it is opened. Its frame is page.html; its policy loads nothing from anywhere, and runs no scripts except
// the page's own, known by their hashes, and the code that these start from the page's own packed bundles.
#include "edgewise/reports/page/page.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/body/body_heat.hpp"
#include "edgewise/reports/page/chapters/chapters.hpp"
#include "edgewise/reports/page/chapters/glossary.hpp"
#include "edgewise/reports/page/first_screen/first_screen.hpp"
#include "edgewise/reports/page/html.hpp"
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

    std::string chapter(const Chapter& chapter) {
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
            "id=\"chart-{1}\" data-chart=\"{1}\" data-label=\"{0}\">\n{2}</div></div>\n",
            html_text(chart.title), html_text(chart.name),
            still != pictures_.still.end() ? still->second : grid_html(chart.fallback, 6));
        out += paragraph(chart.how_to_read, "note");
        for (const std::string& note : chart.notes) out += html_paragraph(note, "note");
        return out;
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

/// The bar over the chapters, by which their charts and tables show one scene, body, algorithm or precision.
/// Hidden until the scripts run.
std::string filter_bar_html(const ReportData& data) {
    const std::string all = html_option("", "all", true);
    std::string scenes = all, shapes = all, algorithms = all, precisions = all;
    std::set<std::string> of_algorithms, of_precisions;
    for (const ReportCell* cell : data.swept())
        of_algorithms.insert(cell->algorithm), of_precisions.insert(cell->precision);
    for (const std::string& label : scene_labels(data)) scenes += html_option(label, label);
    for (const auto& [vertices, shape] : shapes_by_vertices(data))
        shapes += html_option(shape, fmt::format("{} ({})", vertices, shape));
    for (const std::string& name : of_algorithms) algorithms += html_option(name, algorithm_title(name));
    for (const std::string& name : of_precisions) precisions += html_option(name, name);
    return fmt::format(fmt::runtime(report_text("page.filter.html")),
                       fmt::arg("scene", html_select("filter-scene", "scene", scenes)),
                       fmt::arg("shape", html_select("filter-shape", "vertices", shapes)),
                       fmt::arg("algorithm", html_select("filter-algorithm", "algorithm", algorithms)),
                       fmt::arg("precision", html_select("filter-precision", "precision", precisions)));
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
    std::string out = first_screen_html(answer, data) + contents(chapters) + filter_bar_html(data);
    if (bundles.empty()) out += html_paragraph(prose("no_bundles.md"), "verdict part");
    if (!pictures.note.empty()) out += html_paragraph(pictures.note, "note");
    for (const Chapter& chapter : chapters) out += writer.chapter(chapter);
    out += cells_html(data);
    const std::string packed = packed_element("charts", bundles.empty() ? "{}" : charts_data(charts)) +
                               writer.packed() + packed_element("cells", cells_data(data)) +
                               packed_element("answers", answers_data(data)) +
                               packed_element("maps", break_even_data(data)) +
                               packed_element("bodies", bodies_data(heat_on_bodies(data))) + bundles;
    return fmt::format(fmt::runtime(report_text("page.html")), fmt::arg("hashes", script_hashes()),
                       fmt::arg("style", report_text("page.css")), fmt::arg("chapters", out),
                       fmt::arg("scripts", packed + script_elements()));
}

}  // namespace edgewise::reports
