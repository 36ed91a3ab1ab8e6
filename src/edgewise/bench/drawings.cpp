// SPDX-License-Identifier: MIT
#include "edgewise/bench/drawings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "edgewise/bench/memory/arena.hpp"
#include "edgewise/input/shown_text.hpp"
#include "edgewise/layout_parts/block.hpp"
#include "edgewise/store/palette.hpp"
#include "edgewise/table/table_memory.hpp"

namespace edgewise::bench {
namespace {

constexpr std::size_t line_bytes = BlockPlan::alignment;
constexpr std::size_t lines_per_column = 48;
constexpr int byte_width = 4, line_height = 9;
constexpr int column_width = 64 * byte_width + 24;
constexpr int left_margin = 8, top_margin = 44;

constexpr std::size_t lines_per_row = 64;  ///< of heat: a row is a page of 4 KiB
constexpr int heat_cell = 10, heat_top = 40;

std::string xml_text(const std::string& text) {
    std::string escaped;
    for (const char c : input::shown_line(text))
        escaped += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
    return escaped;
}

std::string svg_start(int width, int height, const std::string& title) {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
        "font-family=\"sans-serif\" font-size=\"11\">\n<title>{2}</title>\n",
        width, height, title);
}

std::string cut_text(std::size_t drawn, std::size_t lines) {
    return drawn < lines ? fmt::format("; the first {} of {} lines", drawn, lines) : std::string();
}

std::string rectangle(int x, int y, int width, int height, std::string_view fill) {
    return fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>", x, y, width,
                       height, fill);
}

/// Bytes of one component, side by side.
struct Run {
    std::size_t offset, bytes;
    Component component;
    bool starts_element;
};

/// The bytes of one element: its shares in order, padding last.
void add_element(std::size_t offset, const MappedPiece& piece, std::vector<Run>& runs) {
    const std::size_t end = offset + piece.stride;
    bool starts = true;
    for (const Share& share : piece.shares) {
        if (share.bytes == 0) continue;
        runs.push_back({offset, share.bytes, share.component, starts});
        offset += share.bytes;
        starts = false;
    }
    if (offset < end) runs.push_back({offset, end - offset, Component::padding, starts && piece.stride > 1});
}

std::vector<Run> runs_of(const std::vector<MappedPiece>& map) {
    std::vector<Run> runs;
    for (const MappedPiece& piece : map) {
        for (std::size_t i = 0; i < piece.count; ++i) {
            const std::size_t first = runs.size();
            add_element(piece.offset + i * piece.stride, piece, runs);
            // Elements of a byte are drawn as one: gaps, and indices of 8 bits.
            const bool joins = piece.stride == 1 && i > 0 && first > 0;
            if (!joins) continue;
            runs.resize(first);
            ++runs.back().bytes;
        }
    }
    return runs;
}

std::string on_line(std::size_t offset, int width, std::string_view fill) {
    const std::size_t line = offset / line_bytes;
    const int x = left_margin + static_cast<int>(line / lines_per_column) * column_width +
                  static_cast<int>(offset % line_bytes) * byte_width;
    const int y = top_margin + static_cast<int>(line % lines_per_column) * line_height;
    return rectangle(x, y, width, line_height - 1, fill) + "\n";
}

/// The part of a run on each of the first lines that it touches.
std::string run_on_lines(const Run& run, std::size_t lines) {
    std::string body;
    const std::size_t end = std::min(run.offset + run.bytes, lines * line_bytes);
    const auto colour = store::component_colour(component_names[static_cast<std::size_t>(run.component)]);
    for (std::size_t at = run.offset, next = 0; at < end; at = next) {
        next = std::min(end, (at / line_bytes + 1) * line_bytes);
        body += on_line(at, static_cast<int>(next - at) * byte_width, colour);
    }
    if (run.starts_element && run.offset < end) body += on_line(run.offset, 1, "#000");
    return body;
}

std::string legend(const Ledger& ledger, int y) {
    std::string result;
    int x = left_margin;
    for (std::size_t i = 0; i < component_names.size(); ++i) {
        if (ledger.bytes[i] == 0) continue;
        const std::string text = fmt::format("{} {} B", component_names[i], ledger.bytes[i]);
        result += rectangle(x, y, 10, 10, store::component_colour(component_names[i])) +
                  fmt::format("<text x=\"{}\" y=\"{}\">{}</text>\n", x + 14, y + 9, text);
        x += 30 + static_cast<int>(text.size()) * 6;
    }
    return result;
}

