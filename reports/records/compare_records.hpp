// SPDX-License-Identifier: MIT
//
// Which table wins on which machine, question by question. A table wins alone where its interval lies below
// every other's; else those whose intervals meet the best one's share the first place.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "edgewise/reports/records/machine_record.hpp"

namespace edgewise::reports {

/// First place on one machine.
struct FirstPlace {
    std::vector<std::string> tables;  ///< fastest first; more than one: not to be told from each other
    double ratio = 0;                 ///< of the fastest, to the record's baseline
};

struct ComparedQuestion {
    std::string question;
    std::vector<std::optional<FirstPlace>> machines;  ///< in the order of the records; null: not asked there
    /// Whether some table is first, alone or not, on every machine that was asked.
    std::vector<std::string> first_everywhere;
};

/// In the order of the first record, then of the others.
[[nodiscard]] std::vector<ComparedQuestion> compare_records(std::span<const measure::FigureRecord> records);

[[nodiscard]] std::string comparison_text(std::span<const measure::FigureRecord> records);
[[nodiscard]] nlohmann::ordered_json comparison_json(std::span<const measure::FigureRecord> records);

}  // namespace edgewise::reports
