// SPDX-License-Identifier: MIT
//
// What the store knows of the thrash at 386 vertices: V-Clip on the paper's record (aos_f64), tables of its
// own for every body, against the caches and memories of 2001. The rules that make a cause of it are here.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "edgewise/measure/expected.hpp"
#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

/// Cells of paper_thrash_N by angle per step, rising: one algorithm on one table type.
[[nodiscard]] std::vector<std::pair<double, const ReportCell*>> thrash_cells(const ReportData& data,
                                                                             int vertices,
                                                                             const std::string& algorithm,
                                                                             const std::string& table);
/// V-Clip on aos_f64: a figure at the slowest or the fastest rotation.
[[nodiscard]] measure::Expected<double> thrash_figure(const ReportData& data, int vertices, bool fastest,
                                                      const store::FigureName& name);
/// Likewise a number of the scene: "rotation_step", "bodies".
[[nodiscard]] measure::Expected<double> thrash_number(const ReportData& data, int vertices, bool fastest,
                                                      const std::string& name);
/// The larger of a figure at the slowest and at the fastest rotation.
[[nodiscard]] measure::Expected<double> worst_figure(const ReportData& data, int vertices,
                                                     const store::FigureName& name);
/// How many bodies it takes, in proportion, until the worst knee passes `bytes`.
[[nodiscard]] measure::Expected<double> bodies_to_fill(const ReportData& data, int vertices,
                                                       const store::FigureName& knee, double bytes);
/// Modelled memory time at 386 vertices over that at 38; infinite where 38 vertices never wait.
[[nodiscard]] measure::Expected<double> memory_factor(const ReportData& data, const std::string& machine,
                                                      bool fastest);

/// Whether the cache makes figure 8: on some machine, at some speed, the modelled memory time grows by the
/// paper's factor from 38 to 386 vertices, and is no less than a tenth of what the paper's axis grows by.
/// Null when nothing was modelled.
[[nodiscard]] std::optional<bool> cache_is_a_cause(const ReportData& data);
/// Whether paging does: hundreds of bodies of 386 vertices use more pages than the smallest memory of
/// the time holds, and those of 38 do not; or with that memory and more they were measured to fault often
/// enough. Null when neither reuse distances of pages nor such a measurement are stored.
[[nodiscard]] std::optional<bool> paging_is_a_cause(const ReportData& data);

}  // namespace edgewise::reports
