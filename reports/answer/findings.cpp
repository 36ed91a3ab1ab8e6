// SPDX-License-Identifier: MIT
#include "edgewise/reports/answer/answer_text.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "edgewise/reports/answer/answer_json.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

constexpr std::size_t gaps_named = 3;

double percent_less(double now, double before) { return 100 * (1 - now / before); }

/// Returns how much time and bytes the choice saves in one scene; empty if it is the baseline itself.
std::string saving_of(const SceneRanking& scene) {
    const RankedCell *choice = scene.choice(), *baseline = scene.baseline();
    if (!choice || !baseline || choice == baseline || !scene.recommends()) return {};
    std::string saved;
    if (scene.beats_baseline) saved = fmt::format("{:.0f} % of the time", percent_less(choice->ratio, 1));
    if (choice->scene_bytes && baseline->scene_bytes && *choice->scene_bytes < *baseline->scene_bytes)
        append(saved, fmt::format("{} of {}", size_text(*baseline->scene_bytes - *choice->scene_bytes),
                                  size_text(*baseline->scene_bytes)));
    if (saved.empty()) return {};
    return fmt::format("{} instead of the paper's layout in {} saves {} ({}).", choice->name(), scene.label,
                       saved, why_sentence(*choice, *baseline));
}

/// Returns how much a finding saves; findings are ordered by it.
double weight_of(const SceneRanking& scene) {
    const RankedCell* choice = scene.choice();
    return choice ? (scene.beats_baseline ? 1 - choice->ratio : 0) : -1;
}

std::string gap_text(const Gap& gap) {
    std::string probes;
    for (const std::string& probe : gap.probes) append(probes, probe);
    return fmt::format("{} of {} were not measured: {}{}", plural(gap.figures, "figure"), probes, gap.reason,
                       gap.remedy.empty() ? "." : " – " + gap.remedy + ".");
}

}  // namespace

std::vector<std::string> what_to_look_at(const Answer& answer) {
    std::vector<const SceneRanking*> scenes = answer.scenes();
    std::ranges::stable_sort(
        scenes, [](const SceneRanking* a, const SceneRanking* b) { return weight_of(*a) > weight_of(*b); });
    std::vector<std::string> findings;
    for (const SceneRanking* scene : scenes)
        if (std::string saving = saving_of(*scene); !saving.empty()) findings.push_back(std::move(saving));
    if (findings.size() > 4) findings.resize(4);
    const auto& asked = answer.shared.empty() ? answer.own : answer.shared;
    if (!asked.empty())
        for (const std::string& change : what_changes_it(answer, asked))
            findings.push_back("It would change with " + change + ".");
    for (std::size_t i = 0; i < std::min(gaps_named, answer.gaps.gaps.size()); ++i)
        findings.push_back(gap_text(answer.gaps.gaps[i]));
    return findings;
}

std::vector<std::string> what_passed(const Answer& answer) {
    const CellCounts& counts = answer.counts;
    std::vector<std::string> passed;
    if (counts.verified > 0)
        passed.push_back(
            fmt::format("{} gave the right answers to every checked query, compared with exact "
                        "arithmetic, before they were timed.",
                        plural(counts.verified, "cell")));
    if (counts.stability_rows > counts.stability_failed)
        passed.push_back(
            fmt::format("{} of hard pairs (parallel faces, needles, far offsets, bad starts): no "
                        "wrong verdict outside the band where rounding decides.",
                        plural(counts.stability_rows - counts.stability_failed, "row")));
    if (const std::string noise = noise_text(answer); !noise.empty())
        passed.push_back(fmt::format("The baseline was timed against itself: {}.", noise));
    return passed;
}

}  // namespace edgewise::reports
