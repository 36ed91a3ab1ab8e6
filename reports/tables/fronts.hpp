// SPDX-License-Identifier: MIT
//
// Times next to errors, panel by panel: the cells of one scene and shape that answer the same question, ours
// and other libraries', and which of them are on the Pareto front of time and error: those that nothing beats
// in both. A point is dominated by one that is no worse in either and better in one, so equal points are on
// the front together or not at all. Table and chart show the same.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

/// Smaller is better in both; infinity is a number, NaN none.
struct SpeedError {
    double ns, error;
};

/// Returns true for each point that no point dominates. A point with a NaN is on no front and dominates none.
[[nodiscard]] std::vector<bool> pareto_front(std::span<const SpeedError> points);

/// One way to sum up a cell's errors.
struct ErrorKind {
    std::string_view id, title;
    store::FigureName figure;
};
inline constexpr ErrorKind error_kinds[] = {{"p50", "p50", "error.p50_error_given"},
                                            {"p999", "p99.9", "error.p999_error_given"},
                                            {"worst", "worst", "error.worst_error_given"}};
inline constexpr std::size_t error_kind_count = std::size(error_kinds);

struct FrontPoint {
    const ReportCell* cell;
    double ns;                                                   ///< per query, separated pairs; above 0
    std::array<std::optional<double>, error_kind_count> errors;  ///< over the scale of the pair; one at least
    std::array<bool, error_kind_count> on_front;                 ///< of this time and that error

    [[nodiscard]] bool on_any_front() const;
};

struct FrontPanel {
    std::string scene_label, shape;
    std::int64_t vertices;
    std::vector<FrontPoint> points;  ///< fastest first

    [[nodiscard]] bool has_peers() const;
};

struct Fronts {
    std::vector<FrontPanel> panels;  ///< by scene as in scene_labels, then vertices and shape
    std::vector<std::pair<const ReportCell*, std::string>>
        left_out;  ///< timed cells without a place, and why
};

/// Returns the fronts over all timed cells. The data must outlive the result.
[[nodiscard]] Fronts fronts_of(const ReportData& data);

/// The value of `gap_tolerance` among a cell's axes, as text; empty where there is none.
[[nodiscard]] std::string gap_tolerance_of(const ReportCell& cell);

}  // namespace edgewise::reports
