// SPDX-License-Identifier: MIT
#include "edgewise/reports/answer/decision.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "edgewise/reports/answer/answer_text.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/reports/text/report_text.hpp"

namespace edgewise::reports {

namespace {

/// Returns the geometric mean over the scenes: of the ratios, and of each end of their intervals.
RatioRange mean_ratio(const Recommendation& take) {
    double low = 0, ratio = 0, high = 0, scenes = 0;
    for (const Recommendation::InScene& one : take.scenes) {
        if (!one.cell) continue;
        low += std::log(one.cell->low()), ratio += std::log(one.cell->ratio);
        high += std::log(one.cell->high()), ++scenes;
    }
    return {std::exp(low / scenes), std::exp(ratio / scenes), std::exp(high / scenes)};
}

/// "0.72 [0.69, 0.83] of the time of the paper's layout, 0.52 to 0.91 by scene"
std::string time_fact(const Recommendation& take) {
    const RatioRange mean = mean_ratio(take);
    std::string text = fmt::format("{:.2f} [{:.2f}, {:.2f}] of the time of the paper's layout", mean.ratio,
                                   mean.low, mean.high);
    double least = mean.ratio, most = mean.ratio;
    for (const Recommendation::InScene& one : take.scenes)
        if (one.cell) least = std::min(least, one.cell->ratio), most = std::max(most, one.cell->ratio);
    if (take.scenes.size() > 1) text += fmt::format(", {:.2f} to {:.2f} by scene", least, most);
    return text;
}

/// Compares the cell with the winner of each scene near contact, and names the largest difference.
std::string near_contact_fact(const Recommendation& take, const std::vector<SceneRanking>& scenes,
                              bool& changes_it) {
    const RankedCell *here = nullptr, *winner = nullptr;
    std::size_t asked = 0;
    for (const SceneRanking& scene : scenes) {
        const RankedCell* const cell = scene.find(take.algorithm, take.table);
        if (!cell || !scene.winner() || !scene.recommends() || scene.too_noisy) continue;
        if (!cell->meets_error()) return changes_it = true, "near contact: " + cell->dropped;
        ++asked;
        if (scene.ties_with_winner(*cell)) continue;
        if (!here || cell->ratio / scene.winner()->ratio > here->ratio / winner->ratio)
            here = cell, winner = scene.winner();
    }
    changes_it = here != nullptr;
    if (asked == 0) return scenes.empty() ? "near contact: not measured" : "near contact: too noisy to say";
    if (!here) return "near contact: the same";
    return fmt::format("near contact: {} takes {:.2f}, this {:.2f}", winner->name(), winner->ratio,
                       here->ratio);
}

/// Says why the scenes of a body recommend nothing, and how to measure what is missing.
std::vector<std::string> why_nothing_is_taken(const std::vector<SceneRanking>& scenes,
                                              const std::string& command) {
    std::string why;
    for (const SceneRanking& scene : scenes)
        if (scene.winner() && !scene.recommends())
            append(why, fmt::format("{}: {}", scene.label, scene.why_not()), "; ");
    if (scenes.empty()) return {"not measured; measure it with: " + command};
    if (why.empty()) return {"nothing is within the error"};
    return {fmt::format("too few cells ({}); measure more with: {}", why, command), contest_rule()};
}

std::string bytes_fact(const RankedCell& cell) {
    return fmt::format("{} per table, {} bytes per edge",
                       cell.table_bytes ? size_text(*cell.table_bytes) : "bytes not measured",
                       cell.bytes_per_edge ? number_text(*cell.bytes_per_edge, "B/edge") : "?");
}

}  // namespace

Decision decision_of(const Answer& answer, bool own_tables) {
    const std::vector<SceneRanking>& scenes = own_tables ? answer.own : answer.shared;
    const std::optional<Recommendation> take = recommendation_of(scenes);
    if (!take) return {{}, why_nothing_is_taken(scenes, measuring_command(answer, own_tables))};
    if (take->scenes.front().scene->too_noisy)
        return {{}, {"too noisy to choose by: the winner's interval spans more than a factor of 2"}};
    const RankedCell& cell = take->example();
    Decision decision{cell.name(), {time_fact(*take), bytes_fact(cell)}};
    if (!take->beats_baseline_somewhere()) decision.facts.front() += "; nothing beats the paper's layout";
    const auto near_error = worst_error_of(answer.near, take->algorithm, take->table);
    if (const double error = std::max(take->worst_error.value_or(0), near_error.value_or(0)); error > 0)
        decision.facts.push_back("worst error " + number_text(error, "scale"));
    decision.facts.push_back(near_contact_fact(*take, answer.near, decision.near_contact_changes_it));
    return decision;
}

std::string Decision::text() const {
    return fmt::format("{}{}", take.empty() ? "nothing is recommended: " : "take " + take + ": ",
                       fmt::join(facts, "; "));
}

namespace {

using DecisionColumn = Decision DecisionRow::*;
constexpr DecisionColumn decision_columns[] = {&DecisionRow::shared, &DecisionRow::own};

std::vector<DecisionRow> decision_rows(const ReportData& data, Question question) {
    std::vector<DecisionRow> rows;
    const std::optional<std::string> asked = question.shape;
    for (const auto& [vertices, shape] : shapes_by_vertices(data)) {
        if (asked.value_or(shape) != shape) continue;
        question.shape = shape;
        const Answer answer = answer_of_scenes(data, question);
        if (answer.shared.empty() && answer.own.empty()) continue;
        rows.push_back({shape, vertices, decision_of(answer, false), decision_of(answer, true)});
    }
    return rows;
}

/// Returns "take V-Clip on lean_f32 for most bodies": what most rows of a column take; empty if none does.
std::string taken_by_most(const std::vector<DecisionRow>& rows, DecisionColumn column) {
    std::map<std::string, std::size_t> counts;
    std::size_t all = 0;
    for (const DecisionRow& row : rows)
        if (!(row.*column).take.empty()) ++all, ++counts[(row.*column).take];
    if (all == 0) return {};
    const auto most = std::ranges::max_element(counts, {}, [](const auto& one) { return one.second; });
    if (2 * most->second <= all) return "the layout to take depends on the body";
    return fmt::format("take {}{}", most->first, most->second == all ? "" : " for most bodies");
}

std::string decision_sentence(const std::vector<DecisionRow>& rows) {
    std::string text;
    for (const DecisionColumn column : decision_columns)
        if (const std::string taken = taken_by_most(rows, column); !taken.empty())
            append(text,
                   (column == &DecisionRow::own ? "If every body has a table of its own, "
                                                : "If your bodies share a table, ") +
                       taken + ".",
                   " ");
    if (text.empty()) return "Nothing is recommended; the table says why.";
    std::size_t changed = 0, all = 0;
    for (const DecisionRow& row : rows)
        for (const DecisionColumn column : decision_columns)
            changed += (row.*column).near_contact_changes_it, all += !(row.*column).take.empty();
    if (changed > 0) text += fmt::format(" Near contact changes {} of {}.", changed, plural(all, "answer"));
    return text;
}

/// Says how many decisions differ at another limit; empty if none does.
std::string change_by_limit(double limit, const std::vector<DecisionRow>& then,
                            const std::vector<DecisionRow>& now) {
    std::size_t changed = 0, all = 0;
    std::string example;
    for (std::size_t i = 0; i < now.size(); ++i) {
        for (const DecisionColumn column : decision_columns) {
            const std::string &before = (now[i].*column).take, &after = (then[i].*column).take;
            all += !before.empty();
            if (before == after || before.empty() || changed++ > 0) continue;
            example = fmt::format("{}, {}: {}", now[i].shape,
                                  column == &DecisionRow::own ? "a table each" : "shared table",
                                  after.empty() ? "nothing" : after);
        }
    }
    if (changed == 0) return {};
    return fmt::format("An error of at most {} changes {} of {} ({})", limit_text(limit), changed,
                       plural(all, "answer"), example);
}

}  // namespace

std::string DecisionTable::text(const Question& question) const {
    std::string text = sentence;
    for (const DecisionRow& row : rows)
        for (const DecisionColumn column : decision_columns)
            if (const bool own = column == &DecisionRow::own; question.own_tables.value_or(own) == own)
                text += fmt::format("\n  {} ({} vertices), {}: {}", row.shape, row.vertices,
                                    own ? "a table each" : "shared table", (row.*column).text());
    return text;
}

Decisions::Decisions(const ReportData& data, const Question& question) {
    std::vector<double> limits(std::begin(offered_limits), std::end(offered_limits));
    limits.push_back(question.error_limit);
    for (const double limit : limits)
        if (!by_limit_.contains(limit))
            by_limit_[limit] = decision_rows(
                data, {.error_limit = limit, .shape = question.shape, .own_tables = question.own_tables});
    if (data.build.flags.find("-march=") != std::string::npos)
        not_measured_.emplace_back(
            "Default compiler flags: not measured, the program was compiled with -march");
    if (data.meta_value("plan") == "quick") not_measured_.push_back(prose("not_in_contest.md"));
}

DecisionTable Decisions::table(double error_limit, const std::string& shape) const {
    std::map<double, std::vector<DecisionRow>> shown = by_limit_;
    for (auto& [limit, rows] : shown)
        std::erase_if(rows, [&](const DecisionRow& row) { return !shape.empty() && row.shape != shape; });
    const std::vector<DecisionRow>& now = shown.at(error_limit);
    if (now.empty())
        return {
            {},
            "No cell of this store answers the question.",
            {"An answer needs cells with known errors that were timed in the same rounds as the baseline"}};
    DecisionTable table{now, decision_sentence(now), {}};
    for (const auto& [limit, rows] : shown)
        if (const std::string change = change_by_limit(limit, rows, now); !change.empty())
            table.changes.push_back(change);
    table.changes.insert(table.changes.end(), not_measured_.begin(), not_measured_.end());
    return table;
}

}  // namespace edgewise::reports
