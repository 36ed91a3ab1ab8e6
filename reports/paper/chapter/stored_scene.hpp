// SPDX-License-Identifier: MIT
//
// Scenes that are files: what each varies, its cells, and their numbers. The store holds a scene's text as
// JSON under its name, and its numbers in every cell's scene parameters.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

struct StoredScene {
    std::string name;    ///< "paper_angular_8"
    std::string varied;  ///< the number that it varies; empty: its cells differ in their shapes
    std::string note;    ///< what its author says of it
    std::vector<const ReportCell*> cells;

    /// Returns a cell's place on an axis: the varied number, else the vertices.
    [[nodiscard]] std::optional<double> place(const ReportCell& cell) const;
    [[nodiscard]] std::string axis_title() const;  ///< in words
};

/// All of them, by name; a text that is no JSON gives a scene that varies nothing.
[[nodiscard]] std::vector<StoredScene> scene_files(const ReportData& data);
/// One by its name; without cells when the store has none.
[[nodiscard]] StoredScene scene_file(const ReportData& data, const std::string& name);
/// The scenes that follow the paper, all that come along (reports/paper/scenes); a user's file has another
/// name.
inline constexpr std::string_view paper_scenes[] = {
    "paper_static",        "paper_linear_8",   "paper_bodies",      "paper_bodies_shrinking",
    "paper_angular_8",     "paper_angular_38", "paper_angular_386", "paper_proximity",
    "paper_complexity",    "paper_caching",    "paper_cold",        "paper_needs",
    "paper_thrash_8",      "paper_thrash_38",  "paper_thrash_386",  "paper_caches_here",
    "paper_seeds",         "paper_time_step",  "paper_body_count",  "paper_margin",
    "paper_static_margin", "paper_static_gap", "paper_tolerance"};
[[nodiscard]] bool is_of_paper(const std::string& scene);

/// A new random orientation each step: coherence's other end.
[[nodiscard]] inline bool has_random_orientation(const ReportCell& cell) {
    return parameter_of(cell, "random_orientation").value_or(0) != 0;
}
/// Returns the verified cell of this algorithm and table type that is nearest to a wanted place; null if
/// there is none.
[[nodiscard]] const ReportCell* nearest_cell(const StoredScene& scene, const std::string& algorithm,
                                             const std::string& table, double wanted);

}  // namespace edgewise::reports
