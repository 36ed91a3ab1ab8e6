// SPDX-License-Identifier: MIT
//
// See scene_label.hpp. Parameters that are no JSON object are shown as they are.
#include "edgewise/reports/scene_label.hpp"

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

namespace edgewise {

namespace {

using Json = nlohmann::json;

Json parse_parameters(const std::string& text) {
    Json parsed = Json::parse(text, nullptr, false);
    if (parsed.is_object()) return parsed;
    return text.empty() ? Json::object() : Json{{"parameters", text}};
}

/// The keys whose value is not the same in all of `variants`.
std::set<std::string> differing_keys(const std::set<std::string>& variants) {
    std::map<std::string, std::set<std::string>> values;
    std::map<std::string, std::size_t> present;
    for (const std::string& variant : variants) {
        const Json parameters = parse_parameters(variant);
        for (const auto& item : parameters.items()) {
            values[item.key()].insert(item.value().dump());
            ++present[item.key()];
        }
    }
    std::set<std::string> differing;
    for (const auto& [key, distinct] : values)
        if (distinct.size() > 1 || present[key] != variants.size()) differing.insert(key);
    return differing;
}

std::string shown(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

std::string label(const ReportCell& cell, const std::set<std::string>& keys) {
    const Json parameters = parse_parameters(cell.scene_parameters);
    std::string inside;
    for (const std::string& key : keys)
        if (parameters.contains(key)) {
            if (!inside.empty()) inside += ", ";
            inside += key;
            inside += " ";
            inside += shown(parameters[key]);
        }
    return inside.empty() ? cell.scene : cell.scene + " (" + inside + ")";
}

}  // namespace

void label_scenes(std::vector<ReportCell>& cells) {
    std::map<std::string, std::set<std::string>> variants;
    for (const ReportCell& cell : cells) variants[cell.scene].insert(cell.scene_parameters);
    std::map<std::string, std::set<std::string>> keys;
    for (const auto& [scene, texts] : variants) keys[scene] = differing_keys(texts);
    for (ReportCell& cell : cells) cell.scene_label = label(cell, keys[cell.scene]);
}

}  // namespace edgewise
