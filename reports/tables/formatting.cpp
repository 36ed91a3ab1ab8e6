// SPDX-License-Identifier: MIT
#include "edgewise/reports/tables/formatting.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <sstream>

#include "edgewise/input/shown_text.hpp"

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

/// FNV-1a.
std::string hash_of(const std::string& text) {
    std::uint32_t hash = 0x811c9dc5;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x01000193;
    return fmt::format("{:08x}", hash);
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

std::string replaced(const std::string& text, const std::map<char, const char*>& by) {
    std::string out;
    for (const char c : text) {
        const auto found = by.find(c);
        if (found == by.end())
            out += c;
        else
            out += found->second;
    }
    return out;
}

std::string html_text(const std::string& text) {
    return replaced(input::shown_text(text),
                    {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}});
}

std::string markdown_text(const std::string& text) {
    return replaced(input::shown_text(text), {{'|', "\\|"},
                                              {'\\', "\\\\"},
                                              {'`', "\\`"},
                                              {'*', "\\*"},
                                              {'[', "\\["},
                                              {']', "\\]"},
                                              {'&', "&amp;"},
                                              {'<', "&lt;"},
                                              {'>', "&gt;"},
                                              {'\n', " "},
                                              {'\r', " "}});
}

std::string in_words(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

void append(std::string& list, const std::string& part, const char* separator) {
    if (!list.empty()) list += separator;
    list += part;
}

std::size_t shown_width(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(  // continuation bytes take no column
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string wrapped(const std::string& text, std::size_t width, std::size_t indent) {
    std::istringstream words(text);
    std::string result;
    std::size_t used = 0;
    for (std::string word; words >> word;) {
        const std::size_t needed = shown_width(word);
        const bool fits = used > 0 && used + 1 + needed <= width;
        if (used > 0) result += fits ? " " : '\n' + std::string(indent, ' ');
        used = fits ? used + 1 + needed : needed;
        result += word;
    }
    return result;
}

std::string plural(std::size_t count, const std::string& noun, const std::string& many) {
    if (count != 1 && !many.empty()) return fmt::format("{} {}", count, many);
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string file_name_of(std::string name) {
    constexpr std::size_t longest = 100;
    const std::string hash = hash_of(name);
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-') c = '_';
    return name.size() <= longest ? name : name.substr(0, longest) + "-" + hash;
}

std::string file_name_of(const std::string& name, const std::set<std::string>& taken) {
    const std::string file = file_name_of(name);
    return taken.contains(file) ? file_name_of(file + "-" + hash_of(name)) : file;
}

}  // namespace edgewise::reports
