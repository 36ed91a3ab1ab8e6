// SPDX-License-Identifier: MIT
#include "edgewise/reports/answer/break_even_map.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "edgewise/reports/answer/answer_text.hpp"
#include "edgewise/reports/reader.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

struct MapPlace {
    int tables = 0;
    Coherence coherence;

    auto operator<=>(const MapPlace&) const = default;
};

std::optional<MapPlace> place_of(const ReportCell& cell) {
    const auto coherence = coherence_of(cell);
    const auto tables = tables_class(cell);
    if (!coherence || !tables) return std::nullopt;
    return MapPlace{*tables, *coherence};
}

std::string scene_key(const ReportCell& cell) { return cell.scene + '\n' + cell.scene_parameters; }

/// Returns the bodies with timed cells, fewest vertices first; if there are too many, those with most scenes.
std::vector<MapColumn> columns_of_data(const ReportData& data, BreakEvenMap& map) {
    std::map<std::pair<std::int64_t, std::string>, std::set<std::string>> scenes;
    for (const ReportCell* cell : data.swept()) {
        std::set<std::string>& of = scenes[{cell->vertices, cell->shape}];
        if (cell->is_timed()) of.insert(scene_key(*cell));
    }
    map.bodies_not_timed = std::erase_if(scenes, [](const auto& body) { return body.second.empty(); });
    std::vector<std::pair<std::size_t, MapColumn>> columns;
    for (const auto& [body, of] : scenes) columns.push_back({of.size(), {body.second, body.first}});
    std::ranges::stable_sort(columns, [](const auto& a, const auto& b) { return a.first > b.first; });
    map.columns_left_out = columns.size() > most_map_columns ? columns.size() - most_map_columns : 0;
    columns.resize(columns.size() - map.columns_left_out);
    std::vector<MapColumn> kept;
    for (auto& [count, column] : columns) kept.push_back(std::move(column));
    std::ranges::sort(kept, {}, [](const MapColumn& one) { return std::tie(one.vertices, one.shape); });
    return kept;
}

/// Orders two scenes of one place: first the one nearer to the value of the place, then built-in scenes, then
/// the shorter name.
auto preference(const SceneRanking& scene, const MapPlace& place) {
    const ReportCell& cell = *scene.cells.front().cell;
    return std::make_tuple(distance_from_class(cell, place.coherence), !cell.scene_kind.empty(),
                           scene.label.size(), scene.label);
}

/// Returns the scenes of one column at their places.
std::map<MapPlace, MapCell> map_cells_of(const Answer& answer) {
    std::map<MapPlace, MapCell> cells;
    for (const SceneRanking* scene : answer.scenes()) {
        const auto place = place_of(*scene->cells.front().cell);
        if (!place) continue;
        MapCell& cell = cells[*place];
        if (cell.scene) ++cell.further_scenes;
        if (!cell.scene || preference(*scene, *place) < preference(*cell.scene, *place)) cell.scene = scene;
    }
    for (auto& [place, cell] : cells)
        if (!cell.winner())
            cell.why = fmt::format("no table type is known to be within an error of {}",
                                   limit_text(answer.question.error_limit));
    return cells;
}

/// The sweep's cells at their places.
using PlacedCells = std::multimap<MapPlace, const ReportCell*>;

PlacedCells placed_cells(const ReportData& data, BreakEvenMap& map) {
    PlacedCells placed;
    std::map<std::string, std::optional<MapPlace>> of_scenes;
    for (const ReportCell* cell : data.swept()) {
        const auto [scene, fresh] = of_scenes.try_emplace(scene_key(*cell));
        if (fresh) {
            scene->second = place_of(*cell);
            map.scenes_left_out += !scene->second;
        }
        if (scene->second) placed.emplace(*scene->second, cell);
    }
    return placed;
}

/// Says why a place has no result: the store's reason for one of its cells, else that it has no cell.
std::string why_nothing(const PlacedCells& placed, const MapPlace& place, const std::string& shape) {
    const auto [first, last] = placed.equal_range(place);
    for (auto at = first; at != last; ++at) {
        const ReportCell& cell = *at->second;
        if (cell.shape != shape) continue;
        return cell.reason.empty() ? "not timed in the same rounds as the baseline"
                                   : fmt::format("{}: {}", to_string(cell.status), cell.reason);
    }
    return "no scene of this store is of such bodies there";
}

