// SPDX-License-Identifier: MIT
#include "edgewise/reports/results/csv_row.hpp"

#include <fmt/core.h>

#include "edgewise/input/shown_text.hpp"

namespace edgewise::reports {

namespace {

/// What a spreadsheet would run, or what looks like our own mark.
bool needs_mark(std::string_view field) {
    return !field.empty() && std::string_view("=+-@\t\r\n'").find(field.front()) != std::string_view::npos;
}

std::string in_quotes(std::string_view field) {
    std::string out = "\"";
    for (const char c : field) {
        if (c == '"') out += '"';
        out += c;
    }
    return out + '"';
}

}  // namespace

void CsvRow::add(std::string_view field) {
    if (begun_) fields_ += ',';
    begun_ = true;
    fields_ += field;
}

CsvRow& CsvRow::text(std::string_view field) {
    const std::string shown = input::shown_text(field), safe = needs_mark(field) ? "'" + shown : shown;
    add(safe.find_first_of(",\"\r\n") == std::string::npos ? safe : in_quotes(safe));
    return *this;
}

CsvRow& CsvRow::number(std::optional<double> value) {
    add(value ? fmt::format("{}", *value) : "");
    return *this;
}

CsvRow& CsvRow::field(const nlohmann::ordered_json& value) {
    if (value.is_string()) return text(value.get_ref<const std::string&>());
    if (value.is_number_float()) return number(value.get<double>());
    add(value.is_null() ? "" : value.dump());
    return *this;
}

}  // namespace edgewise::reports
