// SPDX-License-Identifier: MIT
//
// The answer in sentences, without markup: for the page, Markdown, the end of a sweep and `edgewise advise`.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/answer/answer.hpp"

namespace edgewise::reports {

/// What to take, and what that rests on.
struct AdviceText {
    std::string lead, rest;
};

struct AnswerText {
    std::vector<AdviceText> advice;  ///< for a shared table, then for a table each, where these were measured
    std::string conditions;          ///< which bodies, which error, which machine
    std::string noise;               ///< which differences count as none, and what the intervals hold for
    std::string counts;              ///< cells verified and failed, figures not measured
};

[[nodiscard]] AnswerText answer_text(const Answer& answer, const ReportData& data);

/// All of it as one paragraph.
[[nodiscard]] std::string answer_paragraph(const Answer& answer, const ReportData& data);
/// That paragraph, and a line for the tie set of each scene.
[[nodiscard]] std::string terminal_text(const Answer& answer, const ReportData& data);

/// "keep V-Clip on aos_f64" and so on, of one group of scenes; null where none has a winner.
[[nodiscard]] std::optional<AdviceText> advice_of(const std::vector<SceneRanking>& scenes,
                                                  const Answer& answer);

/// Whether every planned cell is there: "1281 of 1281 planned cells verified, 0 failed", or that the sweep
/// was stopped and how many are missing.
[[nodiscard]] std::string cells_sentence(const Answer& answer);
/// "31213 of 171554 figures were not measured".
[[nodiscard]] std::string gaps_sentence(const Answer& answer);
/// The baseline's own variation in one scene: "0.2 %"; empty where it was not measured.
[[nodiscard]] std::string own_variation_text(const SceneRanking& scene);
/// The baseline's own variation, in the quietest scene and in the noisiest: "0.2 % (cold) to 19 %
/// (pressure)"; empty where it was not measured.
[[nodiscard]] std::string noise_text(const Answer& answer);

/// Explains the time of a cell next to another by steps, lines and the cost of a step.
[[nodiscard]] std::string why_sentence(const RankedCell& cell, const RankedCell& beside);

/// "1e-6"
[[nodiscard]] std::string limit_text(double limit);
/// "0.72 [0.69, 0.83]", with two decimals: more would promise what another process does not hold.
[[nodiscard]] std::string ratio_text(const RankedCell& cell);
/// The tie set of a scene as every output names it, the winner first: "alone: V-Clip on lean_f32 0.72 [0.70,
/// 0.74]", "2 tie: A 0.72 [0.70, 0.74]; B 0.75 [0.73, 0.77]", or that nothing is within the error.
[[nodiscard]] std::string tie_set_text(const SceneRanking& scene);
/// "5.8 MiB"
[[nodiscard]] std::string size_text(double bytes);
/// The processor's name, or that the store does not name it.
[[nodiscard]] std::string processor_text(const ReportData& data);
/// Processor, data caches and what the program was compiled for: "AMD EPYC, 32 KiB / 1 MiB / 32 MiB of cache,
/// compiled for this processor (-march=native)".
[[nodiscard]] std::string machine_text(const ReportData& data);

}  // namespace edgewise::reports
