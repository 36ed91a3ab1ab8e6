// SPDX-License-Identifier: MIT
//
// The answer in sentences, without markup, and as JSON: for the page, Markdown, the end of a sweep and
// `edgewise advise`.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "edgewise/reports/answer/answer.hpp"

namespace edgewise::reports {

struct AnswerText {
    std::string conditions;  ///< which error, which machine
    std::string noise;       ///< which differences count as none, and what the intervals hold for
    std::string counts;      ///< cells verified and failed, figures not measured
};

[[nodiscard]] AnswerText answer_text(const Answer& answer, const ReportData& data);

/// Returns the decision table, what would change it, these sentences, and a line for the tie set of each
/// scene.
[[nodiscard]] std::string terminal_text(const Answer& answer, const ReportData& data);

/// Returns "31213 of 171554 figures were not measured".
[[nodiscard]] std::string gaps_sentence(const Answer& answer);
/// Returns the baseline's own variation in one scene, "0.2 %"; empty if it was not measured.
[[nodiscard]] std::string own_variation_text(const SceneRanking& scene);
/// Returns the baseline's own variation in the quietest and in the noisiest scene, "0.2 % (cold) to 19 %
/// (pressure)"; empty if it was not measured.
[[nodiscard]] std::string noise_text(const Answer& answer);

/// Explains the time of a cell next to another by steps, lines and the cost of a step.
[[nodiscard]] std::string why_sentence(const RankedCell& cell, const RankedCell& beside);

/// Returns "1e-6".
[[nodiscard]] std::string limit_text(double limit);
/// Returns "0.72 [0.69, 0.83]"; two decimals, because a further one would not repeat in another process.
[[nodiscard]] std::string ratio_text(const RankedCell& cell);
/// Returns the tie set of a scene, the winner first, as every output: "alone: V-Clip on lean_f32 0.72 [0.70,
/// 0.74]", "2 tie: A 0.72 [0.70, 0.74]; B 0.75 [0.73, 0.77]", or that nothing is known to be within the
/// error.
[[nodiscard]] std::string tie_set_text(const SceneRanking& scene);
/// Returns the bytes of all tables of the cell's scene, "5.8 MiB in 200 tables".
[[nodiscard]] std::string scene_bytes_text(const RankedCell& cell);
/// Returns "5.8 MiB".
[[nodiscard]] std::string size_text(double bytes);
/// Returns the processor's name, or says that the store does not name it.
[[nodiscard]] std::string processor_text(const ReportData& data);
/// Returns processor, data caches and compiler target: "AMD EPYC, 32 KiB / 1 MiB / 32 MiB of cache,
/// compiled for this processor (-march=native)".
[[nodiscard]] std::string machine_text(const ReportData& data);

[[nodiscard]] std::vector<std::string> what_passed(const Answer& answer);

/// Returns the answer as JSON, with the keys of `edgewise advise`. "take" is for the tables in question; if
/// the question allows both kinds, for a shared table if such scenes were measured, and "own_tables" says so;
/// "too_noisy" says why it is no more than the fastest seen ("": it is recommended). "next": tied cells, then
/// slower ones; "dropped": cells over the error limit; "changes_it": empty, since it takes answers at other
/// limits; "held": null, since nothing was predicted here. "scenes": every scene with its ranked cells.
/// Numbers not measured are null.
[[nodiscard]] nlohmann::json answer_json(const Answer& answer);

/// Returns the `edgewise advise` that measures what this question asks for; for one kind of tables if
/// `own_tables` is given.
[[nodiscard]] std::string measuring_command(const Answer& answer, std::optional<bool> own_tables = {});

}  // namespace edgewise::reports
