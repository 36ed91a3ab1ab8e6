// SPDX-License-Identifier: MIT
//
// One sentence with figures for each chapter's question, from the store; empty if the store has none of the
// figures.
#pragma once

#include <string>

#include "edgewise/reports/answer/answer.hpp"

namespace edgewise::reports {

/// How much of the largest table is what, and what the smallest takes.
[[nodiscard]] std::string bytes_sentence(const ReportData& data);
/// Lines of a query and the cache below which a scene thrashes: of the baseline and of the fewest.
[[nodiscard]] std::string misses_sentence(const ReportData& data);
/// What V-Clip's table costs to build and to refit: of the baseline and of the fewest lines per query.
[[nodiscard]] std::string layouts_sentence(const ReportData& data);
/// How time grows from the smallest to the largest built-in body.
[[nodiscard]] std::string times_sentence(const Answer& answer, const ReportData& data);
/// How many cells are on a front of time and error.
[[nodiscard]] std::string fronts_sentence(const ReportData& data);
/// Cases, wrong verdicts outside the band, differing ones inside.
[[nodiscard]] std::string stability_sentence(const ReportData& data);
/// Compares the fastest other library with the fastest cell of ours.
[[nodiscard]] std::string peers_sentence(const Answer& answer);
/// How often the replacement policy changes a ranking by misses.
[[nodiscard]] std::string policy_sentence(const ReportData& data);

}  // namespace edgewise::reports
