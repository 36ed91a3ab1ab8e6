// SPDX-License-Identifier: MIT
//
// Which algorithm and layout is fastest within the error, by vertices, coherence and number of tables: the
// ranked scenes of all bodies of a store, each put in its place. A place without measurements says so in its
// text. Also gives the map in words: how many places each layout wins, and where the winner changes from one
// body to a larger body.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "edgewise/reports/answer/answer.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

struct MapCell {
    const SceneRanking* scene = nullptr;  ///< the scene shown here; null: none
    std::size_t further_scenes = 0;       ///< number of other scenes of the same place, which are not shown
    std::string why = {};                 ///< reason, of a place without a winner

    [[nodiscard]] const RankedCell* winner() const { return scene ? scene->winner() : nullptr; }
    /// Returns the fastest cell of another algorithm within the error; null if there is none.
    [[nodiscard]] const RankedCell* best_of_others() const;
    /// Returns algorithms and layouts that tie with the winner's; another precision of it does not count.
    [[nodiscard]] std::vector<std::string> tied_layouts() const;
    /// Returns true if one algorithm and layout is ahead of all others.
    [[nodiscard]] bool is_won() const { return winner() && tied_layouts().empty() && !scene->too_noisy(); }
};

struct MapColumn {
    std::string shape;
    std::int64_t vertices = 0;
};

struct MapRow {
    std::string coherence;
    std::vector<MapCell> cells;  ///< one for each column
};

struct MapPanel {
    std::string tables;        ///< "one shared table", "100 to 999 tables"
    std::vector<MapRow> rows;  ///< the most coherent first

    /// Returns "V-Clip" if no other algorithm was timed in any of its cells; else empty.
    [[nodiscard]] std::string only_algorithm() const;
};

struct BreakEvenMap {
    BreakEvenMap() = default;
    BreakEvenMap(BreakEvenMap&&) = default;  ///< and no copy: cells point into the answers

    double error_limit = 0;
    std::vector<Answer> answers;     ///< one for each column
    std::vector<MapColumn> columns;  ///< fewest vertices first
    std::vector<MapPanel> panels;    ///< fewest tables first
    /// Number of bodies beyond the limit, of bodies without timed cells, and of scenes that have no place.
    std::size_t columns_left_out = 0, bodies_not_timed = 0, scenes_left_out = 0;

    [[nodiscard]] std::size_t measured() const;  ///< cells with a scene
};

/// The largest number of bodies in a map; the bodies with most scenes stay.
inline constexpr std::size_t most_map_columns = 12;

/// Returns the map for one error limit. The data must outlive the map.
[[nodiscard]] BreakEvenMap break_even_map(const ReportData& data, double error_limit);

/// Returns "V-Clip on lean": without the precision, which rarely decides.
[[nodiscard]] std::string layout_name(const RankedCell& cell);

/// Says how many places were measured, how many have a single winner, and how often each layout wins; empty
/// if nothing was measured.
[[nodiscard]] std::string break_even_sentence(const BreakEvenMap& map);

/// Returns a line for each row of the map with two or more sizes of bodies: which cell wins at which sizes.
[[nodiscard]] std::vector<std::string> break_even_lines(const BreakEvenMap& map);

/// Returns the tie set of the place's scene with notes, or the reason why there is no result.
[[nodiscard]] std::string cell_text(const MapCell& cell);

/// Returns a row per coherence and number of tables and a column per body, at most `most_columns`, the ones
/// with most measured cells; places that were not measured have a reason.
[[nodiscard]] TextGrid break_even_grid(const BreakEvenMap& map, std::size_t most_columns = most_map_columns);

}  // namespace edgewise::reports
