// SPDX-License-Identifier: MIT
#include "edgewise/reports/answer/answer_text.hpp"

#include <fmt/core.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/answer/decision.hpp"
#include "edgewise/reports/answer/ranking.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

std::string own_variation_text(const SceneRanking& scene) {
    if (!scene.own_variation.factor) return {};
    const double percent = (scene.own_variation.high() - 1) * 100;
    return fmt::format("{:.{}f} %", percent, percent < 9.95 ? 1 : 0);
}

std::string noise_text(const Answer& answer) {
    const SceneRanking *quietest = nullptr, *noisiest = nullptr;
    for (const SceneRanking* scene : answer.scenes()) {
        if (!scene->own_variation.factor) continue;
        if (!quietest || scene->own_variation.high() < quietest->own_variation.high()) quietest = scene;
        if (!noisiest || scene->own_variation.high() > noisiest->own_variation.high()) noisiest = scene;
    }
    if (!quietest) return {};
    const auto text = [](const SceneRanking& scene) {
        return fmt::format("{} ({})", own_variation_text(scene), scene.label);
    };
    return quietest == noisiest ? text(*quietest) : text(*quietest) + " to " + text(*noisiest);
}

std::vector<std::string> what_passed(const Answer& answer) {
    const CellCounts& counts = answer.counts;
    std::vector<std::string> passed;
    if (counts.verified > 0)
        passed.push_back(
            fmt::format("{} gave the right answers to every checked query, compared with exact "
                        "arithmetic, before they were timed.",
                        plural(counts.verified, "cell")));
    if (counts.stability_verified > 0)
        passed.push_back(
            fmt::format("{} of hard pairs (parallel faces, needles, far offsets, bad starts): no "
                        "wrong verdict outside the band where rounding decides.",
                        plural(counts.stability_verified, "row")));
    if (const std::string noise = noise_text(answer); !noise.empty())
        passed.push_back(fmt::format("The baseline was timed against itself: {}.", noise));
    return passed;
}

std::string gaps_sentence(const Answer& answer) {
    return fmt::format("{} of {} figures were not measured.", answer.gaps.missing, answer.gaps.figures());
}

std::string why_sentence(const RankedCell& cell, const RankedCell& beside) {
    const auto both = [](const std::optional<double>& one, const std::optional<double>& other,
                         const char* what) {
        if (!one || !other) return fmt::format("{} not measured", what);
        return fmt::format("{} {} against {}", number_text(*one), what, number_text(*other));
    };
    const auto of_step = [](const RankedCell& one) -> std::optional<double> {
        if (!one.steps || !(*one.steps > 0)) return std::nullopt;
        return one.ns / *one.steps;
    };
    return fmt::format("{}, {}, {}", both(cell.steps, beside.steps, "steps per query"),
                       both(cell.lines_per_query, beside.lines_per_query, "lines per query"),
                       both(of_step(cell), of_step(beside), "ns per step"));
}

namespace {

/// Says what the intervals of the cells that matter, those in the tie sets, hold for.
std::string intervals_sentence(const Answer& answer) {
    std::size_t between = 0, ties = 0;
    for (const SceneRanking* scene : answer.scenes())
        for (const std::size_t i : scene->ties) ++ties, between += scene->cells[i].holds_between_processes();
    if (between == 0) return "Intervals are over the rounds of one process.";
    return fmt::format(
        "Intervals of {} hold between processes; others are over the rounds of one process.",
        between == ties ? "cells that tie" : fmt::format("{} of {} cells that tie", between, ties));
}

}  // namespace

AnswerText answer_text(const Answer& answer, const ReportData& data) {
    AnswerText text;
    text.conditions = fmt::format("Error at most {} of the bodies' size, on {}.",
                                  limit_text(answer.question.error_limit), machine_text(data));
    const std::string noise = noise_text(answer);
    text.noise =
        noise.empty()
            ? "The baseline's own variation was not measured: it is not among the cells."
            : fmt::format(
                  "The baseline timed against itself differs by {}: its own variation. Cells that differ by less in "
                  "that scene tie. {}",
                  noise, intervals_sentence(answer));
    if (any_unfinished(answer.runs)) {
        const std::size_t missing = missing_cells(answer.runs);
        text.counts =
            fmt::format("A sweep did not finish: {}; the same command goes on from there. ",
                        missing > 0 ? fmt::format("{} of its plan {} missing", plural(missing, "cell"),
                                                  missing == 1 ? "is" : "are")
                                    : std::string("what follows its cells is missing"));
    }
    const CellCounts& counts = answer.counts;
    text.counts += fmt::format("{} of {} verified, {} failed", counts.verified, plural(counts.cells, "cell"),
                               counts.failed);
    if (counts.unavailable > 0) text.counts += fmt::format(", {} unavailable", counts.unavailable);
    if (counts.stability_rows > 0)
        text.counts += fmt::format("; {}, {} failed", plural(counts.stability_rows, "stability row"),
                                   counts.stability_failed);
    text.counts += ". " + gaps_sentence(answer);
    return text;
}

std::string tie_set_text(const SceneRanking& scene) {
    if (scene.ties.empty()) return "nothing is known to be within the error";
    std::string cells;
    for (const std::size_t i : scene.ties)
        append(cells, scene.cells[i].name() + " " + ratio_text(scene.cells[i]), "; ");
    return (scene.ties.size() == 1 ? "alone: " : fmt::format("{} tie: ", scene.ties.size())) + cells;
}

