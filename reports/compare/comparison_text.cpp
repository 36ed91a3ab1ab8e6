// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "edgewise/reports/compare/comparison.hpp"

namespace edgewise::reports {

namespace {

constexpr std::size_t most_lines = 20;  ///< of one kind; the rest is counted

std::string exact_line(const ExactChange& change) {
    return fmt::format("  {:<34} {:>10.6g} -> {:<10.6g} {:<7} {}\n", change.figure, change.before,
                       change.after, change.before > 0 ? fmt::format("x {:.3f}", change.ratio()) : "new",
                       change.cell);
}

std::string time_line(const TimeChange& change, bool explain) {
    std::string line =
        fmt::format("  x {:.3f} [{:.3f}, {:.3f}]  {}\n", change.mid, change.low, change.high, change.cell);
    if (!explain) return line;
    if (change.by_cost == 0)
        return line + "      what it is made of is not known: no steps or lines in one of the stores\n";
    return line +
           fmt::format("      = {:.3f} (steps) x {:.3f} (lines per step) x {:.3f} (time per line){}\n",
                       change.by_steps, change.by_lines, change.by_cost,
                       change.exact_same ? "; no exact figure of the cell changed: code or machine" : "");
}

template <class Change, class Wanted, class Line>
std::string section(const char* title, const std::vector<Change>& changes, const Wanted& wanted,
                    const Line& line) {
    std::string text;
    std::size_t count = 0;
    for (const Change& change : changes) {
        if (!wanted(change)) continue;
        if (count++ < most_lines) text += line(change);
    }
    if (count == 0) return {};
    if (count > most_lines) text += fmt::format("  and {} more (--json)\n", count - most_lines);
    return fmt::format("{}: {}\n{}", title, count, text);
}

std::string conditions_text(const Comparison& comparison) {
    std::string same, differ;
    for (const Condition& condition : comparison.conditions) {
        if (condition.same()) {
            same += (same.empty() ? "" : ", ") + condition.what;
        } else {
            differ += fmt::format("  {}: {} -> {}\n", condition.what, condition.before, condition.after);
        }
    }
    std::string text =
        "excluded as causes, since they are the same: " + (same.empty() ? "nothing" : same) + "\n";
    return text + (differ.empty() ? "" : "possible causes:\n" + differ);
}

}  // namespace

std::string comparison_text(const Comparison& comparison, double slack, bool explain) {
    const auto slower = [&](const TimeChange& change) { return comparison.is_slower(change, slack); };
    const auto faster = [&](const TimeChange& change) { return comparison.is_faster(change, slack); };
    const auto time = [&](const TimeChange& change) { return time_line(change, explain); };
    const auto worse = [](const ExactChange& change) { return change.is_worse(); };
    const auto better = [](const ExactChange& change) { return !change.is_worse(); };
    std::string text = fmt::format(
        "{} cells are in both stores, {} only before, {} only after; {} exact figures compared, {} changed\n"
        "times are divided by the baseline's of the same run; that one beside itself: {:.2f} to {:.2f}\n\n",
        comparison.paired, comparison.only_before, comparison.only_after, comparison.figures,
        comparison.exact.size(), comparison.noise_low, comparison.noise_high);
    text += section("worse, exactly", comparison.exact, worse, exact_line);
    text += section("slower", comparison.times, slower, time);
    text += section("better, exactly", comparison.exact, better, exact_line);
    text += section("faster", comparison.times, faster, time);
    if (comparison.regressions(slack) == 0) text += "no regression\n";
    return explain ? text + "\n" + conditions_text(comparison) : text;
}

nlohmann::json comparison_json(const Comparison& comparison, double slack) {
    nlohmann::json json = {{"paired", comparison.paired},
                           {"only_before", comparison.only_before},
                           {"only_after", comparison.only_after},
                           {"figures", comparison.figures},
                           {"noise", {comparison.noise_low, comparison.noise_high}},
                           {"slack", slack},
                           {"regressions", comparison.regressions(slack)},
                           {"exact", nlohmann::json::array()},
                           {"times", nlohmann::json::array()},
                           {"conditions", nlohmann::json::array()}};
    for (const ExactChange& change : comparison.exact)
        json["exact"].push_back({{"cell", change.cell},
                                 {"figure", change.figure},
                                 {"unit", change.unit},
                                 {"before", change.before},
                                 {"after", change.after},
                                 {"worse", change.is_worse()}});
    for (const TimeChange& change : comparison.times)
        json["times"].push_back({{"cell", change.cell},
                                 {"ratio", {change.low, change.mid, change.high}},
                                 {"by_steps", change.by_steps},
                                 {"by_lines_per_step", change.by_lines},
                                 {"by_time_per_line", change.by_cost},
                                 {"slower", comparison.is_slower(change, slack)},
                                 {"faster", comparison.is_faster(change, slack)}});
    for (const Condition& condition : comparison.conditions)
        json["conditions"].push_back({{"what", condition.what},
                                      {"before", condition.before},
                                      {"after", condition.after},
                                      {"same", condition.same()}});
    return json;
}

}  // namespace edgewise::reports
