// SPDX-License-Identifier: MIT
//
// The answer as JSON, under the keys of `edgewise advise`: asked, take, next, dropped, changes_it, held,
// command.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "edgewise/reports/answer/answer.hpp"

namespace edgewise::reports {

/// Returns the answer as JSON. "take" is for the tables in question; if the question allows both kinds, for a
/// shared table if such scenes were measured, and "own_tables" says so. "next": tied cells, then slower ones;
/// "dropped": cells over the error limit; "changes_it": empty, since it takes answers at other limits;
/// "held": null, since nothing was predicted here. "scenes": every scene with its ranked cells. Numbers that
/// were not measured are null.
[[nodiscard]] nlohmann::json answer_json(const Answer& answer);

/// Returns algorithm, table, ns, time_ratio [low, mid, high], bytes_per_edge, lines_per_query, error.
[[nodiscard]] nlohmann::json ranked_json(const RankedCell& cell);

/// Returns the `edgewise advise` command of this question; for one kind of tables if `own_tables` is given.
[[nodiscard]] std::string advise_command(const Answer& answer, std::optional<bool> own_tables = {});

}  // namespace edgewise::reports