void fill_map_panels(const PlacedCells& placed, BreakEvenMap& map) {
    std::vector<std::map<MapPlace, MapCell>> columns;
    for (const Answer& answer : map.answers) columns.push_back(map_cells_of(answer));
    std::set<MapPlace> places;  // of the map's bodies
    for (const auto& [place, cell] : placed)
        if (std::ranges::find(map.columns, cell->shape, &MapColumn::shape) != map.columns.end())
            places.insert(place);
    for (const MapPlace& place : places) {
        const std::string tables = tables_class_text(place.tables);
        if (map.panels.empty() || map.panels.back().tables != tables) map.panels.push_back({tables, {}});
        MapRow row{place.coherence.text(), {}};
        for (std::size_t i = 0; i < columns.size(); ++i) {
            MapCell& cell = row.cells.emplace_back(columns[i][place]);
            if (!cell.scene) cell.why = why_nothing(placed, place, map.columns[i].shape);
        }
        map.panels.back().rows.push_back(std::move(row));
    }
}

template <class Use>
void each_cell(const BreakEvenMap& map, const Use& use) {
    for (const MapPanel& panel : map.panels)
        for (const MapRow& row : panel.rows)
            for (std::size_t i = 0; i < row.cells.size(); ++i) use(row.cells[i], i);
}

}  // namespace

const RankedCell* MapCell::best_of_others() const {
    const auto other = std::ranges::find_if(scene->cells, [&](const RankedCell& one) {
        return one.meets_error() && one.cell->algorithm != winner()->cell->algorithm;
    });
    return other == scene->cells.end() ? nullptr : &*other;
}

std::vector<std::string> MapCell::tied_layouts() const {
    std::vector<std::string> names;
    for (const std::size_t i : scene->ties) {
        const std::string name = layout_name(scene->cells[i]);
        if (name != layout_name(*winner()) && std::ranges::find(names, name) == names.end())
            names.push_back(name);
    }
    return names;
}

std::string MapPanel::only_algorithm() const {
    std::set<std::string> algorithms;
    for (const MapRow& row : rows)
        for (const MapCell& cell : row.cells)
            if (cell.scene)
                for (const RankedCell& one : cell.scene->cells) algorithms.insert(one.cell->algorithm);
    return algorithms.size() == 1 ? algorithm_title(*algorithms.begin()) : std::string();
}

std::size_t BreakEvenMap::measured() const {
    std::size_t count = 0;
    each_cell(*this, [&](const MapCell& cell, std::size_t) { count += cell.scene != nullptr; });
    return count;
}

BreakEvenMap break_even_map(const ReportData& data, double error_limit) {
    BreakEvenMap map;
    map.error_limit = error_limit;
    map.columns = columns_of_data(data, map);
    for (const MapColumn& column : map.columns)
        map.answers.push_back(answer_of_scenes(data, {.error_limit = error_limit, .shape = column.shape}));
    fill_map_panels(placed_cells(data, map), map);
    return map;
}

std::string layout_name(const RankedCell& cell) {
    return fmt::format("{} on {}", algorithm_title(cell.cell->algorithm), cell.cell->layout);
}

namespace {

/// Returns the answer at a place, short enough to be compared with its neighbour.
std::string answer_at(const MapCell& cell) {
    if (!cell.winner()) return "nothing within the error";
    if (cell.scene->too_noisy()) return "too noisy to rank";
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
    if (cell.scene->too_noisy()) return {text + ", too noisy to rank"};
    return {cell.scene->ties.size() == 1 ? text : fmt::format("{}, {} tie", text, cell.scene->ties.size())};
}

}  // namespace

std::string break_even_sentence(const BreakEvenMap& map) {
    if (map.measured() == 0) return {};
    std::size_t won = 0, tied = 0, noisy = 0;
    std::map<std::string, std::size_t> winners;
    each_cell(map, [&](const MapCell& cell, std::size_t) {
        if (!cell.winner()) return;
        if (cell.scene->too_noisy())
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
        "Of {} that were measured, one algorithm and layout wins in {}{}; several tie in {}, and {} {} too "
        "noisy to rank.",
        plural(map.measured(), "place"), won, names.empty() ? "" : " (" + names + ")", tied, noisy,
        noisy == 1 ? "is" : "are");
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
    if (cell.scene->too_noisy()) text += "; too noisy to rank";
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
