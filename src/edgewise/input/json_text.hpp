// SPDX-License-Identifier: MIT
//
// JSON that users write: scene files, plans, machines, case lines, locks, baselines. One reader for all of
// them, by nlohmann-json, which follows nested values by recursion when it copies, compares and prints them:
// a file of 100,000 brackets would end the program. So the depth is looked at before.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "edgewise/geometry/result.hpp"

namespace edgewise::input {

/// Levels of objects and lists. Ours have six at most.
inline constexpr std::size_t deepest_json = 64;

/// How deep brackets stand in each other, texts aside; of text that is no JSON an upper bound of what a
/// parser meets before it finds out.
[[nodiscard]] std::size_t nesting_of(std::string_view text);

/// "column 12", or "line 3, column 12" where that is not the first line; both count from 1.
[[nodiscard]] std::string place_in(std::string_view text, std::size_t byte);

/// Fails with one line without the file's name: "not JSON at column 12", "nested deeper than 64 levels".
template <class Json = nlohmann::json>
[[nodiscard]] Result<Json> parse_json(std::string_view text) {
    using Parsed = Result<Json>;
    if (nesting_of(text) > deepest_json)
        return Parsed::failure("nested deeper than " + std::to_string(deepest_json) + " levels");
    try {
        return Parsed::success(Json::parse(text));
    } catch (const nlohmann::json::parse_error& problem) {
        return Parsed::failure("not JSON at " + place_in(text, problem.byte) +
                               " (NaN and Infinity are not numbers)");
    } catch (const nlohmann::json::out_of_range&) {
        return Parsed::failure("a number is too large for double precision");
    }
}

}  // namespace edgewise::input
