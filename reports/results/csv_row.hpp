// SPDX-License-Identifier: MIT
//
// One row of comma-separated values, by RFC 4180. Spreadsheets take a text that begins with = + - or @ for a
// formula and run it, so such a text gets an apostrophe before it, as OWASP's page on CSV injection says; one
// that begins with an apostrophe gets another, so that whoever reads back takes one off and has the text.
// Numbers are never touched: they are the shortest text that reads back as the same double.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

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

}  // namespace edgewise::reports
