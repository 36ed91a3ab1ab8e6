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
#include "edgewise/reports/answer/answer_json.hpp"
#include "edgewise/reports/answer/ranking.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

/// Smallest and largest value over some scenes.
struct Range {
    std::optional<double> low, high;

    void add(double value) {
        low = std::min(low.value_or(value), value);
        high = std::max(high.value_or(value), value);
    }
    [[nodiscard]] std::string text() const {
        const std::string from = fmt::format("{:.2f}", *low), to = fmt::format("{:.2f}", *high);
        return from == to ? from : from + " to " + to;
    }
};

std::string condition_of(bool own_tables) {
    return own_tables ? "If every body has a table of its own" : "If your bodies share a table";
}

/// Returns "139 bytes per edge instead of 234, worst error 2e-7".
std::string costs(const Recommendation& take) {
    const RankedCell& cell = take.example();
    const RankedCell* baseline = take.scenes.front().scene->baseline();
    std::string text;
    if (cell.bytes_per_edge) {
        text = number_text(*cell.bytes_per_edge, "B/edge") + " bytes per edge";
        if (baseline && baseline->bytes_per_edge && baseline->bytes_per_edge != cell.bytes_per_edge)
            text += " instead of " + number_text(*baseline->bytes_per_edge, "B/edge");
    }
    if (take.worst_error) append(text, "worst error " + number_text(*take.worst_error, "scale"));
    return text;
}

/// Compares the best GJK with the choice, over the scenes of the take.
std::string gjk_sentence(const Recommendation& take) {
    if (take.algorithm == "gjk") return {};
    Range range;
    for (const Recommendation::InScene& one : take.scenes) {
        const RankedCell* gjk = one.scene->best("gjk");
        if (gjk && one.cell) range.add(gjk->ratio / one.cell->ratio);
    }
    if (!range.low) return " No GJK is within the error.";
    return fmt::format(" The best GJK within the error takes {} times as long.", range.text());
}

/// Returns "600 tables take 5.8 MiB instead of 154 MiB".
std::string memory_sentence(const Recommendation& take) {
    const RankedCell* most = nullptr;
    const RankedCell* beside = nullptr;
    for (const Recommendation::InScene& one : take.scenes) {
        if (!one.ties || !one.cell->scene_bytes || !one.cell->tables) continue;
        if (most && *one.cell->tables <= *most->tables) continue;
        most = one.cell, beside = one.scene->baseline();
    }
    if (!most || *most->tables < 2) return {};
    std::string text = fmt::format(" {:.0f} tables take {}", *most->tables, size_text(*most->scene_bytes));
    if (beside && beside != most && beside->scene_bytes)
        text += fmt::format(" instead of {}", size_text(*beside->scene_bytes));
    return text + ".";
}

/// Names the scenes where another cell wins.
std::string exceptions(const Recommendation& take) {
    std::string text;
    for (const Recommendation::InScene& one : take.scenes) {
        const RankedCell& winner = *one.scene->winner();
        if (one.ties || !one.scene->beats_baseline) continue;
        const std::string against = one.cell ? fmt::format(" and this one {}", ratio_text(*one.cell)) : "";
        append(text,
               fmt::format("{}: {} takes {}{}", one.scene->label, winner.name(), ratio_text(winner), against),
               "; ");
    }
    return text.empty() ? text : " Elsewhere: " + text + ".";
}

/// Names the scenes in which the winner's own interval is too wide to decide.
std::string noisy_sentence(const std::vector<SceneRanking>& scenes) {
    std::string names;
    for (const SceneRanking& scene : scenes)
        if (scene.too_noisy) append(names, scene.label);
    if (names.empty()) return names;
    return fmt::format(
        " Too noisy to choose by, the winner's interval spans more than a factor of 2: {}. "
        "Measure these again on a machine with nothing else to do.",
        names);
}

std::string scene_count(std::size_t count) { return plural(count, "scene"); }

