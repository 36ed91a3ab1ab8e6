// SPDX-License-Identifier: MIT
//
// The chapter on caches as grids: misses of modelled machines and why, working sets and knees, heat, and
// whether the replacement policy changes the ranking of the tables.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/reader.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

/// Cells whose caches were modelled, fewest misses of the first machine first; by scene.
[[nodiscard]] std::vector<const ReportCell*> modelled_cells(const ReportData& data);
/// Machines with figures, in order of name; not those under another policy.
[[nodiscard]] std::vector<std::string> modelled_machines(const ReportData& data);

/// Misses per query in each level of a machine, and the modelled memory time; an empty name: of all machines.
[[nodiscard]] TextGrid misses_grid(const ReportData& data, const std::string& machine = {});
/// Of one machine: each level's misses by cause, cold and warm.
[[nodiscard]] TextGrid causes_grid(const ReportData& data, const std::string& machine);
/// The levels of a machine whose misses are told by field and step.
[[nodiscard]] std::vector<std::string> broken_down_levels(const ReportData& data, const std::string& machine);
inline constexpr store::FigureName misses_by_field("caches.{machine}.{level}.field.{field}"),
    misses_by_step("caches.{machine}.{level}.step.{step}");
/// Of one level: misses by what was read or by what read it.
[[nodiscard]] TextGrid breakdown_grid(const ReportData& data, const std::string& machine,
                                      const std::string& level, const store::FigureName& by);
/// Lines and pages: of a query, a frame, a body and the scene; knees; parts touched.
[[nodiscard]] TextGrid working_sets_grid(const ReportData& data);

/// One line per scene, algorithm and level: whether tree-PLRU or random replacement ranks the tables
/// otherwise.
[[nodiscard]] TextGrid policy_grid(const ReportData& data);
/// Its sums.
struct PolicyCounts {
    std::size_t pairs = 0, changed = 0;
};
[[nodiscard]] PolicyCounts policy_counts(const ReportData& data);

}  // namespace edgewise::reports
