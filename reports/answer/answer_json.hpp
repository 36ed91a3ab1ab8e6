// SPDX-License-Identifier: MIT
//
// The answer as JSON, under the keys of `edgewise advise`: asked, take, next, dropped, changes_it, held,
// command.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "edgewise/reports/answer/answer.hpp"

namespace edgewise::reports {

/// "take" is for the tables asked about; where both were asked, for a shared table if scenes of it were
/// measured, and "own_tables" says so. "next" are the others that tie, then those that follow; "dropped"
/// those over the error limit; "changes_it" sentences; "held" is null: no prediction stands beside the
/// measurement here. "scenes" has every scene with its ranked cells. Numbers that were not measured are null.
[[nodiscard]] nlohmann::json answer_json(const Answer& answer);

/// algorithm, table, ns, time_ratio [low, mid, high], bytes_per_edge, lines_per_query, error.
[[nodiscard]] nlohmann::json ranked_json(const RankedCell& cell);

/// What would change the answer of `scenes`: another error limit, or the other kind of tables.
[[nodiscard]] std::vector<std::string> what_changes_it(const Answer& answer,
                                                       const std::vector<SceneRanking>& scenes);

/// `edgewise advise` with the options that ask the same; for one kind of tables where it is given.
[[nodiscard]] std::string advise_command(const Answer& answer, std::optional<bool> own_tables = {});

}  // namespace edgewise::reports
