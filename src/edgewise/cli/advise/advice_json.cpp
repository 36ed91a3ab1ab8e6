// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "edgewise/cli/advise/advice.hpp"

namespace edgewise::cli {

namespace {

using AdviceJson = nlohmann::json;

AdviceJson json_of(const Finalist& one, const Finals& finals) {
    return {{"algorithm", one.algorithm},
            {"table", one.table},
            {"time_ratio", {one.low(), one.mid(), one.high()}},
            {"ns", one.ns},
            {"bytes_per_edge", one.bytes_per_edge},
            {"table_bytes", one.table_bytes},
            {"lines_per_query", one.lines},
            {"steps", one.steps},
            {"error", one.error},
            {"ties", finals.ties(one)},
            {"misses_per_query", one.misses},
            {"in_cache_ns", one.in_cache_ns},
            {"predicted_ns", one.predicted_ns > 0 ? AdviceJson(one.predicted_ns) : AdviceJson()}};
}

AdviceJson asked_json(const Advice& advice) {
    const auto& asked = advice.asked;
    return {{"scene", asked.scene.name},      {"parameters", scene_of(asked).parameters},
            {"shape", asked.shape.name},      {"vertices", asked.shape.body.vertex_count()},
            {"own_tables", asked.own_tables}, {"needs", to_string(asked.needs)},
            {"error", asked.error_limit},     {"machines", advice.machines},
            {"assumed", advice.assumed},      {"seed", asked.seed}};
}

}  // namespace

AdviceJson advice_json(const Advice& advice) {
    const Finals& finals = advice.finals;
    AdviceJson json = {
        {"asked", asked_json(advice)},         {"take", nullptr},
        {"next", AdviceJson::array()},         {"out", AdviceJson::array()},
        {"changes_it", AdviceJson::array()},   {"held", nullptr},
        {"processes", finals.processes},       {"noise", {finals.noise_low, finals.noise_high}},
        {"latencies_ns", finals.latencies_ns}, {"seconds", advice.seconds},
        {"not_asked", advice.not_asked},       {"command", advise_command(advice)}};
    for (const auto& cell : advice.screen.cells) {
        if (cell.out.empty()) continue;
        json["out"].push_back({{"algorithm", cell.algorithm},
                               {"table", cell.type->name},
                               {"reason", cell.out},
                               {"ns", cell.ns},
                               {"error", cell.error},
                               {"bytes_per_edge", cell.bytes_per_edge}});
    }
    if (finals.ranked.empty()) return json;
    json["take"] = json_of(finals.ranked.front(), finals);
    for (std::size_t i = 1; i < finals.ranked.size(); ++i)
        json["next"].push_back(json_of(finals.ranked[i], finals));
    json["changes_it"] = what_would_change(advice);
    if (const auto held = prediction_held(finals)) json["held"] = *held;
    return json;
}

}  // namespace edgewise::cli
