// SPDX-License-Identifier: MIT
//
// JSON that users write, and texts of a store: scene files, plans, machines, case lines, locks, baselines.
// One reader for all of them, by nlohmann-json, which follows nested values by recursion when it copies,
// compares and prints them: a file of 100,000 brackets would end the program. So the depth is looked at
// before.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "edgewise/geometry/result.hpp"
#include "edgewise/input/shown_text.hpp"

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

/// JSON in a text of a store; null where it is none or nested too deep.
template <class Json = nlohmann::json>
[[nodiscard]] Json json_or_null(std::string_view text) {
    auto parsed = parse_json<Json>(text);
    return parsed ? std::move(*parsed) : Json();
}

/// The same with texts that are valid UTF-8: a byte that is not is written as its number.
template <class Json>
[[nodiscard]] Json with_valid_texts(const Json& json) {
    if (json.is_string()) return valid_utf8(json.template get_ref<const std::string&>());
    if (!json.is_structured()) return json;
    Json copy = json.is_object() ? Json::object() : Json::array();
    for (const auto& [name, value] : json.items()) {
        if (json.is_object())
            copy[valid_utf8(name)] = with_valid_texts(value);
        else
            copy.push_back(with_valid_texts(value));
    }
    return copy;
}

/// JSON for others to read, whatever its texts hold; in one line where `indent` is negative.
template <class Json>
[[nodiscard]] std::string json_text(const Json& json, int indent = -1) {
    try {
        return json_escaped(json.dump(indent));
    } catch (const nlohmann::json::type_error&) {  // a text is no UTF-8
        return json_escaped(with_valid_texts(json).dump(indent));
    }
}

}  // namespace edgewise::input
