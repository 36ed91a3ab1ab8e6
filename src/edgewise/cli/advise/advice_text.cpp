// SPDX-License-Identifier: MIT
//
// The text and the JSON of the report's answer, and what only a race knows.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "edgewise/cli/advise/advice.hpp"
#include "edgewise/cli/command.hpp"
#include "edgewise/reports/answer/answer_text.hpp"
#include "edgewise/reports/answer/decision.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/studies/advise/screen.hpp"

namespace edgewise::cli {

namespace {

using AdviceJson = nlohmann::json;

/// Adds steps and caches to a cell that was raced; null where they are not known.
void add_caches(AdviceJson& json, const Race& race) {
    const reports::RankedCell& cell = *race.scene()->find(json["algorithm"], json["table"]);
    const studies::advise::CacheCost* const found = race.caches_of(cell);
    const studies::advise::CacheCost cost = found ? *found : studies::advise::CacheCost();
    const auto here = cost.predicted_ns.find(studies::advise::this_machine);
    json["steps"] = or_null(cell.steps);
    json["ties"] = race.scene()->ties_with_winner(cell);
    json["misses_per_query"] = cost.misses;
    json["in_cache_ns"] = or_null(cost.in_cache_ns);
    json["predicted_ns"] = here == cost.predicted_ns.end() ? AdviceJson() : AdviceJson(here->second);
    json["predicted_ns_on"] = cost.predicted_ns;
}

AdviceJson asked_json(const Advice& advice) {
    const auto& asked = advice.asked;
    return {{"scene", asked.scene.name},      {"parameters", scene_of(asked).parameters},
            {"shape", asked.shape.name},      {"vertices", asked.shape.body.vertex_count()},
            {"own_tables", asked.own_tables}, {"needs", to_string(asked.needs)},
            {"error", asked.error_limit},     {"machines", advice.machines},
            {"assumed", advice.assumed},      {"seed", asked.seed}};
}

/// Nothing is known of a body that its tables cannot hold.
AdviceJson json_of(const studies::advise::ScreenedCell& cell) {
    AdviceJson json = {{"algorithm", cell.algorithm}, {"table", cell.type->name}, {"reason", cell.dropped}};
    const bool held = cell.table_bytes > 0;
    json["ns"] = held ? AdviceJson(cell.ns) : AdviceJson();
    json["error"] = held ? AdviceJson(cell.error) : AdviceJson();
    json["bytes_per_edge"] = held ? AdviceJson(cell.bytes_per_edge) : AdviceJson();
    return json;
}

/// The first look's; then the race's, which checks more answers.
AdviceJson dropped_json(const Advice& advice, const AdviceJson& raced) {
    AdviceJson dropped = AdviceJson::array();
    for (const auto& cell : advice.screen.cells)
        if (!cell.is_in()) dropped.push_back(json_of(cell));
    for (const AdviceJson& one : raced)
        if (!advice.screen.is_inexact(advice.race.scene()->find(one["algorithm"], one["table"])->name()))
            dropped.push_back(one);
    return dropped;
}

using reports::RankedCell, reports::wrapped, reports::widest_line;
using studies::advise::CacheCost, studies::advise::DroppedFor;

/// Of all tables of the case; per edge too where these are of one body.
std::string table_bytes_text(const studies::advise::CaseAsked& asked, const RankedCell& cell) {
    const std::string all = reports::scene_bytes_text(cell);
    if (!cell.bytes_per_edge || !asked.recording.empty()) return all;
    return fmt::format("{:.1f} bytes per edge, {}", *cell.bytes_per_edge, all);
}

/// A label in a column of its own, and the rest folded next to it.
std::string labelled(const std::string& label, const std::string& text) {
    constexpr std::size_t indent = 14;
    return fmt::format("  {:<11} {}\n", label, wrapped(text, widest_line - indent, indent));
}

/// The paper's layout; null where it is taken itself, or was not raced.
const RankedCell* compared(const Advice& advice) {
    const RankedCell* const paper = advice.race.scene()->baseline();
    return paper == advice.race.taken() ? nullptr : paper;
}

/// How far the times can be trusted.
std::string variation_text(const Race& race) {
    const std::string own = reports::own_variation_text(*race.scene());
    return (race.processes() < 2 ? "one process, and the variation between processes is not known (--time)"
                                 : fmt::format("{} processes", race.processes())) +
           "; the baseline's own variation: " + (own.empty() ? "not measured" : own);
}

std::string taken_text(const Advice& advice) {
    const reports::Answer& answer = advice.race.answer;
    const RankedCell& taken = *advice.race.taken();
    const RankedCell* const paper = compared(advice);
    std::string bytes = table_bytes_text(advice.asked, taken);
    if (paper) bytes += "; the paper's layout: " + table_bytes_text(advice.asked, *paper);
    return labelled("take", reports::decision_of(answer, answer.shared.empty()).text()) +
           labelled("fastest", tie_set_text(*advice.race.scene())) +
           labelled("time",
                    fmt::format("{:.0f} ns per query here; {}", taken.ns, variation_text(advice.race))) +
           labelled("bytes", bytes) + (paper ? labelled("why", reports::why_sentence(taken, *paper)) : "");
}

/// Cells that were dropped for their answers. Those dropped for their time are many.
std::string dropped_text(const Advice& advice) {
    std::vector<std::string> dropped;
    for (const auto& cell : advice.screen.cells)
        if (cell.dropped_for == DroppedFor::error || cell.dropped_for == DroppedFor::failure)
            dropped.push_back(cell.name() + ": " + cell.dropped);
    if (const reports::SceneRanking* const scene = advice.race.scene())
        for (const RankedCell& one : scene->cells)
            if (!one.meets_error() && !advice.screen.is_inexact(one.name()))
                dropped.push_back(one.name() + ": " + one.dropped);
    return dropped.empty() ? "" : labelled("dropped", fmt::format("{}", fmt::join(dropped, "; ")));
}

/// "29.5 / 0.0" per level.
std::string misses_text(const std::vector<double>& misses) {
    std::vector<std::string> levels;
    for (const double level : misses) levels.push_back(fmt::format("{:.1f}", level));
    return fmt::format("{}", fmt::join(levels, " / "));
}

/// For each machine the misses, and for another machine, whose time is not measured, the prediction.
std::string caches_text(const Advice& advice) {
    const Race& race = advice.race;
    const CacheCost* const taken = race.caches_of(*race.taken());
    const RankedCell* const paper = compared(advice);
    const CacheCost* const paper_cost = paper ? race.caches_of(*paper) : nullptr;
    std::string text;
    for (const auto& [machine, misses] :
         taken ? taken->misses : std::map<std::string, std::vector<double>>()) {
        std::string line = fmt::format("{}: {} misses per query, level by level: {}", machine,
                                       race.taken()->table, misses_text(misses));
        if (paper_cost && paper_cost->misses.contains(machine))
            line += fmt::format("; the paper's layout: {}", misses_text(paper_cost->misses.at(machine)));
        const RankedCell* const best = race.fastest_predicted(machine);
        if (machine != studies::advise::this_machine && best)
            line += fmt::format(
                "; modelled, with every miss waited for as long as here, fastest is {}, {:.0f} ns; time there "
                "was not measured",
                best->name(), race.caches_of(*best)->predicted_ns.at(machine));
        text += labelled("caches", line);
    }
    return text;
}

std::string prediction_text(const Advice& advice) {
    const RankedCell* const best = advice.race.fastest_predicted(studies::advise::this_machine);
    if (!best) return labelled("predicted", "nothing: this machine's caches or the misses are not known");
    const CacheCost& cost = *advice.race.caches_of(*best);
    return labelled(
        "predicted",
        fmt::format("{} fastest, {:.0f} ns: {:.0f} ns in cache, and its modelled misses as long as they take "
                    "here ({:.0f} ns beyond the first level, nothing overlapping): {}",
                    best->name(), cost.predicted_ns.at(studies::advise::this_machine), *cost.in_cache_ns,
                    fmt::join(advice.race.latencies_ns, ", "),
                    *advice.race.prediction_held() ? "held, it is among those that tie" : "did not hold"));
}

/// Where nothing was raced: why, and what the first look says.
std::string nothing_text(const Advice& advice) {
    const auto& cells = advice.screen.cells;
    if (cells.empty()) return "nothing: no time was left to look at any cell (--time)";
    if (!cells.front().is_in()) return "nothing: nothing meets the error";
    return fmt::format("nothing is sure: {}. At a first look {} is fastest, {:.0f} ns per query",
                       advice.race.problem, cells.front().name(), cells.front().ns);
}

/// Sentences on what would change the advice; none where nothing is taken.
std::vector<std::string> changes_of(const Advice& advice) {
    const RankedCell* const taken = advice.race.taken();
    if (!taken) return {};
    return what_would_change(
        advice.asked, advice.screen, advice.other_tables,
        {taken->name(), taken->bytes_per_edge.value_or(0), taken->worst_error.value_or(0)});
}

}  // namespace

std::string advice_text(const Advice& advice) {
    std::string text = sentence_of(advice.asked) + "\n\n";
    for (const std::string& left : advice.left_out)
        text += labelled(&left == &advice.left_out.front() ? "left out" : "", left);
    for (const std::string& assumed : advice.assumed)
        text += labelled(&assumed == &advice.assumed.front() ? "assumed" : "", assumed);
    if (!advice.race.taken()) {
        text += labelled("take", nothing_text(advice)) + dropped_text(advice);
    } else {
        text += taken_text(advice) + dropped_text(advice) + caches_text(advice) + prediction_text(advice) +
                "  would change it\n";
        for (const std::string& change : changes_of(advice)) text += labelled("", change);
    }
    for (const std::string& left : advice.not_asked)
        text += labelled(&left == &advice.not_asked.front() ? "not asked" : "", left);
    return text + labelled("repeat", advice.command) + fmt::format("  ({:.0f} s)\n", advice.seconds);
}

AdviceJson advice_json(const Advice& advice) {
    const Race& race = advice.race;
    std::vector<std::string> not_asked = advice.left_out;
    not_asked.insert(not_asked.end(), advice.not_asked.begin(), advice.not_asked.end());
    AdviceJson json = reports::answer_json(race.answer);
    if (!json["take"].is_null()) add_caches(json["take"], race);
    for (AdviceJson& one : json["next"]) add_caches(one, race);
    json["asked"] = asked_json(advice);
    json["dropped"] = dropped_json(advice, json["dropped"]);
    json["changes_it"] = changes_of(advice);
    json["held"] = or_null(race.prediction_held());
    json["processes"] = race.processes();
    json["latencies_ns"] = race.latencies_ns;
    json["seconds"] = advice.seconds;
    json["not_asked"] = not_asked;
    json["command"] = advice.command;
    return json;
}

}  // namespace edgewise::cli