/// Says where the choice beats the baseline and by how much, or that nothing beats it.
std::string ratios_sentence(const Recommendation& take) {
    Range faster;
    std::size_t wins = 0, tied = 0;
    const RankedCell* only = nullptr;
    for (const Recommendation::InScene& one : take.scenes) {
        if (!one.ties) continue;
        if (!one.scene->beats_baseline) {
            ++tied;
            continue;
        }
        ++wins, only = one.cell;
        faster.add(one.cell->ratio);
    }
    if (wins == 0) return {};
    std::string text = fmt::format(" A query takes {} of the time of the paper's layout",
                                   wins == 1 ? ratio_text(*only) : faster.text());
    if (wins > 1 || tied > 0) text += fmt::format(" in {}", scene_count(wins));
    if (tied > 0) text += fmt::format(", and what it takes there to within noise in {}", scene_count(tied));
    return text + ".";
}

AdviceText keep_baseline(const Recommendation& take, const Answer& answer, bool own_tables) {
    const std::string scenes = plural(take.scenes.size(), "scene");
    const std::string paper = fmt::format("{} on the paper's layout ({})",
                                          algorithm_title(answer.baseline.algorithm), answer.baseline.table);
    if (take.is(answer.baseline))
        return {fmt::format("{}, keep {}.", condition_of(own_tables), paper),
                fmt::format("Nothing beats it by more than noise in {}.", scenes)};
    const RankedCell& chosen = take.example();
    return {
        fmt::format("{}, nothing beats the paper's layout ({} on {}): take {}.", condition_of(own_tables),
                    algorithm_title(answer.baseline.algorithm), answer.baseline.table, chosen.name()),
        fmt::format("It ties in {} of {}. It has {}.",
                    std::ranges::count_if(take.scenes, &Recommendation::InScene::ties), scenes, costs(take))};
}

AdviceText take_winner(const Recommendation& take, bool own_tables) {
    const std::string cost = costs(take);
    return {fmt::format("{}, take {}.", condition_of(own_tables), take.example().name()),
            (cost.empty() ? "" : "It has " + cost + ".") + ratios_sentence(take)};
}

/// Says what was not measured in scenes that recommend nothing for that reason, and how to measure it.
std::string missing_sentence(const std::vector<SceneRanking>& scenes, const Answer& answer) {
    std::string missing;
    for (const SceneRanking& scene : scenes) {
        if (!scene.winner() || scene.recommends()) continue;
        std::string cells;
        for (const std::string& cell : scene.not_measured) append(cells, cell);
        append(missing, fmt::format("{}: {}", scene.label, cells), "; ");
    }
    if (missing.empty()) return {};
    return fmt::format("Not measured: {}. {} Measure them with: {}.", missing, contest_rule(),
                       advise_command(answer, scenes.front().own_tables));
}

std::string conditions_of(const Answer& answer, const ReportData& data) {
    std::string bodies = answer.vertices > 0 ? fmt::format("Bodies of {} vertices", answer.vertices)
                                             : std::string("Bodies of the scenes");
    return fmt::format("{}, error at most {} of their size, on {}.", bodies,
                       limit_text(answer.question.error_limit), machine_text(data));
}

std::string unfinished_sentence(const Answer& answer) {
    const std::size_t missing = missing_cells(answer.runs);
    return fmt::format("A sweep did not finish: {}; the same command goes on from there.",
                       missing > 0 ? plural(missing, "cell") + " of its plan are missing"
                                   : std::string("what follows its cells is missing"));
}

}  // namespace

std::optional<AdviceText> advice_of(const std::vector<SceneRanking>& scenes, const Answer& answer) {
    const std::optional<Recommendation> take = recommendation_of(scenes);
    const std::string missing = missing_sentence(scenes, answer);
    if (!take && missing.empty()) return std::nullopt;
    const bool own_tables = scenes.front().own_tables;
    if (!take) return AdviceText{condition_of(own_tables) + ", nothing is recommended.", missing};
    if (std::ranges::all_of(take->scenes,
                            [](const Recommendation::InScene& one) { return one.scene->too_noisy; }))
        return AdviceText{condition_of(own_tables) + ", these times are too noisy to choose by.",
                          noisy_sentence(scenes).substr(1)};
    AdviceText text = take->beats_baseline_somewhere() ? take_winner(*take, own_tables)
                                                       : keep_baseline(*take, answer, own_tables);
    if (own_tables) text.rest += memory_sentence(*take);
    text.rest += noisy_sentence(scenes) + exceptions(*take) + gjk_sentence(*take);
    if (!missing.empty()) text.rest += " Of other scenes nothing is recommended. " + missing;
    return text;
}

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

