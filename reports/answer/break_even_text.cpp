// SPDX-License-Identifier: MIT
#include "edgewise/reports/answer/break_even_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "edgewise/reports/answer/answer_text.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

template <class Use>
void each_cell(const BreakEvenMap& map, const Use& use) {
    for (const MapPanel& panel : map.panels)
        for (const MapRow& row : panel.rows)
            for (std::size_t i = 0; i < row.cells.size(); ++i) use(row.cells[i], i);
}

/// Returns the answer at a place, short enough to be compared with its neighbour.
std::string answer_at(const MapCell& cell) {
    if (!cell.winner()) return "nothing within the error";
    if (cell.scene->too_noisy) return "too noisy to tell";
    std::string text = layout_name(*cell.winner());
    const std::vector<std::string> others = cell.tied_layouts();
    if (others.empty()) return text;
    if (others.size() > 2) return fmt::format("a tie of {} ({} first)", others.size() + 1, text);
    for (const std::string& other : others) text += " or " + other;
    return text + " (a tie)";
}

/// Returns "up to 8 vertices GJK on lean; 38: ...; from 386 on V-Clip on aos".
std::string map_line_of(const MapRow& row, const std::vector<MapColumn>& columns) {
    struct Stretch {
        std::int64_t from, to;
        std::string answer;
    };
    std::vector<Stretch> stretches;
    std::size_t measured = 0;
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
        if (!row.cells[i].scene) continue;
        ++measured;
        const std::string there = answer_at(row.cells[i]);
        const std::int64_t vertices = columns[i].vertices;
        if (stretches.empty() || stretches.back().answer != there)
            stretches.push_back({vertices, vertices, there});
        stretches.back().to = vertices;
    }
    if (measured < 2) return {};
    if (stretches.size() == 1)
        return fmt::format("{} from {} to {} vertices", stretches.front().answer, stretches.front().from,
                           stretches.front().to);
    std::string text;
    for (const Stretch& one : stretches)
        append(text,
               one.from == one.to ? fmt::format("{} vertices {}", one.from, one.answer)
                                  : fmt::format("{} to {} vertices {}", one.from, one.to, one.answer),
               "; ");
    return text;
}

/// Returns the columns with most measured cells, in the map's order.
std::vector<std::size_t> fullest_columns(const BreakEvenMap& map, std::size_t most) {
    std::vector<std::size_t> counts(map.columns.size()), columns(map.columns.size());
    each_cell(map, [&](const MapCell& cell, std::size_t i) { counts[i] += cell.scene != nullptr; });
    std::iota(columns.begin(), columns.end(), std::size_t{0});
    std::ranges::stable_sort(columns, [&](std::size_t a, std::size_t b) { return counts[a] > counts[b]; });
    if (columns.size() > most) columns.resize(most);
    std::ranges::sort(columns);
    return columns;
}

GridCell grid_cell_of(const MapCell& cell) {
    if (!cell.winner()) return missing_cell(cell.why);
    const std::string text = cell.winner()->name() + " " + ratio_text(*cell.winner());
    if (cell.scene->too_noisy) return {text + ", too noisy to tell"};
    return {cell.scene->ties.size() == 1 ? text : fmt::format("{}, {} tie", text, cell.scene->ties.size())};
}

}  // namespace

std::string break_even_sentence(const BreakEvenMap& map) {
    if (map.measured() == 0) return {};
    std::size_t won = 0, tied = 0, noisy = 0;
    std::map<std::string, std::size_t> winners;
    each_cell(map, [&](const MapCell& cell, std::size_t) {
        if (!cell.winner()) return;
        if (cell.scene->too_noisy)
            ++noisy;
        else if (cell.is_won())
            ++won, ++winners[layout_name(*cell.winner())];
        else
            ++tied;
    });
    std::vector<std::pair<std::string, std::size_t>> most(winners.begin(), winners.end());
    std::ranges::stable_sort(most, [](const auto& a, const auto& b) { return a.second > b.second; });
    std::string names;
    for (const auto& [name, count] : most) append(names, fmt::format("{} {}", name, count));
    return fmt::format(
        "Of {} that were measured, one algorithm and layout wins in {}{}; several tie in {}, and {} are too "
        "noisy to tell.",
        plural(map.measured(), "place"), won, names.empty() ? "" : " (" + names + ")", tied, noisy);
}

std::vector<std::string> break_even_lines(const BreakEvenMap& map) {
    std::vector<std::string> lines;
    for (const MapPanel& panel : map.panels)
        for (const MapRow& row : panel.rows)
            if (const std::string line = map_line_of(row, map.columns); !line.empty())
                lines.push_back(fmt::format("{}, {}: {}.", row.coherence, panel.tables, line));
    return lines;
}

std::string cell_text(const MapCell& cell) {
    const RankedCell* const winner = cell.winner();
    if (!winner) return cell.scene ? cell.scene->label + ": " + cell.why : "Not measured: " + cell.why;
    std::string text =
        fmt::format("{}. {}; {} ns", cell.scene->label, tie_set_text(*cell.scene), number_text(winner->ns));
    if (cell.scene->too_noisy) text += "; too noisy to tell";
    if (const RankedCell* const other = cell.best_of_others())
        text += fmt::format("; {} takes {:.2f} times as long", other->name(), other->ratio / winner->ratio);
    if (cell.further_scenes > 0)
        text += fmt::format("; {} of this place", plural(cell.further_scenes, "further scene"));
    return text;
}

TextGrid break_even_grid(const BreakEvenMap& map, std::size_t most_columns) {
    TextGrid grid{"The fastest within the error, and its time over the baseline's", {}, {}};
    const std::vector<std::size_t> shown = fullest_columns(map, most_columns);
    grid.columns = columns_of("tables|queries");
    for (const std::size_t i : shown)
        grid.columns.push_back({fmt::format("{} ({})", map.columns[i].vertices, map.columns[i].shape)});
    for (const MapPanel& panel : map.panels) {
        for (const MapRow& row : panel.rows) {
            std::vector<GridCell> cells = grid_row(panel.tables, row.coherence);
            for (const std::size_t i : shown) cells.push_back(grid_cell_of(row.cells[i]));
            grid.rows.push_back(std::move(cells));
        }
    }
    if (shown.size() < map.columns.size())
        grid.caption += fmt::format("; {} of {} bodies", shown.size(), map.columns.size());
    return grid;
}

}  // namespace edgewise::reports
