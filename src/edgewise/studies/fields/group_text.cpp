// SPDX-License-Identifier: MIT
#include "edgewise/studies/fields/group_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "edgewise/input/file_text.hpp"
#include "edgewise/input/json_text.hpp"

namespace edgewise::studies {

namespace {

using Names = std::vector<std::vector<std::string>>;

Names names_of(const FieldGroups& groups, std::span<const RecordField> fields) {
    Names names;
    groups.for_each([&](std::span<const std::uint8_t> group) {
        names.emplace_back();
        for (const std::uint8_t field : group) names.back().emplace_back(fields[field].name);
    });
    return names;
}

Names read_names(const std::string& file) {
    const auto json = input::parse_json(input::read_file_text(file).or_throw());
    std::string problem = json.error;
    try {
        if (json) {
            Names names = json->at("groups").get<Names>();
            problem = input::unknown_member(*json, "a file of groups", {"groups"});
            if (problem.empty()) return names;
        }
    } catch (const nlohmann::json::exception& wrong) {
        problem = wrong.what();
    }
    throw std::invalid_argument(fmt::format(
        R"({}: {}; wanted: {{"groups": [["tail_plane", "head_plane"], ["direction"]]}})", file, problem));
}

std::string all_names(std::span<const RecordField> fields) {
    std::vector<std::string_view> names;
    for (const RecordField& field : fields) names.push_back(field.name);
    return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

std::string groups_text(const FieldGroups& groups, std::span<const RecordField> fields) {
    std::vector<std::string> texts;
    for (const auto& group : names_of(groups, fields))
        texts.push_back(fmt::format("{}", fmt::join(group, ",")));
    return fmt::format("{}", fmt::join(texts, "|"));
}

nlohmann::json groups_json(const FieldGroups& groups, std::span<const RecordField> fields) {
    return names_of(groups, fields);
}

FieldGroups read_groups(const std::string& file, std::span<const RecordField> fields) {
    FieldGroups groups;
    std::vector<int> named(fields.size());
    for (const std::vector<std::string>& names : read_names(file)) {
        std::vector<std::uint8_t> group;
        for (const std::string& name : names) {
            const auto found = std::find_if(fields.begin(), fields.end(),
                                            [&](const RecordField& field) { return field.name == name; });
            if (found == fields.end())
                throw std::invalid_argument(
                    fmt::format("{}: unknown field '{}'; known: {}", file, name, all_names(fields)));
            const auto number = static_cast<std::size_t>(found - fields.begin());
            if (++named[number] > 1)
                throw std::invalid_argument(fmt::format("{}: '{}' is named twice", file, name));
            group.push_back(static_cast<std::uint8_t>(number));
            const RecordField& first = fields[group.front()];
            if (first.record != found->record)
                throw std::invalid_argument(fmt::format("{}: '{}' is of a {}, '{}' of a {}: not one record",
                                                        file, name, found->record, first.name, first.record));
        }
        groups.add(group);
    }
    for (std::size_t i = 0; i < fields.size(); ++i)
        if (named[i] == 0)
            throw std::invalid_argument(fmt::format("{}: field '{}' is in no group; name every one of: {}",
                                                    file, fields[i].name, all_names(fields)));
    return groups;
}

}  // namespace edgewise::studies
