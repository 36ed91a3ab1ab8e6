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

/// "0.72 [0.69, 0.83] of the time of the paper's layout, 0.52 to 0.91 by scene": the geometric mean over the
/// scenes, of the ratios and of each end of their intervals, if each scene has one.
std::string time_fact(const Recommendation& take) {
    double low = 0, ratio = 0, high = 0, scenes = 0, intervals = 0;
    for (const Recommendation::InScene& one : take.scenes) {
        if (!one.cell) continue;
        low += std::log(one.cell->low()), ratio += std::log(one.cell->ratio);
        high += std::log(one.cell->high()), ++scenes;
        intervals += one.cell->interval.has_value();
    }
    const double mean = std::exp(ratio / scenes);
    std::string text = fmt::format("{:.2f}", mean);
    if (intervals == scenes)
        text += fmt::format(" [{:.2f}, {:.2f}]", std::exp(low / scenes), std::exp(high / scenes));
    text += " of the time of the paper's layout";
    double least = mean, most = mean;
    for (const Recommendation::InScene& one : take.scenes)
        if (one.cell) least = std::min(least, one.cell->ratio), most = std::max(most, one.cell->ratio);
    if (take.scenes.size() > 1) text += fmt::format(", {:.2f} to {:.2f} by scene", least, most);
    return text;
}

/// How the cell to take compares with the fastest under a condition that has no vote: near contact, default
/// compiler flags.
class Condition {
  public:
    Condition(const char* name, const Recommendation& take) : name_(name), take_(take) {}

    /// Compares them in one scene, whose cells are given fastest first.
    void compare(const std::vector<RankedCell>& cells, const SceneRanking& scene) {
        const auto winner = std::ranges::find_if(cells, &RankedCell::meets_error);
        const auto here = std::ranges::find_if(cells, [&](const RankedCell& one) {
            return one.cell->algorithm == take_.algorithm && one.table == take_.table;
        });
        if (here == cells.end() || winner == cells.end() || !scene.recommends()) return;
        is_noisy_ = is_noisy_ || scene.too_noisy();
        if (scene.too_noisy()) return;
        ++compared_;
        if (!here->meets_error()) dropped_ = here->dropped;
        if (ties(here->range(), winner->range(), scene.own_variation)) return;
        if (!here_ || here->ratio / winner->ratio > here_->ratio / winner_->ratio)
            here_ = &*here, winner_ = &*winner;
    }

    [[nodiscard]] bool changes_it() const { return here_ || !dropped_.empty(); }
    /// Names the largest difference: "near contact: GJK on lean_f64 takes 0.59, this 1.00".
    [[nodiscard]] std::string fact() const {
        if (!dropped_.empty()) return name_ + ": " + dropped_;
        if (here_)
            return fmt::format("{}: {} takes {:.2f}, this {:.2f}", name_, winner_->name(), winner_->ratio,
                               here_->ratio);
        return name_ + (compared_ > 0 ? ": the same" : is_noisy_ ? ": too noisy to say" : ": not measured");
    }

  private:
    std::string name_;
    const Recommendation& take_;
    const RankedCell *here_ = nullptr, *winner_ = nullptr;
    std::size_t compared_ = 0;
    bool is_noisy_ = false;
    std::string dropped_;
};

/// Says why the scenes of a body recommend nothing, and how to measure what is missing.
std::vector<std::string> why_nothing_is_taken(const std::vector<SceneRanking>& scenes,
                                              const std::string& command) {
    std::string why;
    for (const SceneRanking& scene : scenes)
        if (scene.winner() && !scene.recommends())
            append(why, fmt::format("{}: {}", scene.label, scene.why_not()), "; ");
    if (scenes.empty()) return {"not measured; measure it with: " + command};
    if (why.empty()) return {"nothing is known to be within the error"};
    return {
        fmt::format("too few cells ({}); measure more with: {}", why, command),
        prose("contest.md", fmt::arg("small", small_bytes_per_edge), fmt::arg("fast", store::fast_ratio))};
}

/// A recording has several shapes, whose tables differ: all of them together.
std::string bytes_fact(const RankedCell& cell) {
    if (scene_kind(*cell.cell) == "recorded") return scene_bytes_text(cell);
    return fmt::format("{} per table, {} bytes per edge",
                       cell.table_bytes ? size_text(*cell.table_bytes) : "bytes not measured",
                       cell.bytes_per_edge ? number_text(*cell.bytes_per_edge, "B/edge") : "?");
}

}  // namespace

