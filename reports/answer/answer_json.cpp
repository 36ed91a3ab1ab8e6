// SPDX-License-Identifier: MIT
#include "edgewise/reports/answer/answer_json.hpp"

#include <fmt/core.h>

#include <algorithm>

#include <nlohmann/json.hpp>

#include "edgewise/reports/answer/answer_text.hpp"

namespace edgewise::reports {

namespace {

using AnswerJson = nlohmann::json;

constexpr std::size_t runners_up = 2;  ///< number of cells named after the tied ones

AnswerJson or_null(const std::optional<double>& value) { return value ? AnswerJson(*value) : AnswerJson(); }

/// Returns the variation in the noisiest scene, and the number of scenes where it is known.
AnswerJson noise_json(const Answer& answer) {
    OwnVariation widest;
    std::size_t cells = 0;
    for (const SceneRanking* scene : answer.scenes()) {
        if (!scene->own_variation.factor) continue;
        ++cells;
        widest.factor = std::max(widest.high(), scene->own_variation.high());
    }
    return cells == 0 ? AnswerJson()
                      : AnswerJson{{"low", widest.low()}, {"high", widest.high()}, {"cells", cells}};
}

AnswerJson scene_json(const SceneRanking& scene) {
    AnswerJson json = {{"scene", scene.label},
                       {"sentence", scene.sentence},
                       {"shape", scene.shape},
                       {"vertices", scene.vertices},
                       {"own_tables", scene.own_tables},
                       {"beats_baseline", scene.beats_baseline},
                       {"noise", or_null(scene.own_variation.factor)},
                       {"not_measured", scene.not_measured}};
    json["cells"] = AnswerJson::array();
    for (const RankedCell& one : scene.cells) {
        json["cells"].push_back(ranked_json(one));
        json["cells"].back()["dropped"] = one.dropped;
        json["cells"].back()["ties"] = scene.ties_with_winner(one);
    }
    json["peers"] = AnswerJson::array();
    for (const RankedCell& one : scene.peers) json["peers"].push_back(ranked_json(one));
    return json;
}

/// Returns the scene that represents `take`: the one where it ties with the smallest ratio.
const SceneRanking& shown_scene(const Recommendation& take) {
    const RankedCell* example = &take.example();
    return *std::ranges::find(take.scenes, example, &Recommendation::InScene::cell)->scene;
}

AnswerJson next_json(const SceneRanking& scene, const RankedCell& taken) {
    AnswerJson next = AnswerJson::array();
    std::size_t behind = 0;
    for (const RankedCell& one : scene.cells) {
        if (&one == &taken || !one.meets_error()) continue;
        const bool ties = scene.ties_with_winner(one);
        if (!ties && behind++ >= runners_up) continue;
        next.push_back(ranked_json(one));
        next.back()["ties"] = ties;
    }
    return next;
}

AnswerJson dropped_json(const SceneRanking& scene) {
    AnswerJson dropped = AnswerJson::array();
    for (const RankedCell& one : scene.cells) {
        if (one.meets_error()) continue;
        dropped.push_back(ranked_json(one));
        dropped.back()["reason"] = one.dropped;
    }
    return dropped;
}

}  // namespace

AnswerJson ranked_json(const RankedCell& cell) {
    return {{"algorithm", cell.cell->algorithm},
            {"table", cell.table},
            {"ns", cell.ns},
            {"time_ratio", {cell.low(), cell.ratio, cell.high()}},
            {"bytes_per_edge", or_null(cell.bytes_per_edge)},
            {"table_bytes", or_null(cell.table_bytes)},
            {"lines_per_query", or_null(cell.lines_per_query)},
            {"error", or_null(cell.worst_error)}};
}

std::string advise_command(const Answer& answer, std::optional<bool> own_tables) {
    if (!own_tables) own_tables = answer.question.own_tables;
    std::string command = "edgewise advise";
    if (!answer.source.empty())
        command += " --shape " + (answer.source == "built-in" ? answer.shape : answer.source);
    if (own_tables) command += *own_tables ? " --own-tables" : " --shared-tables";
    return command + " --error " + limit_text(answer.question.error_limit);
}

AnswerJson answer_json(const Answer& answer) {
    const Question& question = answer.question;
    AnswerJson json = {
        {"asked",
         {{"error", question.error_limit},
          {"shape", answer.shape},
          {"own_tables", question.own_tables ? AnswerJson(*question.own_tables) : AnswerJson()}}},
        {"take", nullptr},
        {"next", AnswerJson::array()},
        {"dropped", AnswerJson::array()},
        {"changes_it", AnswerJson::array()},
        {"held", nullptr},
        {"command", advise_command(answer)},
        {"noise", noise_json(answer)}};
    json["scenes"] = AnswerJson::array();
    for (const SceneRanking* scene : answer.scenes()) json["scenes"].push_back(scene_json(*scene));
    const std::vector<SceneRanking>& scenes = answer.shared.empty() ? answer.own : answer.shared;
    const std::optional<Recommendation> take = recommendation_of(scenes);
    if (!take) return json;
    const SceneRanking& shown = shown_scene(*take);
    json["take"] = ranked_json(take->example());
    json["take"]["error"] = or_null(take->worst_error);
    json["take"]["scene"] = shown.label;
    json["take"]["own_tables"] = shown.own_tables;
    json["take"]["beats_baseline"] = take->beats_baseline_somewhere();
    json["next"] = next_json(shown, take->example());
    json["dropped"] = dropped_json(shown);
    return json;
}

}  // namespace edgewise::reports
