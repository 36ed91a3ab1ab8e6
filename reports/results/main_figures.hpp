// SPDX-License-Identifier: MIT
//
// Which figures are a cell's main ones: those of the vocabulary that are one figure, not a family with one
// for each structure, field, step or size; and of families over machines, misses and the time of memory.
// Breakdowns stay in the store; `edgewise export` writes them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

/// "time.all_ns": as the vocabulary, patterns of `edgewise export` and headers have it.
[[nodiscard]] inline std::string figure_key(const store::FigureRow& figure) {
    return figure.probe + "." + figure.name;
}

/// Its place in the vocabulary, by which columns are ordered; null: it is a breakdown.
[[nodiscard]] std::optional<std::size_t> main_place(const std::string& key);

/// What the vocabulary says of a main figure; null: it is none.
[[nodiscard]] const store::FigureInfo* main_info(const std::string& key);

/// All cells of a store, whatever run they are of, in the order of the report.
[[nodiscard]] std::vector<const ReportCell*> every_cell(const ReportData& data);

}  // namespace edgewise::reports
