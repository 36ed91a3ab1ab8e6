// SPDX-License-Identifier: MIT
#include "edgewise/reports/compare/comparison_grids.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <functional>

#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

template <class Wanted>
TextGrid exact_grid(const char* title, const Comparison& comparison, const Wanted& wanted) {
    TextGrid grid{title, columns_of("figure|#before|#after|#after / before|unit|cell"), {}};
    for (const ExactChange& change : comparison.exact)
        if (wanted(change))
            grid.rows.push_back(grid_row(
                change.figure, fmt::format("{:.6g}", change.before), fmt::format("{:.6g}", change.after),
                change.before > 0 ? fmt::format("{:.3f}", change.ratio()) : "new", change.unit, change.cell));
    return grid;
}

/// A factor of a change of time, or that it is not known.
GridCell factor_cell(double factor) {
    if (factor == 0) return missing_cell("no steps or lines in one of the stores");
    return {fmt::format("{:.3f}", factor)};
}

template <class Wanted>
TextGrid time_change_grid(const char* title, const Comparison& comparison, const Wanted& wanted) {
    TextGrid grid{title,
                  columns_of("#after / before|#interval|#= steps|#x lines per step|#x time per line|"
                             "exact figures|cell"),
                  {}};
    for (const TimeChange& change : comparison.times)
        if (wanted(change))
            grid.rows.push_back(grid_row(
                fmt::format("{:.3f}", change.mid), fmt::format("{:.3f} to {:.3f}", change.low, change.high),
                factor_cell(change.by_steps), factor_cell(change.by_lines), factor_cell(change.by_cost),
                change.exact_same ? "the same: code or machine" : "changed", change.cell));
    return grid;
}

template <class Changes, class Wanted>
std::size_t how_many(const Changes& changes, const Wanted& wanted) {
    return static_cast<std::size_t>(std::ranges::count_if(changes, wanted));
}

}  // namespace

std::string comparison_sentence(const Comparison& comparison, double slack) {
    const auto slower = [&](const TimeChange& change) { return comparison.is_slower(change, slack); };
    const auto faster = [&](const TimeChange& change) { return comparison.is_faster(change, slack); };
    const std::size_t worse = how_many(comparison.exact, std::mem_fn(&ExactChange::is_worse));
    return fmt::format(
        "{} and {} became worse, {} and {} better, of {} in both stores; {} only before, {} only after.",
        plural(worse, "exact figure"), plural(how_many(comparison.times, slower), "time"),
        comparison.exact.size() - worse, how_many(comparison.times, faster),
        plural(comparison.paired, "cell"), comparison.only_before, comparison.only_after);
}

std::vector<TextGrid> change_grids(const Comparison& comparison, double slack) {
    std::vector<TextGrid> grids = {
        exact_grid("Worse, exactly", comparison, std::mem_fn(&ExactChange::is_worse)),
        time_change_grid("Slower", comparison,
                         [&](const TimeChange& change) { return comparison.is_slower(change, slack); }),
        exact_grid("Better, exactly", comparison,
                   [](const ExactChange& change) { return !change.is_worse(); }),
        time_change_grid("Faster", comparison,
                         [&](const TimeChange& change) { return comparison.is_faster(change, slack); })};
    // Times are kept the slowest change first: of the faster ones the fastest is wanted first.
    std::ranges::reverse(grids.back().rows);
    std::erase_if(grids, [](const TextGrid& grid) { return grid.rows.empty(); });
    return grids;
}

TextGrid conditions_grid(const Comparison& comparison) {
    TextGrid grid{"What else differs, and may be the cause", columns_of("what|before|after|as a cause"), {}};
    for (const Condition& condition : comparison.conditions)
        grid.rows.push_back(grid_row(condition.what, condition.before, condition.after,
                                     condition.same() ? "excluded" : "possible"));
    grid.shown_rows = grid.rows.size();
    return grid;
}

}  // namespace edgewise::reports
