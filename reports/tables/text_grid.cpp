// SPDX-License-Identifier: MIT
//
// Reasons are numbered under each table, so that they are read without a mouse and on
// paper.
#include "edgewise/reports/tables/text_grid.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <sstream>

#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

/// The distinct reasons of one table, numbered from 1 in order of appearance.
class Reasons {
  public:
    std::size_t number(const std::string& why) {
        const auto at = std::find(texts_.begin(), texts_.end(), why);
        if (at != texts_.end()) return static_cast<std::size_t>(at - texts_.begin()) + 1;
        texts_.push_back(why);
        return texts_.size();
    }
    [[nodiscard]] const std::vector<std::string>& texts() const { return texts_; }

  private:
    std::vector<std::string> texts_;
};

std::string html_cell(const GridCell& cell, bool number, Reasons& reasons) {
    if (!cell.why.empty())
        return fmt::format("<td class=\"missing{}\">{}<sup>{}</sup></td>", number ? " number" : "",
                           html_text(cell.text), reasons.number(cell.why));
    return fmt::format("<td{}>{}</td>", number ? " class=\"number\"" : "", html_text(cell.text));
}

std::string html_reasons(const Reasons& reasons) {
    if (reasons.texts().empty()) return {};
    std::string out = "<ol class=\"reasons\">\n";
    for (const std::string& why : reasons.texts()) out += fmt::format("<li>{}</li>\n", html_text(why));
    return out + "</ol>\n";
}

std::string markdown_cell(const GridCell& cell, Reasons& reasons) {
    if (cell.why.empty()) return markdown_text(cell.text);
    return fmt::format("{} ({})", markdown_text(cell.text), reasons.number(cell.why));
}

/// "0", or "0 (28 of 29)": over those that have the figure.
bool is_zero(const std::string& text) { return text == "0" || text.starts_with("0 ("); }

}  // namespace

GridCell missing_cell(const std::string& why) {
    return {"not measured", why.empty() ? "no reason given" : why};
}

GridCell figure_cell(const measure::Figure& figure, double unit, int digits) {
    if (!figure.value)
        return missing_cell(figure.remedy.empty() ? figure.reason : figure.reason + " – " + figure.remedy);
    if (digits >= 0) return {fmt::format("{:.{}f}", *figure.value / unit, digits)};
    if (unit != 1) return {number_text(*figure.value / unit)};
    const bool verified = figure.unit.find("unverified") == std::string::npos;
    return {number_text(*figure.value, figure.unit) + (verified ? "" : " *")};
}

GridCell ratio_cell(const measure::Figure& above, const measure::Figure& below) {
    if (!above.value) return figure_cell(above);
    if (!below.value || *below.value <= 0) return figure_cell(below);
    return figure_cell(above, *below.value, 3);
}

std::vector<GridColumn> columns_of(std::string_view titles) {
    std::vector<GridColumn> columns;
    std::istringstream rest{std::string(titles)};
    for (std::string title; std::getline(rest, title, '|');) {
        const bool number = title.starts_with('#');
        columns.push_back({number ? title.substr(1) : title, number});
    }
    return columns;
}

void drop_zero_columns(TextGrid& grid) {
    std::string zeros;
    for (std::size_t i = grid.columns.size(); i-- > 0;) {
        const bool zero = grid.columns[i].number && !grid.rows.empty() &&
                          std::all_of(grid.rows.begin(), grid.rows.end(),
                                      [&](const auto& row) { return is_zero(row[i].text); });
        if (!zero) continue;
        append(zeros, grid.columns[i].title);
        const auto place = static_cast<std::ptrdiff_t>(i);
        grid.columns.erase(grid.columns.begin() + place);
        for (auto& row : grid.rows) row.erase(row.begin() + place);
    }
    if (!zeros.empty()) grid.caption += fmt::format(". 0 in every row: {}", zeros);
}

std::string grid_html(const TextGrid& grid, std::size_t most) {
    Reasons reasons;
    std::string out =
        fmt::format("<div class=\"wide\" tabindex=\"0\" role=\"group\" aria-label=\"{}\"><table>\n",
                    html_text(grid.caption.empty() ? "table" : grid.caption));
    if (!grid.caption.empty()) out += fmt::format("<caption>{}</caption>\n", html_text(grid.caption));
    out += "<thead><tr>";
    for (const GridColumn& column : grid.columns)
        out += fmt::format("<th scope=\"col\"{}>{}</th>", column.number ? " class=\"number\"" : "",
                           html_text(column.title));
    out += "</tr></thead>\n<tbody>\n";
    for (const auto& row : grid.rows) {
        if (most-- == 0) break;
        out += "<tr>";
        for (std::size_t i = 0; i < row.size(); ++i)
            out += html_cell(row[i], grid.columns[i].number, reasons);
        out += "</tr>\n";
    }
    return out + "</tbody></table></div>\n" + html_reasons(reasons);
}

std::string grid_markdown(const TextGrid& grid) {
    Reasons reasons;
    std::string out = grid.caption.empty() ? "" : fmt::format("*{}*\n\n", markdown_text(grid.caption));
    std::string rule = "|";
    out += "|";
    for (const GridColumn& column : grid.columns) {
        out += fmt::format(" {} |", markdown_text(column.title));
        rule += column.number ? " ---: |" : " --- |";
    }
    out += "\n" + rule + "\n";
    for (const auto& row : grid.rows) {
        out += "|";
        for (const GridCell& cell : row) out += fmt::format(" {} |", markdown_cell(cell, reasons));
        out += "\n";
    }
    if (!reasons.texts().empty()) out += "\n";
    for (std::size_t i = 0; i < reasons.texts().size(); ++i)
        out += fmt::format("{}. {}\n", i + 1, markdown_text(reasons.texts()[i]));
    return out + "\n";
}

}  // namespace edgewise::reports
