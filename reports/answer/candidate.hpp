// SPDX-License-Identifier: MIT
//
// One way to answer a scene's queries, an algorithm on a table type, with the figures by which it is chosen.
#pragma once

#include <optional>
#include <string>

#include "edgewise/reports/reader.hpp"
#include "edgewise/reports/tables/ratio_interval.hpp"

namespace edgewise::reports {

struct Candidate {
    const ReportCell* cell = nullptr;
    std::string table;  ///< the table type, without axes
    double ns = 0;      ///< per query of both kinds of pairs as they come, median over the rounds
    double ratio = 0;   ///< to the baseline timed in the same rounds, median
    std::optional<RatioInterval> interval;  ///< of that median over the rounds of one process, no more
    std::optional<double> worst_error;      ///< against the bodies as given, over the scale of the pair
    std::optional<double> bytes_per_edge, table_bytes, scene_bytes;  ///< of one table; of all of the scene
    std::optional<double> tables, lines_per_query, steps;
    bool meets_error = false;  ///< never where the error was not measured

    [[nodiscard]] double low() const { return interval ? interval->low : ratio; }
    [[nodiscard]] double high() const { return interval ? interval->high : ratio; }
    /// "V-Clip on aos_f64"; of another library its name.
    [[nodiscard]] std::string name() const;
};

/// Null where the cell was not timed beside the baseline.
[[nodiscard]] std::optional<Candidate> candidate_of(const ReportCell& cell, double error_limit);

/// "V-Clip" | "GJK"; other names as they are.
[[nodiscard]] std::string algorithm_title(const std::string& algorithm);

}  // namespace edgewise::reports
