// SPDX-License-Identifier: MIT
#include "edgewise/cli/terminal/list_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "edgewise/cli/terminal/text_table.hpp"

namespace edgewise::cli {

namespace {

using Json = nlohmann::json;

/// As a person writes it: names of a list with commas between them.
std::string plain(const Json& value) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_null()) return "-";
    if (!value.is_array()) return value.dump();
    std::string text;
    for (const Json& item : value) text += (text.empty() ? "" : ", ") + plain(item);
    return text;
}

/// A column: its title, '#' before that of numbers, and the member that it shows.
struct Column {
    const char *title, *member;
};

std::string table_of(const Json& entries, const std::vector<Column>& columns) {
    std::vector<std::string> titles;
    for (const Column& column : columns) titles.emplace_back(column.title);
    TextTable table(titles);
    for (const Json& entry : entries) {
        std::vector<std::string> row;
        for (const Column& column : columns) row.push_back(plain(entry.at(column.member)));
        table.add(row);
    }
    return table.text();
}

/// Each scene with a table of its parameters.
std::string scenes_text(const Json& entries) {
    std::string text;
    for (const Json& scene : entries) {
        const auto name = scene["name"].get<std::string>();
        text += folded(name + ": " + scene["meaning"].get<std::string>(), widest_line) + "\n";
        TextTable table({"  parameter", "#default", "unit", "meaning"});
        for (const Json& parameter : scene["parameters"])
            table.add({"  " + plain(parameter["name"]), plain(parameter["default"]), plain(parameter["unit"]),
                       plain(parameter["meaning"])});
        text += table.text() + "\n";
    }
    return text + "A scene file of your own: docs/your_bodies.md; edgewise list scene_files\n";
}

std::string size_text(const Json& bytes) {
    const auto value = bytes.get<std::uint64_t>();
    const bool mib = value % (1 << 20) == 0;
    return mib ? fmt::format("{} MiB", value >> 20)
               : fmt::format("{} KiB", static_cast<double>(value) / 1024);
}

std::string machines_text(const Json& entries) {
    TextTable table({"name", "#line", "#L1D", "#L2", "#L3", "#MHz", "#memory", "what"});
    for (const Json& machine : entries) {
        std::vector<std::string> row = {machine["name"], plain(machine["line_bytes"])};
        const Json& levels = machine["levels"];
        for (std::size_t i = 0; i < 3; ++i)
            row.push_back(i < levels.size() ? size_text(levels[i]["bytes"]) : "-");
        row.push_back(plain(machine.value("clock_mhz", Json())));
        row.push_back(plain(machine["memory"].value("latency_cycles", Json())));
        row.push_back(machine["what"]);
        table.add(row);
    }
    return table.text() +
           "line in bytes, memory in cycles; ways, latencies and sources: --json, one of which is a machine "
           "file.\nOther machines: --machines mine.json, or from sizes: --machines l2=256K,l3=8M\n";
}

std::string plans_text(const Json& entries) {
    TextTable table({"plan", "#queries", "#checked", "#rounds", "#stability", "scenes"});
    for (const Json& plan : entries) {
        std::map<std::string, int> times;  // a scene may stand there with several parameters
        for (const Json& scene : plan["scenes"])
            ++times[scene.get<std::string>().substr(0, scene.get<std::string>().find(' '))];
        std::vector<std::string> scenes;
        for (const auto& [name, count] : times)
            scenes.push_back(count == 1 ? name : fmt::format("{} x {}", name, count));
        table.add({plan["name"], plain(plan["queries"]), plain(plan["checked"]), plain(plan["rounds"]),
                   plain(plan["stability"]), fmt::format("{}", fmt::join(scenes, ", "))});
    }
    return table.text() +
           "queries per cell and round; of them checked exactly; timed rounds; hard cases per family.\n"
           "Layouts, shapes and parameters: --json\n";
}

std::string layouts_text(const Json& entries) {
    std::string text;
    for (const Json& layout : entries) {
        text += fmt::format("{} ({}; {})\n", plain(layout["name"]), plain(layout["precisions"]),
                            plain(layout["algorithms"]));
        for (const char* key : {"stores", "derives"})
            text += fmt::format("    {}: {}\n", key, folded(plain(layout[key]), widest_line - 13, 13));
    }
    return text;
}

}  // namespace

std::string list_text(const std::string& what, const Json& entries) {
    static const std::map<std::string, std::vector<Column>> tables = {
        {"probes", {{"probe", "name"}, {"what it measures", "summary"}}},
        {"algorithms", {{"algorithm", "name"}, {"needs", "needs"}, {"what it is", "summary"}}},
        {"shapes", {{"shape", "name"}, {"#vertices", "vertices"}, {"#edges", "edges"}, {"#faces", "faces"}}},
        {"families", {{"family", "name"}, {"varies", "varies"}, {"breaks", "breaks"}}},
        {"axes", {{"axis", "name"}, {"values", "values"}, {"meaning", "meaning"}}},
        {"scene_files", {{"scene file", "name"}, {"what it is for", "note"}}},
        {"figures", {{"figure", "name"}, {"unit", "unit"}, {"meaning", "meaning"}}}};
    if (what == "scenes") return scenes_text(entries);
    if (what == "machines") return machines_text(entries);
    if (what == "plans") return plans_text(entries);
    if (what == "layouts") return layouts_text(entries);
    return table_of(entries, tables.at(what));
}

}  // namespace edgewise::cli
