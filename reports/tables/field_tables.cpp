// SPDX-License-Identifier: MIT
#include "edgewise/reports/tables/tables.hpp"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/store/palette.hpp"

namespace edgewise::reports {

namespace {

constexpr store::FigureName field_number("fields.number.{field}"), field_lines("fields.lines.{whose}"),
    field_ratio("fields.time_ratio.{whose}"), ratio_low("fields.time_ratio_low.{whose}"),
    ratio_high("fields.time_ratio_high.{whose}"), lines_held("fields.lines_held"),
    time_held("fields.time_held");

/// Returns the names of fields in the order of their records.
std::vector<std::string> fields_of(const ReportCell& row) {
    std::vector<std::pair<double, std::string>> found;
    for (const store::FigureRow& figure : row.figures)
        if (auto field = field_number.value_in(figure.probe, figure.name); field && figure.value)
            found.emplace_back(*figure.value, std::move(*field));
    std::ranges::sort(found);
    std::vector<std::string> fields;
    for (auto& [place, field] : found) fields.push_back(std::move(field));
    return fields;
}

/// Machine and level of each figure of misses, in their order.
std::vector<std::pair<std::string, std::string>> levels_of(const ReportData& data) {
    std::set<std::pair<std::string, std::string>> levels;
    for (const ReportCell& row : data.fields) {
        for (const store::FigureRow& figure : row.figures) {
            if (figure.probe != "fields" || !figure.name.starts_with("misses.")) continue;
            const std::string rest = figure.name.substr(figure.name.find('.') + 1);
            const std::size_t first = rest.find('.'), last = rest.rfind('.');
            levels.emplace(rest.substr(0, first), rest.substr(first + 1, last - first - 1));
        }
    }
    return {levels.begin(), levels.end()};
}

GridCell time_cell(const ReportCell& row, const char* whose) {
    return interval_cell(row.figure(field_ratio.of(whose)), row.figure(ratio_low.of(whose)),
                         row.figure(ratio_high.of(whose)), 3);
}

GridCell verdict_cell(const measure::Figure& figure, const char* at_zero) {
    if (!figure.value) return figure_cell(figure);
    return {*figure.value > 0 ? "held" : *figure.value < 0 ? "did not hold" : at_zero};
}

std::vector<const ReportCell*> verified_rows(const ReportData& data) {
    std::vector<const ReportCell*> rows;
    for (const ReportCell& row : data.fields)
        if (row.verified()) rows.push_back(&row);
    return rows;
}

}  // namespace

TextGrid field_advice_grid(const ReportData& data) {
    const auto levels = levels_of(data);
    constexpr store::FigureName misses("fields.misses.{machine}.{level}.{whose}"),
        unseen("fields.unseen_lines.{whose}");
    TextGrid grid{"Advice, and what became of it: per query of all queries",
                  columns_of("scene|shape|algorithm|table|#lines|#predicted|#counted|lines|#unseen queries: "
                             "lines|#as advised|#time, advised|#noise|time|#made by hand: lines|#its time")};
    for (const auto& [machine, level] : levels) {
        grid.columns.push_back({fmt::format("misses, {} {}", machine, level), true});
        grid.columns.push_back({"as advised", true});
    }
    for (const ReportCell* row : verified_rows(data)) {
        auto cells = grid_row(
            row->scene_label, row->shape, row->algorithm, row->table, row->figure(field_lines.of("original")),
            row->figure(field_lines.of("predicted")), row->figure(field_lines.of("advised")),
            verdict_cell(row->figure(lines_held), "did not hold"), row->figure(unseen.of("original")),
            row->figure(unseen.of("advised")), time_cell(*row, "advised"), time_cell(*row, "control"),
            verdict_cell(row->figure(time_held), "within the noise"), row->figure(field_lines.of("beside")),
            time_cell(*row, "beside"));
        for (const auto& [machine, level] : levels)
            for (const char* whose : {"original", "advised"})
                cells.push_back(figure_cell(row->figure(misses.of(machine, level, whose))));
        grid.rows.push_back(std::move(cells));
    }
    return grid;
}

TextGrid field_groups_grid(const ReportCell& row) {
    constexpr store::FigureName own("fields.own_group.{field}"), advised("fields.advised_group.{field}"),
        bytes("fields.bytes.{field}");
    std::map<double, std::pair<std::string, double>> now, then;  // by number of the record: names and bytes
    for (const std::string& field : fields_of(row)) {
        const double size = row.figure(bytes.of(field)).value.value_or(0);
        for (const auto& [name, to] : {std::pair(own, &now), std::pair(advised, &then)}) {
            const auto group = row.figure(name.of(field)).value;
            if (!group) continue;
            auto& [names, sum] = (*to)[*group];
            append(names, field);
            sum += size;
        }
    }
    TextGrid grid{fmt::format("{} and {}: records", row.table, row.algorithm),
                  columns_of("records|fields|#bytes of fields")};
    for (const auto& [whose, groups] : {std::pair("now", &now), std::pair("advised", &then)})
        for (const auto& [group, fields] : *groups)
            grid.add(whose, fields.first, static_cast<int>(fields.second));
    return grid;
}

std::string field_verdict(const ReportData& data) {
    std::size_t rows = 0, lines_right = 0, faster = 0, slower = 0;
    for (const ReportCell* row : verified_rows(data)) {
        const auto time = row->figure(time_held).value, line = row->figure(lines_held).value;
        if (!time || !line) continue;
        ++rows;
        lines_right += *line > 0;
        faster += *time > 0;
        slower += *time < 0;
    }
    if (rows == 0) return " Not measured here: `edgewise sweep --plan full` does, or `edgewise fields`.";
    return fmt::format(
        " Of {} tables and algorithms the advice held in lines {} times; in time it held {} times, made {} slower, "
        "and was within the noise of {}.",
        rows, lines_right, faster, slower, rows - faster - slower);
}

namespace {

constexpr int square = 26, left_margin = 118, top_margin = 150, letter_width = 6;

int at(std::size_t place) { return static_cast<int>(place) * square; }

/// The part that a square shows: above the diagonal of queries that read either field those that read both,
/// below it likewise of steps, on it the steps that read the field.
double shown_part(const ReportCell& row, const std::vector<std::string>& fields, std::size_t a,
                  std::size_t b) {
    constexpr store::FigureName step_part("fields.step_part.{field}"),
        same_query("fields.same_query.{field}.{other}"), same_step("fields.same_step.{field}.{other}");
    const store::FigureName name = a == b  ? step_part.of(fields[a])
                                   : a < b ? same_query.of(fields[a], fields[b])
                                           : same_step.of(fields[b], fields[a]);
    return row.figure(name).value.value_or(0);
}

/// A square, its number in hundredths, and what it means when pointed at.
std::string cell(std::size_t row, std::size_t column, double part, const std::string& what) {
    const int x = left_margin + at(column), y = top_margin + at(row);
    return fmt::format(
        "<g><title>{}: {:.3f}</title><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\" "
        "fill-opacity=\"{:.3f}\"/><text x=\"{}\" y=\"{}\" text-anchor=\"middle\" font-size=\"9\">{:.0f}</text></g>\n",
        html_text(what), part, x, y, square - 1, square - 1, store::component_colour("voronoi_planes"),
        0.75 * part, x + square / 2, y + square / 2 + 3, 100 * part);
}

std::string labels(const std::vector<std::string>& fields) {
    std::string text;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const std::string name = html_text(fields[i]);
        const int middle = at(i) + square / 2;
        text += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>\n", left_margin - 6,
                            top_margin + middle + 4, name);
        text += fmt::format("<text transform=\"translate({},{}) rotate(-60)\">{}</text>\n",
                            left_margin + middle + 4, top_margin - 6, name);
    }
    return text;
}

