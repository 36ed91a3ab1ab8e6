// SPDX-License-Identifier: MIT
//
// Which figures are a cell's main ones: those of the vocabulary that are one figure, not a family with one
// for each structure, field, step or size; and of families over machines, misses and the time of memory.
// Breakdowns stay in the store; `edgewise export` writes them. Also defines the columns that name a cell in
// files of results.
//
// One row of comma-separated values, by RFC 4180. Spreadsheets take a text that begins with = + - or @ for a
// formula and run it, so such a text gets an apostrophe before it, as OWASP's page on CSV injection says; one
// that begins with an apostrophe gets another, so that whoever reads back takes one off and has the text.
// Numbers are never touched: they are the shortest text that reads back as the same double.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

class CsvRow {
  public:
    CsvRow& text(std::string_view field);
    /// Null: an empty field.
    CsvRow& number(std::optional<double> value);
    /// A text or a number as above, whole numbers with all their digits; null: an empty field.
    CsvRow& field(const nlohmann::ordered_json& value);

    /// Returns the row as a line that ends with CR and LF.
    [[nodiscard]] std::string line() const { return fields_ + "\r\n"; }

  private:
    void add(std::string_view field);

    std::string fields_;
    bool begun_ = false;
};

/// "time.all_ns": as the vocabulary, patterns of `edgewise export` and headers have it.
[[nodiscard]] inline std::string figure_key(const store::FigureRow& figure) {
    return figure.probe + "." + figure.name;
}

/// Returns the place of a figure in the vocabulary, by which columns are ordered; null for a breakdown.
[[nodiscard]] std::optional<std::size_t> main_place(const std::string& key);

/// Returns the entry of a main figure in the vocabulary; null if the figure is not a main one.
[[nodiscard]] const store::FigureInfo* main_info(const std::string& key);

/// All cells of a store, whatever run they are of, in the order of the report.
[[nodiscard]] std::vector<const ReportCell*> every_cell(const ReportData& data);

/// Adds the names of the columns that name a cell.
void add_identity_header(CsvRow& row);
/// Adds the values of a cell in the columns of add_identity_header.
void add_identity(CsvRow& row, const ReportData& data, const ReportCell& cell);
/// Returns the columns that name a cell as members of an object, in their order.
[[nodiscard]] nlohmann::ordered_json identity_json(const ReportData& data, const ReportCell& cell);

}  // namespace edgewise::reports
