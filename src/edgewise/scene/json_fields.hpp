// SPDX-License-Identifier: MIT
//
// Members of JSON that users write as lines: case files and recordings. The first fault is thrown as a
// JsonFault, which the reader of a line catches once, so that checks read as plain statements. `field` is the
// member's path for messages, such as "a.vertices".
#pragma once

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "edgewise/geometry/polyhedron.hpp"

namespace edgewise::scene {

using Json = nlohmann::json;

struct JsonFault {
    std::string what;
};

/// The member, or null when it is absent.
[[nodiscard]] inline const Json& member(const Json& object, const char* key) {
    static const Json absent;
    const auto found = object.find(key);
    return found == object.end() ? absent : *found;
}

/// The member, which must be there.
[[nodiscard]] inline const Json& required(const Json& parent, const char* key, const std::string& field) {
    const Json& value = member(parent, key);
    if (value.is_null()) throw JsonFault{fmt::format("{} is missing", field)};
    return value;
}

[[nodiscard]] inline const Json& object_at(const Json& parent, const char* key, const std::string& field) {
    const Json& value = required(parent, key, field);
    if (!value.is_object()) throw JsonFault{fmt::format("{} is not an object", field)};
    return value;
}

[[nodiscard]] inline const Json& array_at(const Json& parent, const char* key, const std::string& field) {
    const Json& value = required(parent, key, field);
    if (!value.is_array()) throw JsonFault{fmt::format("{} is not an array", field)};
    return value;
}

/// The member, an array; null when it is absent.
[[nodiscard]] inline const Json& list_at(const Json& object, const char* key) {
    const Json& value = member(object, key);
    if (!value.is_null() && !value.is_array()) throw JsonFault{fmt::format("{} is not an array", key)};
    return value;
}

template <std::size_t Count>
[[nodiscard]] std::array<double, Count> numbers(const Json& list, const std::string& field) {
    if (!list.is_array()) throw JsonFault{fmt::format("{} is not an array of {} numbers", field, Count)};
    if (list.size() != Count) {
        throw JsonFault{fmt::format("{} has {} numbers and needs {}", field, list.size(), Count)};
    }
    std::array<double, Count> values{};
    for (std::size_t i = 0; i < Count; ++i) {
        if (!list[i].is_number()) throw JsonFault{fmt::format("{}[{}] is not a finite number", field, i)};
        values[i] = list[i].get<double>();
    }
    return values;
}

[[nodiscard]] inline Vec3d point(const Json& list, const std::string& field) {
    return Vec3d(numbers<3>(list, field).data());
}

/// The number of a thing, below their count. `one`, `many`: the thing's name and its plural.
[[nodiscard]] inline Index index_of(const Json& value, std::size_t count, const char* one, const char* many,
                                    const std::string& field) {
    if (!value.is_number_unsigned())
        throw JsonFault{fmt::format("{} is not a {} number (0, 1, 2 ...)", field, one)};
    const auto index = value.get<std::uint64_t>();
    if (index >= count)
        throw JsonFault{
            fmt::format("{} is {}, but there are {} {}, counted from 0", field, index, count, many)};
    return static_cast<Index>(index);
}

[[nodiscard]] inline std::vector<std::vector<Index>> faces_of(const Json& list, std::size_t vertex_count,
                                                              const std::string& field) {
    if (!list.is_array()) throw JsonFault{fmt::format("{} is not an array", field)};
    if (list.empty())
        throw JsonFault{fmt::format("{} is empty; leave it out for the hull of the vertices", field)};
    std::vector<std::vector<Index>> faces;
    for (const Json& ring : list) {
        const std::string name = fmt::format("{}[{}]", field, faces.size());
        if (!ring.is_array() || ring.size() < 3)
            throw JsonFault{name + " is not an array of three or more vertices"};
        std::vector<Index> face;
        for (const Json& vertex : ring) {
            face.push_back(index_of(vertex, vertex_count, "vertex", "vertices",
                                    fmt::format("{}[{}]", name, face.size())));
        }
        faces.push_back(std::move(face));
    }
    return faces;
}

}  // namespace edgewise::scene
