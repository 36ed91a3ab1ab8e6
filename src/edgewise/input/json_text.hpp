// SPDX-License-Identifier: MIT
//
// JSON that users write, and texts of a store: scene files, plans, machines, case lines, locks, baselines.
// One reader for all of them, by nlohmann-json. It recurses into nested values when it copies, compares and
// prints them, so a file of 100,000 brackets would end the program: the depth is checked first. It silently
// keeps the last of two members with one name: such a text is refused here. `unknown_member` refuses members
// that no reader knows.
#pragma once

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include "edgewise/geometry/result.hpp"
#include "edgewise/input/shown_text.hpp"

namespace edgewise::input {

/// Levels of objects and lists that are read. Files of Edgewise have six at most.
inline constexpr std::size_t deepest_json = 64;

/// Depth of nested brackets outside of quoted texts. If the text is not JSON, it is an upper bound of the
/// depth that a parser meets before its error.
[[nodiscard]] std::size_t nesting_of(std::string_view text);

/// Returns true if the rest is missing: more brackets are opened than closed, or a quoted text is not closed.
[[nodiscard]] bool ends_inside(std::string_view text);

/// "not JSON at column 12", with a hint if NaN or Infinity is there, which JSON does not have.
[[nodiscard]] std::string not_json_at(std::string_view text, std::size_t byte);

/// Finds the first member that an object has twice, while a text is parsed.
class RepeatedMember {
  public:
    void begin_object() { objects_.emplace_back(); }
    void end_object() { objects_.pop_back(); }
    void take(std::string name);

    /// Returns the path of the member, such as "a.vertices"; empty if no object has a member twice.
    [[nodiscard]] const std::string& path() const { return path_; }

  private:
    struct Object {
        std::unordered_set<std::string> names;
        std::string last;
    };
    std::vector<Object> objects_;  ///< from the outermost to the one that is being read
    std::string path_;
};

/// Fails with one line without the file's name: "not JSON at column 12", "nested deeper than 64 levels",
/// "a.vertices is given twice; keep one of them".
template <class Json = nlohmann::json>
[[nodiscard]] Result<Json> parse_json(std::string_view text) {
    using Parsed = Result<Json>;
    using Event = typename Json::parse_event_t;
    if (nesting_of(text) > deepest_json)
        return Parsed::failure("nested deeper than " + std::to_string(deepest_json) + " levels");
    RepeatedMember repeated;
    const auto look = [&](int, Event event, Json& value) {
        if (event == Event::key) repeated.take(value.template get<std::string>());
        if (event == Event::object_start) repeated.begin_object();
        if (event == Event::object_end) repeated.end_object();
        return true;
    };
    try {
        auto json = Json::parse(text, look);
        if (!repeated.path().empty())
            return Parsed::failure(repeated.path() + " is given twice; keep one of them");
        return Parsed::success(std::move(json));
    } catch (const nlohmann::json::parse_error& problem) {
        return Parsed::failure(not_json_at(text, problem.byte));
    } catch (const nlohmann::json::out_of_range&) {
        return Parsed::failure("a number is too large for double precision");
    }
}

/// The line that refuses one member: "'poseB' is not a member of a case line; did you mean 'pose_b'? known:
/// id, a, b, pose_a, pose_b".
[[nodiscard]] std::string not_a_member(std::string_view name, std::string_view what,
                                       const std::vector<std::string>& known);

/// The first member of the object that is not a known one, as the line of `not_a_member`; empty if all are
/// known. `what`: the kind of object, with its article ("a case line").
template <class Json>
[[nodiscard]] std::string unknown_member(const Json& object, std::string_view what,
                                         const std::vector<std::string>& known) {
    for (const auto& [name, value] : object.items())
        if (std::ranges::find(known, name) == known.end()) return not_a_member(name, what, known);
    return {};
}

/// JSON in a text of a store; null if the text is not JSON or is nested too deep.
template <class Json = nlohmann::json>
[[nodiscard]] Json json_or_null(std::string_view text) {
    auto parsed = parse_json<Json>(text);
    return parsed ? std::move(*parsed) : Json();
}

/// A member of such JSON, which another program may have written; null if it is no object, or lacks the
/// member.
template <class Json>
[[nodiscard]] Json member_of(const Json& json, const std::string& name) {
    return json.is_object() ? json.value(name, Json()) : Json();
}
/// The member if it is a text; else an empty one.
template <class Json>
[[nodiscard]] std::string text_member(const Json& json, const std::string& name) {
    const Json member = member_of(json, name);
    return member.is_string() ? member.template get<std::string>() : std::string();
}

/// A copy of the JSON with texts that are valid UTF-8: other bytes are written as their numbers.
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

/// JSON as text that every reader accepts, whatever its texts hold; on one line if `indent` is negative.
template <class Json>
[[nodiscard]] std::string json_text(const Json& json, int indent = -1) {
    try {
        return json_escaped(json.dump(indent));
    } catch (const nlohmann::json::type_error&) {  // a text is no UTF-8
        return json_escaped(with_valid_texts(json).dump(indent));
    }
}

}  // namespace edgewise::input
