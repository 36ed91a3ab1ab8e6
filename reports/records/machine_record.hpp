// SPDX-License-Identifier: MIT
//
// A machine's record, to be given to others: processor, caches, and time ratios of layouts with their
// intervals. It holds no absolute time, no name of a host, user or file, and nothing of bodies and scenes
// that do not come with Edgewise. Its cells are named "scene parameters shape algorithm table". Also
// compares records: which table wins on which machine, question by question, by the rule of the ranker
// (answer/ranking.hpp).
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/measure/cache/cache_machine.hpp"
#include "edgewise/measure/record/record.hpp"
#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

inline constexpr const char* machine_kind = "machine";
inline constexpr const char* ratio_figure = "time ratio";  ///< to the record's baseline

/// Throws std::runtime_error, one line, where nothing of the store was timed.
[[nodiscard]] measure::FigureRecord measured_record(const ReportData& data);

/// Returns the record of a machine with caches that the sweep modelled: modelled memory time over that of the
/// same algorithm on `modelled_baseline`. Throws std::runtime_error, one line, where the store has no such
/// figures.
[[nodiscard]] measure::FigureRecord modelled_record(const ReportData& data,
                                                    const measure::CacheMachine& machine);
inline constexpr std::string_view modelled_baseline = "aos_f64";

/// First place on one machine.
struct FirstPlace {
    std::vector<std::string> tables;  ///< fastest first; more than one: they tie
    double ratio = 0;                 ///< of the fastest, to the record's baseline
};

struct ComparedQuestion {
    std::string question;
    std::vector<std::optional<FirstPlace>> machines;  ///< in the order of the records; null: not asked there
    /// Tables that are first, alone or tied, on every machine that was asked.
    std::vector<std::string> first_everywhere;
};

/// Compares the records; questions in the order of the first record, then of the others.
[[nodiscard]] std::vector<ComparedQuestion> compare_records(std::span<const measure::FigureRecord> records);

[[nodiscard]] std::string comparison_text(std::span<const measure::FigureRecord> records);
[[nodiscard]] nlohmann::ordered_json comparison_json(std::span<const measure::FigureRecord> records);

}  // namespace edgewise::reports