/// Around the fields of each record; `records`: the number of each field's.
std::string frames(const std::vector<double>& records) {
    std::string text;
    for (std::size_t first = 0; first < records.size();) {
        std::size_t last = first + 1;
        while (last < records.size() && records[last] == records[first]) ++last;
        text += fmt::format(
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"currentColor\"/>\n",
            left_margin + at(first), top_margin + at(first), at(last - first) - 1, at(last - first) - 1);
        first = last;
    }
    return text;
}

}  // namespace

std::string field_picture(const ReportCell& row) {
    const std::vector<std::string> fields = fields_of(row);
    std::vector<double> records;
    std::string body;
    for (std::size_t a = 0; a < fields.size(); ++a) {
        constexpr store::FigureName own("fields.own_group.{field}");
        records.push_back(row.figure(own.of(fields[a])).value.value_or(0));
        for (std::size_t b = 0; b < fields.size(); ++b) {
            const std::string what =
                a == b ? fmt::format("steps that read {}", fields[a])
                       : fmt::format("{} and {}, same {}", fields[a], fields[b], a < b ? "query" : "step");
            body += cell(a, b, shown_part(row, fields, a, b), what);
        }
    }
    const std::string title =
        fmt::format("{} {}, {} {}", row.table, row.algorithm, row.scene_label, row.shape);
    const std::string caption =
        "hundredths of what reads either field; above the diagonal same query, below same step, framed: a record";
    const int side = at(fields.size()), letters = static_cast<int>(std::max(title.size(), caption.size()));
    const int width = std::max(left_margin + side + 60, 16 + letters * letter_width);
    const int height = top_margin + side + 12;
    const std::string start = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" ",
        width, height);
    const std::string style = "font-family=\"sans-serif\" font-size=\"11\" fill=\"currentColor\">\n";
    const std::string heading = fmt::format(
        "<title>{0}</title>\n<text x=\"8\" y=\"16\" font-weight=\"bold\">{0}</text>\n", html_text(title));
    return start + style + heading + fmt::format("<text x=\"8\" y=\"32\">{}</text>\n", caption) + body +
           labels(fields) + frames(records) + "</svg>\n";
}

}  // namespace edgewise::reports
