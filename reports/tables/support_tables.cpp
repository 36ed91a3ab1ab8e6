// SPDX-License-Identifier: MIT
//
// A claim on a layout that is not the paper's: support queries on a line per vertex, "up to five times" as
// fast (arXiv 2509.03753), beside the same on separate arrays.
#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <vector>

#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

constexpr double claimed = 5;
constexpr store::FigureName query_ns("support.query_ns.{start}");

/// The same scene, shape, precision and start on both layouts; `faster`: separate over line.
struct Compared {
    const ReportCell *line, *separate;
    std::string start;
    measure::Figure line_ns, separate_ns;

    [[nodiscard]] bool known() const { return line_ns.value && separate_ns.value && *line_ns.value > 0; }
    [[nodiscard]] double faster() const { return *separate_ns.value / *line_ns.value; }
};

/// Plain cells alone: their table is the type's name.
bool is_plain(const ReportCell& cell, const char* layout) {
    return cell.verified() && cell.algorithm == "gjk" && cell.layout == layout &&
           cell.table == cell.layout + "_" + cell.precision;
}

std::vector<Compared> compared(const ReportData& data) {
    std::vector<Compared> all;
    const std::vector<const ReportCell*> cells = data.swept();
    for (const ReportCell* line : cells) {
        if (!is_plain(*line, "line_per_vertex")) continue;
        const auto same = [&](const ReportCell* other) {
            return is_plain(*other, "aos") && other->scene_label == line->scene_label &&
                   other->shape == line->shape && other->precision == line->precision;
        };
        const auto separate = std::find_if(cells.begin(), cells.end(), same);
        if (separate == cells.end()) continue;
        for (const std::string start : {"cold", "warm"}) {
            const store::FigureName name = query_ns.of(start);
            all.push_back({line, *separate, start, line->figure(name), (*separate)->figure(name)});
        }
    }
    return all;
}

}  // namespace

TextGrid support_grid(const ReportData& data) {
    TextGrid grid{
        "Support queries, ns",
        columns_of("scene|shape|precision|start|#separate arrays|#line per vertex|#separate / line")};
    for (const Compared& row : compared(data))
        grid.add(row.line->scene_label, row.line->shape, row.line->precision, row.start, row.separate_ns,
                 row.line_ns, ratio_cell(row.separate_ns, row.line_ns));
    return grid;
}

std::string support_verdict(const ReportData& data) {
    std::vector<Compared> all = compared(data);
    std::erase_if(all, [](const Compared& row) { return !row.known(); });
    if (all.empty())
        return " Verdict: not measured; `edgewise sweep --layouts aos,line_per_vertex` measures it.";
    const auto slower = [](const Compared& a, const Compared& b) { return a.faster() < b.faster(); };
    const Compared& best = *std::max_element(all.begin(), all.end(), slower);
    const auto below =
        std::count_if(all.begin(), all.end(), [](const Compared& row) { return row.faster() < 1; });
    return fmt::format(
        " Verdict: {}; at most {:.2f} times as fast ({}, {}, {}, {} start), and slower in {} of {} comparisons.",
        best.faster() >= claimed ? "held" : "not held", best.faster(), best.line->scene_label,
        best.line->shape, best.line->precision, best.start, below, all.size());
}

}  // namespace edgewise::reports