Decision decision_of(const Answer& answer, bool own_tables) {
    const std::vector<SceneRanking>& scenes = own_tables ? answer.own : answer.shared;
    const std::optional<Recommendation> take = recommendation_of(scenes);
    if (!take) return {{}, why_nothing_is_taken(scenes, measuring_command(answer, own_tables))};
    if (const std::string& noise = take->scenes.front().scene->noise; !noise.empty())
        return {{}, {"too noisy to choose by: " + noise}};
    const RankedCell& cell = *take->example().cell;
    Decision decision{cell.name(), {time_fact(*take), bytes_fact(cell)}};
    if (!take->example().ties)
        decision.facts.front() += "; what wins a scene is slower on average or over the limit elsewhere";
    else if (std::ranges::none_of(take->scenes, [](const auto& one) { return one.scene->beats_baseline; }))
        decision.facts.front() += "; nothing beats the paper's layout";
    else if (!take->beats_baseline_somewhere())
        decision.facts.front() += "; where it ties, nothing beats the paper's layout";
    const auto near_error = worst_error_of(answer.near, take->algorithm, take->table);
    if (const double error = std::max(take->worst_error.value_or(0), near_error.value_or(0)); error > 0)
        decision.facts.push_back("worst error " + number_text(error, "scale"));
    Condition near("near contact", *take), default_flags("default flags", *take);
    for (const SceneRanking& scene : answer.near) near.compare(scene.cells, scene);
    for (const SceneRanking& scene : scenes)
        if (!scene.default_flags.empty()) default_flags.compare(scene.default_flags, scene);
    decision.facts.insert(decision.facts.end(), {near.fact(), default_flags.fact()});
    decision.near_contact_changes_it = near.changes_it();
    decision.default_flags_change_it = default_flags.changes_it();
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

/// Returns "V-Clip on lean_f32" if more than half of the rows of a column that take something take it; else
/// "V-Clip on lean" if they do without the precision; else nothing. `whom`: set to what it is said of.
std::string taken_by_most(const std::vector<DecisionRow>& rows, DecisionColumn column, std::string& whom) {
    for (const bool with_precision : {true, false}) {
        std::map<std::string, std::size_t> counts;
        std::size_t taking = 0;
        for (const DecisionRow& row : rows) {
            const std::string& take = (row.*column).take;
            if (!take.empty()) ++taking, ++counts[with_precision ? take : take.substr(0, take.rfind('_'))];
        }
        for (const auto& [take, count] : counts) {
            whom = count == rows.size()      ? ""
                   : 2 * count > rows.size() ? " for most bodies"
                                             : " for most bodies with a recommendation";
            if (2 * count > taking) return take;
        }
    }
    return {};
}

std::string decision_sentence(const std::vector<DecisionRow>& rows) {
    std::string text;
    for (const DecisionColumn column : decision_columns) {
        if (std::ranges::all_of(rows, [&](const auto& row) { return (row.*column).take.empty(); })) continue;
        std::string whom;
        const std::string take = taken_by_most(rows, column, whom);
        append(text,
               fmt::format("{}{}.",
                           column == &DecisionRow::own ? "If every body has a table of its own, "
                                                       : "If your bodies share a table, ",
                           take.empty() ? "the layout to take depends on the body" : "take " + take + whom),
               " ");
    }
    if (text.empty()) return "Nothing is recommended; the table says why.";
    std::size_t near = 0, flags = 0, all = 0;
    for (const DecisionRow& row : rows)
        for (const DecisionColumn column : decision_columns)
            near += (row.*column).near_contact_changes_it, flags += (row.*column).default_flags_change_it,
                all += !(row.*column).take.empty();
    if (near + flags > 0)
        text += fmt::format(" Of {}, near contact changes {} and default compiler flags {}.",
                            plural(all, "answer"), near, flags);
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
            by_limit_[limit] = decision_rows(data, {.error_limit = limit,
                                                    .shape = question.shape,
                                                    .own_tables = question.own_tables,
                                                    .bodies = question.bodies});
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