std::string cells_sentence(const Answer& answer) {
    const CellCounts& counts = answer.counts;
    std::string text = fmt::format("{} of {} verified, {} failed", counts.verified,
                                   plural(counts.cells, "cell"), counts.failed);
    if (counts.unavailable > 0) text += fmt::format(", {} unavailable", counts.unavailable);
    if (counts.stability_rows > 0)
        text += fmt::format("; {}, {} failed", plural(counts.stability_rows, "stability row"),
                            counts.stability_failed);
    return text + ".";
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

AnswerText answer_text(const Answer& answer, const ReportData& data) {
    AnswerText text;
    for (const auto* scenes : {&answer.shared, &answer.own})
        if (auto advice = advice_of(*scenes, answer)) text.advice.push_back(std::move(*advice));
    if (text.advice.empty())
        text.advice.push_back(
            {"No cell of this store answers the question.",
             "An answer needs cells with known errors that were timed in the same rounds as the baseline."});
    text.conditions = conditions_of(answer, data);
    const std::string noise = noise_text(answer);
    text.noise =
        noise.empty()
            ? "The baseline's own variation was not measured: it is not among the cells."
            : fmt::format(
                  "The baseline timed against itself differs by {}: its own variation. Cells that differ by less in "
                  "that scene tie. Intervals are over the rounds of one process.",
                  noise);
    text.counts = cells_sentence(answer) + " " + gaps_sentence(answer);
    if (any_unfinished(answer.runs)) text.counts = unfinished_sentence(answer) + " " + text.counts;
    return text;
}

std::string tie_set_text(const SceneRanking& scene) {
    if (scene.ties.empty()) return "nothing is within the error";
    std::string cells;
    for (const std::size_t i : scene.ties)
        append(cells, scene.cells[i].name() + " " + ratio_text(scene.cells[i]), "; ");
    return (scene.ties.size() == 1 ? "alone: " : fmt::format("{} tie: ", scene.ties.size())) + cells;
}

std::string terminal_text(const Answer& answer, const ReportData& data) {
    std::string text = answer_paragraph(answer, data) + "\n";
    for (const SceneRanking* scene : answer.scenes())
        text += fmt::format("\n  {}, {}: {}", scene->label, scene->shape, tie_set_text(*scene));
    return text;
}

std::string answer_paragraph(const Answer& answer, const ReportData& data) {
    const AnswerText text = answer_text(answer, data);
    std::string paragraph;
    for (const AdviceText& advice : text.advice) append(paragraph, advice.lead + " " + advice.rest, " ");
    for (const std::string* sentence : {&text.conditions, &text.noise, &text.counts})
        append(paragraph, *sentence, " ");
    return paragraph;
}

namespace {

using UnitsJson = nlohmann::json;

std::string cpu_name(const UnitsJson& machine) {
    const UnitsJson cpu = machine.is_object() ? machine.value("cpu", UnitsJson()) : UnitsJson();
    if (cpu.is_string()) return cpu.get<std::string>();
    if (cpu.is_object() && cpu.contains("name") && cpu["name"].is_string()) return cpu["name"];
    return "a processor that the store does not name";
}

std::vector<std::string> data_caches(const UnitsJson& machine) {
    std::vector<std::string> sizes;
    const UnitsJson caches = machine.is_object() ? machine.value("caches", UnitsJson()) : UnitsJson();
    if (!caches.is_array()) return sizes;
    for (const UnitsJson& cache : caches) {
        if (!cache.is_object() || !cache.contains("bytes") || !cache["bytes"].is_number()) continue;
        if (cache.contains("type") && cache["type"] == "Instruction") continue;
        sizes.push_back(size_text(cache["bytes"].get<double>()));
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

std::string size_text(double bytes) {
    if (bytes >= mebibyte) return number_text(std::round(bytes / mebibyte * 10) / 10) + " MiB";
    if (bytes >= kibibyte) return number_text(std::round(bytes / kibibyte * 10) / 10) + " KiB";
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

}  // namespace edgewise::reports
