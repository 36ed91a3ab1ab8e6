// SPDX-License-Identifier: MIT
#include "edgewise/bench/draw_heat.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace edgewise::bench {

namespace {

constexpr std::size_t lines_a_row = 64;  ///< a row is a page of 4 KiB
constexpr int cell = 10, left = 8, top = 40;

/// From near white to dark red, by the logarithm of the part of the most.
std::string colour(std::uint32_t accesses, std::uint32_t most) {
    if (accesses == 0) return "#ffffff";
    const double part = most > 1 ? std::log(accesses) / std::log(most) : 1;
    const auto fade = [&](double from, double to) { return static_cast<int>(from + part * (to - from)); };
    return fmt::format("#{:02x}{:02x}{:02x}", fade(254, 103), fade(224, 0), fade(210, 13));
}

}  // namespace

std::string draw_heat(const std::string& title, std::span<const std::uint32_t> accesses,
                      std::size_t most_lines) {
    const std::size_t lines = std::min(accesses.size(), most_lines);
    const std::uint32_t most = accesses.empty() ? 0 : *std::max_element(accesses.begin(), accesses.end());
    std::string body;
    for (std::size_t line = 0; line < lines; ++line) {
        body += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n",
                            left + static_cast<int>(line % lines_a_row) * cell,
                            top + static_cast<int>(line / lines_a_row) * cell, cell - 1, cell - 1,
                            colour(accesses[line], most));
    }
    const int rows = static_cast<int>((lines + lines_a_row - 1) / lines_a_row);
    const std::string cut = lines < accesses.size()
                                ? fmt::format("; the first {} of {} lines", lines, accesses.size())
                                : std::string();
    const int width = 2 * left + static_cast<int>(lines_a_row) * cell;
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
        "font-family=\"sans-serif\" font-size=\"11\">\n<title>{2}</title>\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"#e8e8e8\"/>\n"
        "<text x=\"{3}\" y=\"14\" font-weight=\"bold\">{2}</text>\n"
        "<text x=\"{3}\" y=\"30\">a square is a line of 64 bytes, a row a page; white: never; dark: up to "
        "{4} "
        "accesses{5}</text>\n{6}</svg>\n",
        width, top + rows * cell + left, title, left, most, cut, body);
}

}  // namespace edgewise::bench
