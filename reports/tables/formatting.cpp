// SPDX-License-Identifier: MIT
//
// See formatting.hpp.
#include "edgewise/reports/tables/formatting.hpp"

#include <fmt/core.h>

#include <cmath>

namespace edgewise::reports {

namespace {

bool is_count(const std::string& unit) { return unit == "B" || unit == "queries" || unit == "rounds"; }

/// "168.00" -> "168", "84.50" -> "84.5"
std::string without_trailing_zeros(std::string text) {
    if (text.find('.') == std::string::npos) return text;
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

}  // namespace

std::string number_text(double value, const std::string& unit) {
    const double size = std::abs(value);
    if (value == 0) return "0";
    if (unit == "scale" || size < 1e-3 || size >= 1e15) return fmt::format("{:.1e}", value);
    const bool whole = value == std::floor(value);
    if (whole || (is_count(unit) && size >= 100)) return fmt::format("{:.0f}", value);
    if (unit == "B/edge") return without_trailing_zeros(fmt::format("{:.2f}", value));
    if (size >= 1000) return fmt::format("{:.0f}", value);
    if (size >= 100) return fmt::format("{:.1f}", value);
    if (size >= 1) return fmt::format("{:.2f}", value);
    return fmt::format("{:.3f}", value);
}

std::string html_text(const std::string& text) {
    std::string safe;
    safe.reserve(text.size());
    for (const char c : text) {
        if (c == '&')
            safe += "&amp;";
        else if (c == '<')
            safe += "&lt;";
        else if (c == '>')
            safe += "&gt;";
        else if (c == '"')
            safe += "&quot;";
        else if (c == '\'')
            safe += "&#39;";
        else
            safe += c;
    }
    return safe;
}

std::string markdown_text(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '|' || c == '\\' || c == '`' || c == '*' || c == '[' || c == ']')
            (safe += '\\') += c;
        else if (c == '<')
            safe += "&lt;";
        else
            safe += c == '\n' || c == '\r' ? ' ' : c;
    }
    return safe;
}

std::string plural(std::size_t count, const std::string& noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace edgewise::reports
