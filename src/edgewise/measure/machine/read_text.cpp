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
#include <string_view>

namespace edgewise::measure {

Expected<std::string> read_text(const std::filesystem::path& file) {
    errno = 0;
    std::ifstream stream(file);
    if (!stream) return Refusal{fmt::format("{}: {}", file.string(), std::strerror(errno))};
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    const auto end = text.find_last_not_of(" \t\r\n");
    text.erase(end == std::string::npos ? 0 : end + 1);
    if (text.empty()) return Refusal{fmt::format("{}: empty", file.string())};
    return {std::move(text)};
}

Expected<std::int64_t> read_number(const std::filesystem::path& file) {
    const Expected<std::string> text = read_text(file);
    if (!text.value) return text.refusal();
    const auto number = parse_number(*text.value);
    if (!number) return Refusal{fmt::format("{}: not a number: {}", file.string(), *text.value)};
    return {number};
}

std::optional<std::int64_t> parse_number(std::string text) {
    if (text.empty()) return std::nullopt;
    const auto unit = std::string_view("KMG").find(text.back());
    const std::int64_t factor = unit < 3 ? std::int64_t{1024} << 10 * unit : 1;
    if (factor > 1) text.pop_back();
    const bool hexadecimal = text.starts_with("0x");
    const char* const begin = text.data() + (hexadecimal ? 2 : 0);
    const char* const end = text.data() + text.size();
    std::int64_t value = 0;
    const auto [rest, error] = std::from_chars(begin, end, value, hexadecimal ? 16 : 10);
    if (error != std::errc{} || rest != end) return std::nullopt;
    return value * factor;
}

}  // namespace edgewise::measure
