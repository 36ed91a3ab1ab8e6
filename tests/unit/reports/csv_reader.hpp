// SPDX-License-Identifier: MIT
//
// Reads comma-separated values back, by RFC 4180, with the apostrophe that keeps spreadsheets from running a
// text taken off.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace edgewise::reports {

/// Returns the rows of a CSV text as fields, without their quotes.
inline std::vector<std::vector<std::string>> parse_csv(const std::string& csv) {
    std::vector<std::vector<std::string>> rows{{""}};
    bool quoted = false;
    for (std::size_t i = 0; i < csv.size(); ++i) {
        if (quoted && csv[i] == '"' && i + 1 < csv.size() && csv[i + 1] == '"')
            rows.back().back() += csv[i++];
        else if (csv[i] == '"')
            quoted = !quoted;
        else if (!quoted && csv[i] == ',')
            rows.back().emplace_back();
        else if (!quoted && csv[i] == '\r' && i + 1 < csv.size() && csv[i + 1] == '\n')
            rows.push_back({""}), ++i;
        else
            rows.back().back() += csv[i];
    }
    rows.pop_back();
    return rows;
}

/// A file with a header.
class CsvTable {
  public:
    explicit CsvTable(const std::string& csv) : rows_(parse_csv(csv)) {
        if (rows_.empty()) throw std::runtime_error("no header");
        for (const auto& row : rows_)
            if (row.size() != rows_[0].size()) throw std::runtime_error("rows differ in length");
    }

    [[nodiscard]] std::size_t rows() const { return rows_.size() - 1; }
    [[nodiscard]] const std::vector<std::string>& columns() const { return rows_[0]; }
    [[nodiscard]] bool has(const std::string& column) const {
        return std::count(rows_[0].begin(), rows_[0].end(), column) == 1;
    }
    /// Returns a field without changes; throws if the column is missing.
    [[nodiscard]] std::string raw(std::size_t row, const std::string& column) const {
        const auto found = std::find(rows_[0].begin(), rows_[0].end(), column);
        if (found == rows_[0].end()) throw std::runtime_error("no column " + column);
        return rows_.at(row + 1)[static_cast<std::size_t>(found - rows_[0].begin())];
    }
    [[nodiscard]] std::string text(std::size_t row, const std::string& column) const {
        std::string field = raw(row, column);
        return field.starts_with('\'') ? field.substr(1) : field;
    }
    /// Returns the first row that has `value` in `column`; throws if no row has it.
    [[nodiscard]] std::size_t where(const std::string& column, const std::string& value) const {
        for (std::size_t row = 0; row < rows(); ++row)
            if (text(row, column) == value) return row;
        throw std::runtime_error("no row with " + column + " " + value);
    }

  private:
    std::vector<std::vector<std::string>> rows_;
};

}  // namespace edgewise::reports
