// SPDX-License-Identifier: MIT
#include "edgewise/scene/mesh/mesh_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "edgewise/geometry/message.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/input/known_names.hpp"

namespace edgewise::scene {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF", blanks = " \t\v\f";

/// The whole word as a number, which may be infinite or none; nothing for anything else.
std::optional<double> number_in(std::string_view word) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    double value = 0;
    const char* const end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    if (stop != end || word.empty()) return std::nullopt;
    if (error == std::errc::result_out_of_range) return HUGE_VAL;
    return error == std::errc{} ? std::optional(value) : std::nullopt;
}

bool has_decimal_comma(std::string_view word) {
    std::string pointed(word);
    std::ranges::replace(pointed, ',', '.');
    return pointed != word && number_in(pointed).has_value();
}

}  // namespace

TextLines::TextLines(std::string_view text) : rest_(text) {
    if (rest_.starts_with(byte_order_mark)) rest_.remove_prefix(byte_order_mark.size());
}

bool TextLines::next() {
    if (rest_.empty()) return false;
    const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(end);
    rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : std::min<std::size_t>(rest_.size(), 1));
    ++number_;
    return true;
}

std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    for (;;) {
        line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
        if (line.empty()) return words;
        words.push_back(line.substr(0, line.find_first_of(blanks)));
        line.remove_prefix(words.back().size());
    }
}

Result<double> coordinate_from(std::string_view word) {
    const auto value = number_in(word);
    const std::string quoted = "'" + on_one_line(word) + "'";
    if (value && std::abs(*value) <= largest_coordinate) return Result<double>::success(*value);
    if (value && std::isfinite(*value))
        return Result<double>::failure(
            message(quoted, " is beyond ", largest_coordinate, "; scale the body down"));
    if (value) return Result<double>::failure(quoted + ": every coordinate must be a finite number");
    if (has_decimal_comma(word))
        return Result<double>::failure(quoted + " has a decimal comma; write a point");
    return Result<double>::failure(quoted + " is no number");
}

Result<Vec3d> point_from(std::string_view x, std::string_view y, std::string_view z) {
    Vec3d point;
    int axis = 0;
    for (const std::string_view word : {x, y, z}) {
        const auto value = coordinate_from(word);
        if (!value) return Result<Vec3d>::failure(value.error);
        point[axis++] = *value;
    }
    return Result<Vec3d>::success(point);
}

}  // namespace edgewise::scene
