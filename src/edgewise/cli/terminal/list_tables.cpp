// SPDX-License-Identifier: MIT
#include "edgewise/cli/terminal/list_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <vector>

#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::cli {

namespace {

using Json = nlohmann::json;

using reports::wrapped, reports::rows_text, reports::widest_line;

/// Each scene with a table of its parameters.
std::string scenes_text(const Json& entries) {
    std::string text;
    for (const Json& scene : entries) {
        const auto name = scene["name"].get<std::string>();
        Json parameters = scene["parameters"];
        for (Json& parameter : parameters) parameter["default"] = parameter["default"].dump();  // all digits
        text += wrapped(name + ": " + scene["meaning"].get<std::string>()) + "\n" +
                rows_text(parameters, "parameter = name|#default|unit|meaning") + "\n";
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
    Json rows = entries;
    for (Json& machine : rows)
        for (Json& level : machine["levels"]) level["bytes"] = size_text(level["bytes"]);
    return rows_text(rows,
                     "name|#line = line_bytes|#L1D = levels/0/bytes|#L2 = levels/1/bytes|"
                     "#L3 = levels/2/bytes|#MHz = clock_mhz|#memory = memory/latency_cycles|what") +
           "line in bytes, memory in cycles; ways, latencies and sources: --json, one of which is a machine "
           "file.\nOther machines: --machines mine.json, or from sizes: --machines l2=256K,l3=8M\n";
}

std::string plans_text(const Json& entries) {
    Json rows = entries;
    for (Json& plan : rows) {
        std::map<std::string, int> times;  // a scene may be listed with several parameters
        for (const Json& scene : plan["scenes"])
            ++times[scene.get<std::string>().substr(0, scene.get<std::string>().find(' '))];
        plan["scenes"] = Json::array();
        for (const auto& [name, count] : times)
            plan["scenes"].push_back(count == 1 ? name : fmt::format("{} x {}", name, count));
    }
    return rows_text(rows, "plan = name|#queries|#checked|#rounds|#stability|scenes") +
           "queries per cell and round; of them checked exactly; timed rounds; hard cases per family.\n"
           "Layouts, shapes and parameters: --json\n";
}

std::string layouts_text(const Json& entries) {
    std::string text;
    for (const Json& layout : entries) {
        const auto names = [&](const char* key) {
            return fmt::format("{}", fmt::join(layout[key].get<std::vector<std::string>>(), ", "));
        };
        text += fmt::format("{} ({}; {})\n", layout["name"].get<std::string>(), names("precisions"),
                            names("algorithms"));
        for (const char* key : {"stores", "derives"})
            text += fmt::format("    {}: {}\n", key,
                                wrapped(layout[key].get<std::string>(), widest_line - 13, 13));
    }
    return text;
}

}  // namespace

std::string list_text(const std::string& what, const Json& entries) {
    static const std::map<std::string, const char*> tables = {
        {"probes", "probe = name|what it measures = summary"},
        {"algorithms", "algorithm = name|needs|what it is = summary"},
        {"shapes", "shape = name|#vertices|#edges|#faces"},
        {"families", "family = name|varies|breaks"},
        {"axes", "axis = name|values|meaning"},
        {"scene_files", "scene file = name|what it is for = note"},
        {"figures", "figure = name|unit|meaning"}};
    if (what == "scenes") return scenes_text(entries);
    if (what == "machines") return machines_text(entries);
    if (what == "plans") return plans_text(entries);
    if (what == "layouts") return layouts_text(entries);
    return rows_text(entries, tables.at(what));
}

}  // namespace edgewise::cli
