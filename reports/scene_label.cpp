// SPDX-License-Identifier: MIT
//
// The labels of scenes. Parameters that are no JSON object are shown as they are.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

namespace {

using SceneLabelJson = nlohmann::json;

SceneLabelJson parse_parameters(const std::string& text) {
    SceneLabelJson parsed = SceneLabelJson::parse(text, nullptr, false);
    if (parsed.is_object()) return parsed;
    return text.empty() ? SceneLabelJson::object() : SceneLabelJson{{"parameters", text}};
}

/// The keys whose value is not the same in all of `variants`, each with the value that more than half of
/// them have: that one is not written. Empty: no value is so common.
std::map<std::string, std::string> differing_keys(const std::set<std::string>& variants) {
    std::map<std::string, std::map<std::string, std::size_t>> values;
    for (const std::string& variant : variants) {
        const SceneLabelJson parameters = parse_parameters(variant);
        for (const auto& item : parameters.items()) ++values[item.key()][item.value().dump()];
    }
    std::map<std::string, std::string> differing;
    for (const auto& [key, counts] : values) {
        if (counts.begin()->second == variants.size()) continue;
        const auto most = std::max_element(counts.begin(), counts.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
        differing[key] = 2 * most->second > variants.size() ? most->first : std::string();
    }
    return differing;
}

std::string shown(const SceneLabelJson& value) {
    if (value.is_string()) return value.get<std::string>();
    const double number = value.is_number() ? value.get<double>() : 0.5;
    return std::floor(number) == number ? fmt::format("{:.0f}", number) : value.dump();
}

std::string label(const ReportCell& cell, const std::map<std::string, std::string>& keys) {
    const SceneLabelJson parameters = parse_parameters(cell.scene_parameters);
    std::vector<std::string> inside;
    for (const auto& [key, usual] : keys) {
        if (parameters.contains(key) && parameters[key].dump() != usual)
            inside.push_back(key + " " + shown(parameters[key]));
    }
    return inside.empty() ? cell.scene : fmt::format("{} ({})", cell.scene, fmt::join(inside, ", "));
}

}  // namespace

void label_scenes(std::vector<ReportCell>& cells) {
    std::map<std::string, std::set<std::string>> variants;
    for (const ReportCell& cell : cells) variants[cell.scene].insert(cell.scene_parameters);
    std::map<std::string, std::map<std::string, std::string>> keys;
    for (const auto& [scene, texts] : variants) keys[scene] = differing_keys(texts);
    for (ReportCell& cell : cells) cell.scene_label = label(cell, keys[cell.scene]);
}

}  // namespace edgewise::reports
