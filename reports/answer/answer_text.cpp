// SPDX-License-Identifier: MIT
#include "edgewise/reports/answer/answer_text.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "edgewise/reports/answer/answer_json.hpp"
#include "edgewise/reports/answer/contest.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

/// Smallest and largest of what some scenes have.
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

/// "139 bytes per edge instead of 234, worst error 2e-7"
std::string costs(const Take& take) {
    const Candidate& candidate = take.example();
    const Candidate* baseline = take.places.front().scene->baseline();
    std::string text;
    if (candidate.bytes_per_edge) {
        text = number_text(*candidate.bytes_per_edge, "B/edge") + " bytes per edge";
        if (baseline && baseline->bytes_per_edge && baseline->bytes_per_edge != candidate.bytes_per_edge)
            text += " instead of " + number_text(*baseline->bytes_per_edge, "B/edge");
    }
    if (take.worst_error) append(text, "worst error " + number_text(*take.worst_error, "scale"));
    return text;
}

/// How the best GJK does beside the choice, over the scenes of the take.
std::string gjk_sentence(const Take& take) {
    if (take.algorithm == "gjk") return {};
    Range range;
    for (const Take::Place& place : take.places) {
        const Candidate* gjk = place.scene->best("gjk");
        if (gjk && place.candidate) range.add(gjk->ratio / place.candidate->ratio);
    }
    if (!range.low) return " No GJK is within the error.";
    return fmt::format(" The best GJK within the error takes {} times as long.", range.text());
}

/// "600 tables take 5.8 MiB instead of 154 MiB"
std::string memory_sentence(const Take& take) {
    const Candidate* most = nullptr;
    const Candidate* beside = nullptr;
    for (const Take::Place& place : take.places) {
        if (!place.ties || !place.candidate->scene_bytes || !place.candidate->tables) continue;
        if (most && *place.candidate->tables <= *most->tables) continue;
        most = place.candidate, beside = place.scene->baseline();
    }
    if (!most || *most->tables < 2) return {};
    std::string text = fmt::format(" {:.0f} tables take {}", *most->tables, size_text(*most->scene_bytes));
    if (beside && beside != most && beside->scene_bytes)
        text += fmt::format(" instead of {}", size_text(*beside->scene_bytes));
    return text + ".";
}

/// Scenes where something else wins.
std::string exceptions(const Take& take) {
    std::string text;
    for (const Take::Place& place : take.places) {
        const Candidate& winner = *place.scene->winner();
        if (place.ties || !place.scene->beats_baseline) continue;
        const std::string against =
            place.candidate ? fmt::format(" and this one {}", ratio_text(*place.candidate)) : "";
        append(
            text,
            fmt::format("{}: {} takes {}{}", place.scene->label, winner.name(), ratio_text(winner), against),
            "; ");
    }
    return text.empty() ? text : " Elsewhere: " + text + ".";
}

/// Scenes in which the winner's own interval tells next to nothing.
std::string noisy_sentence(const std::vector<SceneAnswer>& scenes) {
    std::string names;
    for (const SceneAnswer& scene : scenes)
        if (scene.too_noisy) append(names, scene.label);
    if (names.empty()) return names;
    return fmt::format(
        " Too noisy to choose by, the winner's interval spans more than a factor of 2: {}. "
        "Measure these again on a machine with nothing else to do.",
        names);
}

std::string scene_count(std::size_t count) { return plural(count, "scene"); }

/// Where the choice beats the baseline, by how much; where not, that nothing does.
std::string ratios_sentence(const Take& take) {
    Range faster;
    std::size_t wins = 0, tied = 0;
    const Candidate* only = nullptr;
    for (const Take::Place& place : take.places) {
        if (!place.ties) continue;
        if (!place.scene->beats_baseline) {
            ++tied;
            continue;
        }
        ++wins, only = place.candidate;
        faster.add(place.candidate->ratio);
    }
    if (wins == 0) return {};
    std::string text = fmt::format(" A query takes {} of the time of the paper's layout",
                                   wins == 1 ? ratio_text(*only) : faster.text());
    if (wins > 1 || tied > 0) text += fmt::format(" in {}", scene_count(wins));
    if (tied > 0) text += fmt::format(", and what it takes there to within noise in {}", scene_count(tied));
    return text + ".";
}

