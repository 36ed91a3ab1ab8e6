// SPDX-License-Identifier: MIT
//
// Readers of /proc and /sys; such files have no size, so they are read to their end.
#include "edgewise/measure/machine/read_text.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>

namespace edgewise::measure {

namespace {

/// 1024-based factor of a unit letter; 0 for what is none.
std::int64_t unit_factor(char unit) {
    switch (unit) {
        case 'K':
            return std::int64_t{1} << 10;
        case 'M':
            return std::int64_t{1} << 20;
        case 'G':
            return std::int64_t{1} << 30;
        default:
            return 0;
    }
}

}  // namespace

Expected<std::string> read_text(const std::filesystem::path& file) {
    errno = 0;
    std::ifstream stream(file);
    if (!stream)
        return Expected<std::string>::none(fmt::format("{}: {}", file.string(), std::strerror(errno)));
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    const auto end = text.find_last_not_of(" \t\r\n");
    text.erase(end == std::string::npos ? 0 : end + 1);
    if (text.empty()) return Expected<std::string>::none(fmt::format("{}: empty", file.string()));
    return {std::move(text)};
}

Expected<std::int64_t> read_number(const std::filesystem::path& file) {
    const Expected<std::string> text = read_text(file);
    if (!text.value) return Expected<std::int64_t>::none(text.reason);
    const auto number = parse_number(*text.value);
    if (!number) {
        return Expected<std::int64_t>::none(fmt::format("{}: not a number: {}", file.string(), *text.value));
    }
    return {number};
}

std::optional<std::int64_t> parse_number(std::string text) {
    if (text.empty()) return std::nullopt;
    const std::int64_t factor = unit_factor(text.back());
    if (factor != 0) text.pop_back();
    const bool hexadecimal = text.starts_with("0x");
    const char* const begin = text.data() + (hexadecimal ? 2 : 0);
    const char* const end = text.data() + text.size();
    std::int64_t value = 0;
    const auto [rest, error] = std::from_chars(begin, end, value, hexadecimal ? 16 : 10);
    if (error != std::errc{} || rest != end) return std::nullopt;
    return factor != 0 ? value * factor : value;
}

}  // namespace edgewise::measure
