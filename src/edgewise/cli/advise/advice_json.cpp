// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "edgewise/cli/advise/advice.hpp"
#include "edgewise/cli/command.hpp"
#include "edgewise/studies/advise/changes.hpp"

namespace edgewise::cli {

namespace {

using AdviceJson = nlohmann::json;
using studies::advise::Finalist;
using studies::advise::Finals;

/// Null where it was not predicted.
AdviceJson predicted_here(const Finalist& one) {
    const auto found = one.predicted_ns.find(studies::advise::this_machine);
    return found == one.predicted_ns.end() ? AdviceJson() : AdviceJson(found->second);
}

AdviceJson json_of(const Finalist& one, const Finals& finals) {
    return {{"algorithm", one.algorithm},
            {"table", one.table},
            {"time_ratio", {one.low(), one.mid(), one.high()}},
            {"ns", one.mid_ns()},
            {"bytes_per_edge", one.bytes_per_edge},
            {"table_bytes", one.table_bytes},
            {"lines_per_query", or_null(one.lines)},
            {"steps", one.steps},
            {"error", one.error},
            {"ties", finals.ties(one)},
            {"misses_per_query", one.misses},
            {"in_cache_ns", or_null(one.in_cache_ns)},
            {"predicted_ns", predicted_here(one)},
            {"predicted_ns_on", one.predicted_ns}};
}

AdviceJson asked_json(const Advice& advice) {
    const auto& asked = advice.asked;
    return {{"scene", asked.scene.name},      {"parameters", scene_of(asked).parameters},
            {"shape", asked.shape.name},      {"vertices", asked.shape.body.vertex_count()},
            {"own_tables", asked.own_tables}, {"needs", to_string(asked.needs)},
            {"error", asked.error_limit},     {"machines", advice.machines},
            {"assumed", advice.assumed},      {"seed", asked.seed}};
}

/// Of a body that its tables cannot hold nothing is known.
AdviceJson json_of(const studies::advise::ScreenedCell& cell) {
    AdviceJson json = {{"algorithm", cell.algorithm}, {"table", cell.type->name}, {"reason", cell.out}};
    const bool held = cell.table_bytes > 0;
    json["ns"] = held ? AdviceJson(cell.ns) : AdviceJson();
    json["error"] = held ? AdviceJson(cell.error) : AdviceJson();
    json["bytes_per_edge"] = held ? AdviceJson(cell.bytes_per_edge) : AdviceJson();
    return json;
}

}  // namespace

AdviceJson advice_json(const Advice& advice) {
    const Finals& finals = advice.finals;
    std::vector<std::string> not_asked = advice.dropped;
    not_asked.insert(not_asked.end(), advice.not_asked.begin(), advice.not_asked.end());
    AdviceJson json = {{"asked", asked_json(advice)},
                       {"take", nullptr},
                       {"next", AdviceJson::array()},
                       {"out", AdviceJson::array()},
                       {"changes_it", AdviceJson::array()},
                       {"held", or_null(finals.prediction_held())},
                       {"processes", finals.processes},
                       {"noise", nullptr},
                       {"latencies_ns", finals.latencies_ns},
                       {"seconds", advice.seconds},
                       {"not_asked", not_asked},
                       {"command", advice.command}};
    for (const auto& cell : advice.screen.cells)
        if (!cell.is_in()) json["out"].push_back(json_of(cell));
    for (const Finalist& one : finals.over_limit) {
        if (advice.screen.is_inexact(one.algorithm, one.table)) continue;
        json["out"].push_back({{"algorithm", one.algorithm},
                               {"table", one.table},
                               {"reason", "its error, at a closer look"},
                               {"ns", one.mid_ns()},
                               {"error", one.error},
                               {"bytes_per_edge", one.bytes_per_edge}});
    }
    if (finals.processes > 1) json["noise"] = {finals.noise_low, finals.noise_high};
    if (finals.ranked.empty()) return json;
    json["take"] = json_of(finals.ranked.front(), finals);
    for (std::size_t i = 1; i < finals.ranked.size(); ++i)
        json["next"].push_back(json_of(finals.ranked[i], finals));
    json["changes_it"] =
        what_would_change(advice.asked, advice.screen, advice.other_tables, finals.ranked.front());
    return json;
}

}  // namespace edgewise::cli
