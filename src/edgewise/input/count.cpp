// SPDX-License-Identifier: MIT
#include "edgewise/input/count.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

namespace edgewise::input {

namespace {

using Count = Result<std::uint64_t>;

Count refuse(std::string_view what, const CountRange& range) {
    return Count::failure(fmt::format("'{}' wants a whole number{}{}, {} to {}", what,
                                      range.unit.empty() ? "" : " of ", range.unit, range.least, range.most));
}

Count within(std::uint64_t value, std::string_view what, const CountRange& range) {
    if (value < range.least || value > range.most) return refuse(what, range);
    return Count::success(value);
}

/// ", 5 to 3600", ", above 0"; empty if any finite number is allowed.
std::string bounds_text(const NumberRange& range) {
    const bool is_bounded = range.most < any_number.most;
    if (range.least == any_number.least && !is_bounded) return "";
    if (range.is_above)
        return fmt::format(", above {}{}", range.least, is_bounded ? fmt::format(", to {}", range.most) : "");
    return is_bounded ? fmt::format(", {} to {}", range.least, range.most)
                      : fmt::format(", {} or more", range.least);
}

/// Doubles count one by one up to here.
constexpr double exact_doubles = 9007199254740992.0;

}  // namespace

Count parse_count(std::string_view text, const CountRange& range) {
    std::uint64_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stop != end) return refuse(text, range);
    return within(value, text, range);
}

Count count_from(const nlohmann::json& value, const CountRange& range) {
    constexpr std::size_t most_shown = 40;
    std::string what = value.is_structured() ? value.type_name() : value.dump();
    if (what.size() > most_shown) what = what.substr(0, most_shown) + "...";
    if (value.is_number_unsigned()) return within(value.get<std::uint64_t>(), what, range);
    if (!value.is_number_float()) return refuse(what, range);
    const auto number = value.get<double>();
    if (!(number >= 0 && number <= exact_doubles) || number != std::floor(number)) return refuse(what, range);
    return within(static_cast<std::uint64_t>(number), what, range);
}

Result<double> parse_number(std::string_view text, const NumberRange& range) {
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    const bool is_number = error == std::errc{} && stop == end && std::isfinite(value);
    if (!is_number || value < range.least || value > range.most || (range.is_above && value == range.least))
        return Result<double>::failure(fmt::format("'{}' wants a decimal number{}{}{}", text,
                                                   range.unit.empty() ? "" : " of ", range.unit,
                                                   bounds_text(range)));
    return Result<double>::success(value);
}

}  // namespace edgewise::input