std::string terminal_text(const Answer& answer, const ReportData& data) {
    const Question& question = answer.question;
    const DecisionTable table = Decisions(data, question).table(question.error_limit);
    std::string text = table.text(question);
    if (!table.changes.empty()) text += "\n\nWhat would change this:";
    for (const std::string& change : table.changes) text += "\n  " + change;
    const AnswerText about = answer_text(answer, data);
    text += fmt::format("\n\n{} {} {}\n", about.conditions, about.noise, about.counts);
    for (const SceneRanking* scene : answer.scenes())
        text += fmt::format("\n  {}, {}: {}", scene->label, scene->shape, tie_set_text(*scene));
    return text;
}

namespace {

using UnitsJson = nlohmann::json;

std::string cpu_name(const UnitsJson& machine) {
    const UnitsJson cpu = input::member_of(machine, "cpu"), name = input::member_of(cpu, "name");
    if (cpu.is_string()) return cpu;
    return name.is_string() ? name.get<std::string>() : "a processor that the store does not name";
}

std::vector<std::string> data_caches(const UnitsJson& machine) {
    std::vector<std::string> sizes;
    const UnitsJson caches = input::member_of(machine, "caches");
    if (!caches.is_array()) return sizes;
    for (const UnitsJson& cache : caches) {
        const UnitsJson bytes = input::member_of(cache, "bytes");
        if (!bytes.is_number() || input::member_of(cache, "type") == "Instruction") continue;
        sizes.push_back(size_text(bytes.get<double>()));
    }
    return sizes;
}

/// Says for which processor the program was compiled, from the stored compiler flags.
std::string tuning_text(const std::string& flags) {
    constexpr std::string_view option = "-march=";
    const std::size_t at = flags.rfind(option);
    if (flags.empty()) return "compiler flags not recorded";
    if (at == flags.npos) return "compiled with default flags (no -march)";
    const std::size_t from = at + option.size();
    const std::string processor = flags.substr(from, flags.find(' ', from) - from);
    return fmt::format("compiled for {} ({}{})", processor == "native" ? "this processor" : processor, option,
                       processor);
}

}  // namespace

std::string limit_text(double limit) {
    const int power = static_cast<int>(std::floor(std::log10(limit) + 1e-9));
    const std::string factor = fmt::format("{:.3g}", limit / std::pow(10.0, power));
    return fmt::format("{}e{}", factor, power);
}

std::string ratio_text(const RankedCell& cell) {
    if (!cell.interval) return fmt::format("{:.2f}", cell.ratio);
    return fmt::format("{:.2f} [{:.2f}, {:.2f}]", cell.ratio, cell.low(), cell.high());
}

std::string scene_bytes_text(const RankedCell& cell) {
    if (!cell.scene_bytes || !cell.tables) return "bytes not measured";
    return fmt::format("{} in {}", size_text(*cell.scene_bytes),
                       plural(static_cast<std::size_t>(*cell.tables), "table"));
}

std::string size_text(double bytes) {
    if (bytes >= mebibyte) return number_text(bytes / mebibyte) + " MiB";
    if (bytes >= kibibyte) return number_text(bytes / kibibyte) + " KiB";
    return number_text(bytes, "B") + " B";
}

std::string processor_text(const ReportData& data) {
    return cpu_name(input::json_or_null(data.build.machine_json));
}

std::string machine_text(const ReportData& data) {
    const UnitsJson machine = input::json_or_null(data.build.machine_json);
    const std::vector<std::string> caches = data_caches(machine);
    const std::string tuning = tuning_text(data.build.flags);
    if (caches.empty()) return fmt::format("{}, {}", cpu_name(machine), tuning);
    return fmt::format("{}, {} of cache, {}", cpu_name(machine), fmt::join(caches, " / "), tuning);
}

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

AnswerJson scene_json(const SceneRanking& scene) {
    AnswerJson json = {{"scene", scene.label},
                       {"sentence", scene.sentence},
                       {"shape", scene.shape},
                       {"vertices", scene.vertices},
                       {"own_tables", scene.own_tables},
                       {"beats_baseline", scene.beats_baseline},
                       {"noise", or_null(scene.own_variation.factor)},
                       {"not_measured", scene.not_measured},
                       {"over_limit", scene.over_limit}};
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

std::string measuring_command(const Answer& answer, std::optional<bool> own_tables) {
    if (!own_tables) own_tables = answer.question.own_tables;
    std::string command = "edgewise advise" + answer.body_option;
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
        {"command", measuring_command(answer)},
        {"noise", noise_json(answer)}};
    json["scenes"] = AnswerJson::array();
    for (const SceneRanking* scene : answer.scenes()) json["scenes"].push_back(scene_json(*scene));
    const std::vector<SceneRanking>& scenes = answer.shared.empty() ? answer.own : answer.shared;
    const std::optional<Recommendation> take = recommendation_of(scenes);
    if (!take) return json;
    const Recommendation::InScene& shown = take->example();
    json["take"] = ranked_json(*shown.cell);
    json["take"]["error"] = or_null(take->worst_error);
    json["take"]["scene"] = shown.scene->label;
    json["take"]["own_tables"] = shown.scene->own_tables;
    json["take"]["beats_baseline"] = take->beats_baseline_somewhere();
    json["take"]["too_noisy"] = take->scenes.front().scene->noise;
    json["next"] = next_json(*shown.scene, *shown.cell);
    json["dropped"] = dropped_json(*shown.scene);
    return json;
}

}  // namespace edgewise::reports
