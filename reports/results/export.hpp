// SPDX-License-Identifier: MIT
//
// Figures of a store that a user chooses, in long form: one row per cell and figure, breakdowns included.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

enum class ExportFormat { csv, json };

struct ExportChoice {
    /// Patterns for PROBE.NAME, with * and ? as in a shell (fnmatch); none: the main figures.
    std::vector<std::string> figures = {};
    std::vector<std::string> scenes = {};   ///< by name; none: all
    std::vector<std::string> layouts = {};  ///< layouts or table types; none: all
    ExportFormat format = ExportFormat::csv;
};

/// Returns the cells that the choice names. Throws as export_text does.
[[nodiscard]] std::vector<const ReportCell*> chosen_cells(const ReportData& data, const ExportChoice& choice);

/// CSV: the columns that name the cell, then probe, figure, state ("measured" or "not measured"), value,
/// unit, reason, remedy. JSON: {"cells": [{...the same names..., "figures": [{"figure", "value", "unit",
/// "reason", "remedy"}]}]}, in which a value that was not measured is null and only such a one has a reason.
/// A chosen cell without any chosen figure has one row, without a value. Throws std::runtime_error with one
/// line where a scene or a layout is not in the store, or a pattern matches nothing in the chosen cells.
[[nodiscard]] std::string export_text(const ReportData& data, const ExportChoice& choice);

// The results as files that a reader can open: one per scene, one row per cell, its main figures as columns.
// Files in the folder about/ say what a column is and why a field is empty. Breakdowns stay in the store.

/// Returns the text of each file by its name, relative to the folder of results:
/// SCENE.csv: a row per cell of that scene, stability, paging and effort rows likewise; columns that name the
/// cell, then every main figure that any row has, as PROBE.NAME; a field is empty if it was not measured.
/// about/columns.csv: figure, unit, population, repeats, meaning.
/// about/not_measured.csv: per file and figure, how many cells lack it, why, and what would help.
[[nodiscard]] std::map<std::string, std::string> wide_results(const ReportData& data);

/// Writes them into out/results; CSV files of an earlier report there are removed.
void write_results(const ReportData& data, const std::filesystem::path& out);

// Which figures are a cell's main ones: those of the vocabulary that are one figure, not a family with one
// for each structure, field, step or size; and of families over machines, misses and the time of memory.
// Breakdowns stay in the store; `edgewise export` writes them. Also defines the columns that name a cell in
// files of results.
//
// One row of comma-separated values, by RFC 4180. Spreadsheets take a text that begins with = + - or @ for a
// formula and run it, so such a text gets an apostrophe before it, as OWASP's page on CSV injection says; one
// that begins with an apostrophe gets another, so that whoever reads back takes one off and has the text.
// Numbers are never touched: they are the shortest text that reads back as the same double.

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

/// Adds the names of the columns that name a cell.
void add_identity_header(CsvRow& row);
/// Adds the values of a cell in the columns of add_identity_header.
void add_identity(CsvRow& row, const ReportData& data, const ReportCell& cell);
/// Returns the columns that name a cell as members of an object, in their order.
[[nodiscard]] nlohmann::ordered_json identity_json(const ReportData& data, const ReportCell& cell);

}  // namespace edgewise::reports
