// SPDX-License-Identifier: MIT
//
// One query's walk, step by step, as the sweep keeps it in the store: on both bodies the features that V-Clip
// visits, or the corners of GJK's simplex; next to them the cache lines that each step reads, for every table
// type that took these steps. The script of the page shows one step of these drawings at a time.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

struct HeatBody;

/// One path for what stays, and one for each step, with a caption.
struct WalkDrawing {
    std::string name;  ///< "Body A", or a table type
    std::string box;   ///< its view box
    std::string ground;
    std::vector<std::string> steps = {}, said = {};
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(WalkDrawing, name, box, ground, steps, said)

struct BodyWalk {
    std::string title;                ///< "V-Clip, tumble (rotation_step 1), sphere386, query 7"
    std::vector<std::string> said;    ///< what each step is
    std::vector<WalkDrawing> bodies;  ///< A, then B
    std::vector<WalkDrawing> tables;  ///< the baseline's first, the one with the fewest lines last
    std::size_t lines_of_last = 0;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BodyWalk, title, said, bodies, tables)

/// Adds the walk of a cell, `json` as the store has it: to the walk with the same steps, or as a new one.
/// Leaves out what does not fit the body.
void add_walk(const nlohmann::json& json, const ReportCell& cell, const HeatBody& body,
              std::vector<BodyWalk>& walks);

/// Returns the last step as a figure with its caption; `style`: "trail" for a body, "lines" for a table.
[[nodiscard]] std::string walk_figure(const WalkDrawing& drawing, const char* style);

}  // namespace edgewise::reports
