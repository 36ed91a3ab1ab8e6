// SPDX-License-Identifier: MIT
//
// Reasons are numbered under each table, so that they are read without a mouse and on
// paper.
#include "edgewise/reports/tables/text_grid.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "edgewise/input/shown_text.hpp"

namespace edgewise::reports {

namespace {

std::string html_cell(const GridCell& cell, bool number, DistinctTexts& reasons) {
    if (!cell.why.empty())
        return fmt::format("<td class=\"missing{}\">{}<sup>{}</sup></td>", number ? " number" : "",
                           html_text(cell.text), reasons.place(cell.why) + 1);
    return fmt::format("<td{}>{}</td>", number ? " class=\"number\"" : "", html_text(cell.text));
}

std::string html_reasons(const DistinctTexts& reasons) {
    if (reasons.texts().empty()) return {};
    std::string out = "<ol class=\"reasons\">\n";
    for (const std::string& why : reasons.texts()) out += fmt::format("<li>{}</li>\n", html_text(why));
    return out + "</ol>\n";
}

std::string markdown_cell(const GridCell& cell, DistinctTexts& reasons) {
    if (cell.why.empty()) return markdown_text(cell.text);
    return fmt::format("{} ({})", markdown_text(cell.text), reasons.place(cell.why) + 1);
}

/// "0", or "0 (28 of 29)": over those that have the figure.
bool is_zero(const std::string& text) { return text == "0" || text.starts_with("0 ("); }

constexpr std::size_t between = 2;      ///< blanks
constexpr std::size_t least_last = 24;  ///< characters, of a folded column

/// A row for a terminal; each reason is named once, at the first cell that lacks a value for it.
std::vector<std::string> text_row(const std::vector<GridCell>& row, DistinctTexts& reasons) {
    std::vector<std::string> texts;
    std::string named;
    for (const GridCell& cell : row) {
        const bool again = cell.why.empty() || cell.why == named;
        if (!again) named = cell.why;
        texts.push_back(!again              ? fmt::format("- [{}]", reasons.place(cell.why) + 1)
                        : !cell.why.empty() ? "-"
                                            : input::shown_line(cell.text));
    }
    return texts;
}

std::size_t longest_word(const std::string& text) {
    std::istringstream words(text);
    std::size_t longest = 0;
    for (std::string word; words >> word;) longest = std::max(longest, shown_width(word));
    return longest;
}

/// Returns the titles, each folded to the width of its column.
std::vector<std::vector<std::string>> title_lines(const std::vector<GridColumn>& columns,
                                                  const std::vector<std::size_t>& widths) {
    std::vector<std::vector<std::string>> lines;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        std::istringstream pieces(wrapped(columns[i].title, widths[i]));
        std::size_t line = 0;
        for (std::string piece; std::getline(pieces, piece); ++line) {
            if (lines.size() == line) lines.emplace_back(columns.size());
            lines[line][i] = piece;
        }
    }
    return lines;
}

/// Every column but the last as wide as its widest text; the last one folded in `room` characters.
std::string text_line(const std::vector<std::string>& row, const std::vector<GridColumn>& columns,
                      const std::vector<std::size_t>& widths, std::size_t room, std::size_t start) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
        const bool last = i + 1 == row.size();
        const std::string fill(widths[i] - shown_width(row[i]), ' ');
        if (last && !columns[i].number)
            line += wrapped(row[i], room, start);
        else
            line += columns[i].number ? fill + row[i] : row[i] + fill;
        if (!last) line += std::string(between, ' ');
    }
    line.erase(line.find_last_not_of(' ') + 1);
    return line + '\n';
}

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

GridCell figure_cell(const ReportCell* cell, const store::FigureName& name) {
    return cell ? figure_cell(cell->figure(name)) : GridCell{"–"};
}

GridCell ratio_cell(const ReportCell* above, const store::FigureName& name, const ReportCell* below,
                    const store::FigureName& name_below) {
    return above && below ? ratio_cell(above->figure(name), below->figure(name_below)) : GridCell{"–"};
}

GridCell interval_cell(const measure::Figure& middle, const measure::Figure& low, const measure::Figure& high,
                       int digits) {
    if (!middle.value || !low.value || !high.value) return figure_cell(middle);
    return {fmt::format("{1:.{0}f} [{2:.{0}f}, {3:.{0}f}]", digits, *middle.value, *low.value, *high.value)};
}

