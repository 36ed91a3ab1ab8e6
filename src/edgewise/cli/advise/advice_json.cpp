// SPDX-License-Identifier: MIT
//
// The JSON of the report's answer, and what only a race knows.
#include <fmt/format.h>

#include "edgewise/cli/advise/advice.hpp"
#include "edgewise/cli/command.hpp"
#include "edgewise/reports/answer/answer_json.hpp"
#include "edgewise/studies/advise/changes.hpp"

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

}  // namespace

AdviceJson advice_json(const Advice& advice) {
    const Race& race = advice.race;
    std::vector<std::string> not_asked = advice.left_out;
    not_asked.insert(not_asked.end(), advice.not_asked.begin(), advice.not_asked.end());
    AdviceJson json = reports::answer_json(race.answer);
    if (race.taken()) add_caches(json["take"], race);
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
