// SPDX-License-Identifier: MIT
//
// Two stores, cell by cell: figures that are the same in every run are compared exactly, times by their ratio
// to the baseline of their own run, with intervals. Cells are paired by scene, parameters, shape, algorithm,
// table type and axes; what else the stores differ in is said beside them, since it may be the cause.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

/// A figure that a run repeats to the bit.
struct ExactChange {
    std::string cell, figure, unit;
    double before = 0, after = 0;

    [[nodiscard]] bool is_worse() const { return after > before; }  ///< every one of them is a cost
    [[nodiscard]] double ratio() const { return before > 0 ? after / before : 0; }
};

/// Time over the baseline's, after over before.
struct TimeChange {
    std::string cell;
    double low = 0, mid = 0, high = 0;  ///< the widest that both intervals allow
    /// Of the change: by steps, by lines per step, by time per line; their product is mid. Zero where
    /// unknown.
    double by_steps = 0, by_lines = 0, by_cost = 0;
    bool exact_same = false;  ///< the cell's exact figures did not change at all
};

/// What may have caused a difference, or is excluded as a cause.
struct Condition {
    std::string what, before, after;
    [[nodiscard]] bool same() const { return before == after; }
};

struct Comparison {
    std::vector<Condition> conditions;
    std::vector<ExactChange> exact;  ///< those that changed: what became worse first, by how much
    std::vector<TimeChange> times;   ///< all: the slowest change first
    std::size_t paired = 0, only_before = 0, only_after = 0;  ///< cells
    std::size_t figures = 0;                                  ///< exact ones that were compared
    double noise_low = 1, noise_high = 1;  ///< the baseline's own cells beside itself, in both stores

    /// Its whole interval lies beyond the slack, and beyond what the baseline differs by from itself.
    [[nodiscard]] bool is_slower(const TimeChange& change, double slack) const;
    [[nodiscard]] bool is_faster(const TimeChange& change, double slack) const;
    [[nodiscard]] std::size_t regressions(double slack) const;  ///< of both kinds
};

[[nodiscard]] Comparison compare(const ReportData& before, const ReportData& after);

/// For people: regressions first. `explain`: what each change of time is made of, and which causes are
/// excluded.
[[nodiscard]] std::string comparison_text(const Comparison& comparison, double slack, bool explain);
[[nodiscard]] nlohmann::json comparison_json(const Comparison& comparison, double slack);

}  // namespace edgewise::reports