GridCell name_cell(const ReportCell& cell, std::string_view name) {
    using Name = GridCell (*)(const ReportCell&);
    static const std::map<std::string_view, Name> names = {
        {"scene", [](const ReportCell& of) { return grid_cell(of.scene_label); }},
        {"shape", [](const ReportCell& of) { return grid_cell(of.shape); }},
        {"family", [](const ReportCell& of) { return grid_cell(of.shape); }},
        {"vertices", [](const ReportCell& of) { return grid_cell(of.vertices); }},
        {"algorithm", [](const ReportCell& of) { return grid_cell(of.algorithm); }},
        {"table type", [](const ReportCell& of) { return grid_cell(of.table); }},
        {"algorithm or library",
         [](const ReportCell& of) { return grid_cell(of.judged() ? of.layout : of.algorithm); }},
        {"table type or precision",
         [](const ReportCell& of) { return grid_cell(of.judged() ? of.precision : of.table); }},
        {"status", [](const ReportCell& of) { return grid_cell(to_string(of.status)); }}};
    return names.at(name)(cell);
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
        const bool zero =
            grid.columns[i].number && !grid.rows.empty() &&
            std::ranges::all_of(grid.rows, [&](const auto& row) { return is_zero(row[i].text); });
        if (!zero) continue;
        append(zeros, grid.columns[i].title);
        const auto place = static_cast<std::ptrdiff_t>(i);
        grid.columns.erase(grid.columns.begin() + place);
        for (auto& row : grid.rows) row.erase(row.begin() + place);
    }
    if (!zeros.empty()) grid.caption += fmt::format(". 0 in every row: {}", zeros);
}

std::string grid_html(const TextGrid& grid, std::size_t most) {
    DistinctTexts reasons;
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
    DistinctTexts reasons;
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

std::string grid_text(const TextGrid& grid, std::size_t width) {
    DistinctTexts reasons;
    std::vector<std::vector<std::string>> rows;
    for (const auto& row : grid.rows) rows.push_back(text_row(row, reasons));
    std::vector<std::size_t> widths;
    for (const GridColumn& column : grid.columns) widths.push_back(longest_word(column.title));
    for (const auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], shown_width(row[i]));
    std::size_t start = 0;  // of the last column
    for (std::size_t i = 0; i + 1 < widths.size(); ++i) start += widths[i] + between;
    const std::size_t room = std::max(start + least_last, width) - start;
    std::string out;
    for (const auto& lines : {title_lines(grid.columns, widths), rows})
        for (const auto& line : lines) out += text_line(line, grid.columns, widths, room, start);
    for (std::size_t i = 0; i < reasons.texts().size(); ++i)
        out += fmt::format("[{}] {}\n", i + 1, wrapped(input::shown_line(reasons.texts()[i]), width - 4, 4));
    return out;
}

namespace {

using Json = nlohmann::json;

struct MemberColumn {
    Json::json_pointer member;
    double unit = 1;
    int digits = -1;
};

/// "#KiB = bytes 1024 0": the title is taken off.
MemberColumn member_column(std::string& title) {
    const std::size_t equals = title.find(" = ");
    if (equals == std::string::npos) return {Json::json_pointer("/" + title)};
    std::istringstream rest(title.substr(equals + 3));
    title.resize(equals);
    std::string member;
    MemberColumn column;
    rest >> member >> column.unit >> column.digits;
    column.member = Json::json_pointer("/" + member);
    return column;
}

std::string member_text(const Json& value, const MemberColumn& column) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_array()) {
        std::string list;
        for (const Json& item : value) append(list, member_text(item, column));
        return list;
    }
    if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
    if (column.digits >= 0) return fmt::format("{:.{}f}", value.get<double>() / column.unit, column.digits);
    if (value.is_number_float() || column.unit != 1) return number_text(value.get<double>() / column.unit);
    return value.dump();
}

std::string reason_of(const Json& object) {
    std::string why;
    for (const char* part : {"reason", "remedy"})
        if (object.contains(part) && object[part].is_string())
            append(why, object[part].get<std::string>(), "; ");
    return why;
}

/// Returns the reason for a missing value: a member next to it, or one of its row.
GridCell member_cell(const Json& row, const MemberColumn& column, bool numeric) {
    const Json value = row.contains(column.member) ? row.at(column.member) : Json();
    if (!value.is_null()) return {member_text(value, column)};
    const Json::json_pointer owner = column.member.parent_pointer();
    std::string why = row.contains(owner) ? reason_of(row.at(owner)) : "";
    if (why.empty()) why = reason_of(row);
    return why.empty() ? GridCell{numeric ? "-" : ""} : missing_cell(why);
}

}  // namespace

TextGrid member_grid(const Json& rows, std::string_view columns) {
    TextGrid grid{"", columns_of(columns)};
    std::vector<MemberColumn> members;
    for (GridColumn& column : grid.columns) members.push_back(member_column(column.title));
    for (const Json& row : rows) {
        std::vector<GridCell>& cells = grid.rows.emplace_back();
        for (std::size_t i = 0; i < members.size(); ++i)
            cells.push_back(member_cell(row, members[i], grid.columns[i].number));
    }
    return grid;
}

}  // namespace edgewise::reports
