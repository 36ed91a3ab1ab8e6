// SPDX-License-Identifier: MIT
//
// Names are looked up from the inside out, so a part can use names that its user defines.
#include "edgewise/reports/charts/spec_file.hpp"

#include <stdexcept>

#include "edgewise/reports/text/report_text.hpp"

namespace edgewise::reports {

namespace {

struct Scope {
    const ChartJson* names;
    bool is_data;  ///< slots: inserted as they are
    const Scope* outer;
};

ChartJson fill(const ChartJson& node, const Scope& scope);

ChartJson value_of(const std::string& name, const Scope& scope) {
    if (name == "absent") return ChartJson(ChartJson::value_t::discarded);
    for (const Scope* at = &scope; at; at = at->outer)
        if (const auto found = at->names->find(name); found != at->names->end())
            return at->is_data ? *found : fill(*found, scope);
    throw std::out_of_range("a chart's specification names $" + name + ", which nothing gives");
}

void fill_item(const ChartJson& item, const Scope& scope, ChartJson& list) {
    if (item.is_object() && item.contains("$each")) {
        ChartJson rest = item;
        rest.erase("$each");
        for (const ChartJson& slots : fill(item["$each"], scope))
            list.push_back(fill(rest, {&slots, true, &scope}));
    } else if (item.is_string() && item.get_ref<const std::string&>().starts_with("$*")) {
        for (const ChartJson& one : value_of(item.get<std::string>().substr(2), scope)) list.push_back(one);
    } else {
        list.push_back(fill(item, scope));
    }
}

ChartJson fill_object(const ChartJson& node, const Scope& scope) {
    const auto let = node.find("$let");
    const Scope inner{let != node.end() ? &*let : &node, false, &scope};
    const Scope& own = let != node.end() ? inner : scope;
    ChartJson object = node.contains("$with") ? fill(node["$with"], own) : ChartJson::object();
    for (const auto& [key, member] : node.items()) {
        if (key == "$let" || key == "$with") continue;
        if (ChartJson value = fill(member, own); !value.is_discarded()) object[key] = std::move(value);
    }
    return object;
}

ChartJson fill(const ChartJson& node, const Scope& scope) {
    if (node.is_string() && node.get_ref<const std::string&>().starts_with("$"))
        return value_of(node.get<std::string>().substr(1), scope);
    if (node.is_object()) return fill_object(node, scope);
    if (!node.is_array()) return node;
    ChartJson list = ChartJson::array();
    for (const ChartJson& item : node) fill_item(item, scope, list);
    return list;
}

}  // namespace

ChartJson spec_file(const std::string& name) { return ChartJson::parse(report_text(name + ".vl.json")); }

ChartJson fill_spec(const ChartJson& file, const ChartJson& slots) {
    const ChartJson shared = spec_file("shared"), parts = file.value("parts", ChartJson::object());
    const Scope of_all{&shared, false, nullptr}, of_file{&parts, false, &of_all},
        of_code{&slots, true, &of_file};
    return fill(file["spec"], of_code);
}

}  // namespace edgewise::reports