AdviceText keep_baseline(const Take& take, const Answer& answer, bool own_tables) {
    const std::string scenes = plural(take.places.size(), "scene");
    const std::string paper = fmt::format("{} on the paper's layout ({})",
                                          algorithm_title(answer.baseline.algorithm), answer.baseline.table);
    if (take.is(answer.baseline))
        return {fmt::format("{}, keep {}.", condition_of(own_tables), paper),
                fmt::format("Nothing beats it by more than noise in {}.", scenes)};
    const Candidate& chosen = take.example();
    return {fmt::format("{}, nothing beats the paper's layout ({} on {}): take {}.", condition_of(own_tables),
                        algorithm_title(answer.baseline.algorithm), answer.baseline.table, chosen.name()),
            fmt::format("It ties in {} of {} and is the smallest that does: {}.",
                        std::count_if(take.places.begin(), take.places.end(),
                                      [](const Take::Place& place) { return place.ties; }),
                        scenes, costs(take))};
}

AdviceText take_winner(const Take& take, bool own_tables) {
    const std::string cost = costs(take);
    return {fmt::format("{}, take {}.", condition_of(own_tables), take.example().name()),
            (cost.empty() ? "" : "It has " + cost + ".") + ratios_sentence(take)};
}

/// What was not measured in scenes that therefore recommend nothing, and how to measure it.
std::string missing_sentence(const std::vector<SceneAnswer>& scenes, const Answer& answer) {
    std::string missing;
    for (const SceneAnswer& scene : scenes) {
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

std::optional<AdviceText> advice_of(const std::vector<SceneAnswer>& scenes, const Answer& answer) {
    const std::optional<Take> take = take_of(scenes);
    const std::string missing = missing_sentence(scenes, answer);
    if (!take && missing.empty()) return std::nullopt;
    const bool own_tables = scenes.front().own_tables;
    if (!take) return AdviceText{condition_of(own_tables) + ", nothing is recommended.", missing};
    if (std::all_of(take->places.begin(), take->places.end(),
                    [](const Take::Place& place) { return place.scene->too_noisy; }))
        return AdviceText{condition_of(own_tables) + ", these times are too noisy to choose by.",
                          noisy_sentence(scenes).substr(1)};
    AdviceText text = take->beats_baseline_somewhere() ? take_winner(*take, own_tables)
                                                       : keep_baseline(*take, answer, own_tables);
    if (own_tables) text.rest += memory_sentence(*take);
    text.rest += noisy_sentence(scenes) + exceptions(*take) + gjk_sentence(*take);
    if (!missing.empty()) text.rest += " Of other scenes nothing is recommended. " + missing;
    return text;
}

std::string noise_text(const Answer& answer) {
    const SceneAnswer *quietest = nullptr, *noisiest = nullptr;
    for (const SceneAnswer* scene : answer.scenes()) {
        if (!scene->noise.factor) continue;
        if (!quietest || scene->noise.high() < quietest->noise.high()) quietest = scene;
        if (!noisiest || scene->noise.high() > noisiest->noise.high()) noisiest = scene;
    }
    if (!quietest) return {};
    const auto text = [](const SceneAnswer& scene) {
        const double percent = (scene.noise.high() - 1) * 100;
        return fmt::format("{:.{}f} % ({})", percent, percent < 9.95 ? 1 : 0, scene.label);
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

std::string why_sentence(const Candidate& candidate, const Candidate& beside) {
    const auto both = [](const std::optional<double>& one, const std::optional<double>& other,
                         const char* what) {
        if (!one || !other) return fmt::format("{} not measured", what);
        return fmt::format("{} {} against {}", number_text(*one), what, number_text(*other));
    };
    const auto of_step = [](const Candidate& one) -> std::optional<double> {
        if (!one.steps || !(*one.steps > 0)) return std::nullopt;
        return one.ns / *one.steps;
    };
    return fmt::format("{}, {}, {}", both(candidate.steps, beside.steps, "steps per query"),
                       both(candidate.lines_per_query, beside.lines_per_query, "lines per query"),
                       both(of_step(candidate), of_step(beside), "ns per step"));
}

AnswerText answer_text(const Answer& answer, const ReportData& data) {
    AnswerText text;
    for (const auto* scenes : {&answer.shared, &answer.own})
        if (auto advice = advice_of(*scenes, answer)) text.advice.push_back(std::move(*advice));
    if (text.advice.empty())
        text.advice.push_back(
            {"No cell of this store answers the question.",
             "It takes cells that were timed beside the baseline and whose errors are known."});
    text.conditions = conditions_of(answer, data);
    const std::string noise = noise_text(answer);
    text.noise =
        noise.empty()
            ? "What a cell timed against itself differs by was not measured: the baseline is not among "
              "the cells."
            : fmt::format(
                  "The baseline timed against itself differs by {}. In each scene, a smaller "
                  "difference than that scene's counts as none. "
                  "Intervals are over the rounds of one process.",
                  noise);
    text.counts = cells_sentence(answer) + " " + gaps_sentence(answer);
    if (any_unfinished(answer.runs)) text.counts = unfinished_sentence(answer) + " " + text.counts;
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

}  // namespace edgewise::reports