Ledger ledger_of(const std::vector<MappedPiece>& map) {
    Ledger ledger;
    for (const MappedPiece& piece : map)
        Piece{nullptr, piece.stride, piece.count, piece.shares}.add_to(ledger);
    return ledger;
}

/// From near white to dark red, by the logarithm of the part of the most.
std::string heat_colour(std::uint32_t accesses, std::uint32_t most) {
    if (accesses == 0) return "#ffffff";
    const double part = most > 1 ? std::log(accesses) / std::log(most) : 1;
    const auto fade = [&](double from, double to) { return static_cast<int>(from + part * (to - from)); };
    return fmt::format("#{:02x}{:02x}{:02x}", fade(254, 103), fade(224, 0), fade(210, 13));
}

}  // namespace

std::string draw_layout(const TableType& type, const std::string& shape, const Polyhedron& body) {
    constexpr std::size_t most_lines = 2048;
    const auto stored = type.stored_body(body);
    if (!stored) throw std::invalid_argument(stored.error);
    Arena arena;
    const TablesIn placed(arena);
    const std::vector<MappedPiece> map = type.memory_map(*stored, type.all_parts());
    const std::string title = xml_text(fmt::format("{}, {}", type.name, shape));
    const std::size_t bytes = map.empty() ? 0 : map.back().offset + map.back().stride * map.back().count;
    const std::size_t all_lines = (bytes + line_bytes - 1) / line_bytes;
    const std::size_t lines = std::min(all_lines, most_lines);
    std::string parts;
    for (const Run& run : runs_of(map)) parts += run_on_lines(run, lines);
    const auto columns = static_cast<int>((lines + lines_per_column - 1) / lines_per_column);
    const int width = std::max(900, 2 * left_margin + columns * column_width);
    const int rows = static_cast<int>(std::min(lines, lines_per_column));
    return fmt::format(
        "{}<text x=\"{}\" y=\"14\" font-weight=\"bold\">{}</text>"
        "<text x=\"{}\" y=\"14\" text-anchor=\"end\">{} bytes; a row is a cache line of {}, a black "
        "stroke starts an element{}</text>\n{}{}</svg>\n",
        svg_start(width, top_margin + rows * line_height + left_margin, title), left_margin, title,
        width - left_margin, bytes, line_bytes, cut_text(lines, all_lines), legend(ledger_of(map), 22),
        parts);
}

std::string draw_heat(const std::string& title, std::span<const std::uint32_t> accesses) {
    constexpr std::size_t most_lines = 8192;
    const std::size_t lines = std::min(accesses.size(), most_lines);
    const std::uint32_t most = accesses.empty() ? 0 : *std::max_element(accesses.begin(), accesses.end());
    std::string body;
    for (std::size_t line = 0; line < lines; ++line) {
        body += rectangle(left_margin + static_cast<int>(line % lines_per_row) * heat_cell,
                          heat_top + static_cast<int>(line / lines_per_row) * heat_cell, heat_cell - 1,
                          heat_cell - 1, heat_colour(accesses[line], most)) +
                "\n";
    }
    const int rows = static_cast<int>((lines + lines_per_row - 1) / lines_per_row);
    const int width = 2 * left_margin + static_cast<int>(lines_per_row) * heat_cell;
    const int height = heat_top + rows * heat_cell + left_margin;
    return fmt::format(
        "{7}<rect width=\"{0}\" height=\"{1}\" fill=\"#e8e8e8\"/>\n"
        "<text x=\"{3}\" y=\"14\" font-weight=\"bold\">{2}</text>\n"
        "<text x=\"{3}\" y=\"30\">a square is a line of 64 bytes, a row a page; white: never; dark: up to {4} "
        "accesses{5}</text>\n{6}</svg>\n",
        width, height, xml_text(title), left_margin, most, cut_text(lines, accesses.size()), body,
        svg_start(width, height, xml_text(title)));
}

}  // namespace edgewise::bench
