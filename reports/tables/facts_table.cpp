// SPDX-License-Identifier: MIT
//
// What ran, on what machine, built how. The machine's JSON belongs to the program that wrote it: whatever it
// has beside what the store promises (cpu, caches, counters) is shown as it is.
#include <fmt/core.h>

#include <map>
#include <nlohmann/json.hpp>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/store/schema.hpp"

namespace edgewise::reports {

namespace {

using Json = nlohmann::json;

/// A row for each member; the machine says why one is not known.
TextGrid members_grid(std::string caption, const Json& facts, const Json& unreadable) {
    Json rows = Json::array();
    if (facts.is_object())
        for (const auto& [key, value] : facts.items())
            rows.push_back({{"fact", key},
                            {"value", value},
                            {"reason", unreadable.is_object() ? unreadable.value(key, Json()) : Json()}});
    if (!facts.is_object() && !facts.is_null()) rows.push_back({{"fact", caption}, {"value", facts}});
    TextGrid grid = member_grid(rows, "fact|value");
    grid.caption = std::move(caption), grid.shown_rows = rows.size();
    return grid;
}

void add(TextGrid& grid, const std::string& key, const std::string& value) {
    grid.rows.push_back({{key}, value.empty() ? missing_cell("not stored") : GridCell{value}});
}

std::string seeds(const ReportData& data) {
    std::map<std::uint64_t, std::size_t> distinct;
    for (const auto* cells : {&data.cells, &data.from_files}) {
        for (const ReportCell& cell : *cells) ++distinct[cell.seed];
    }
    std::string out;
    std::size_t shown = 0;
    for (const auto& [seed, cells] : distinct) {
        if (++shown > 4) return out + fmt::format(", ... ({} in all)", distinct.size());
        append(out, std::to_string(seed));
    }
    return out;
}

}  // namespace

std::vector<TextGrid> machine_grids(const Json& machine) {
    const auto part = [&](const char* key) {
        return machine.is_object() && machine.contains(key) ? machine[key] : Json();
    };
    Json further = machine;
    for (const char* apart : {"cpu", "caches", "counters", "unreadable"})
        if (further.is_object()) further.erase(apart);
    TextGrid caches = member_grid(
        part("caches"),
        "#cache level = level|type|#bytes|#ways|#line = line_bytes|#sets|shared by = shared_cpus");
    TextGrid counters = member_grid(part("counters"), "event|level|by|#counted = value|unit|meaning");
    caches.caption = "Caches", counters.caption = "Hardware counters";
    counters.shown_rows = counters.rows.size();
    TextGrid facts = members_grid("Processor", part("cpu"), part("unreadable"));
    const TextGrid others = members_grid("Machine", further, part("unreadable"));
    facts.rows.insert(facts.rows.end(), others.rows.begin(), others.rows.end());
    facts.caption = others.caption;
    facts.shown_rows = facts.rows.size();
    return {std::move(facts), std::move(caches), std::move(counters)};
}

TextGrid facts_grid(const ReportData& data) {
    TextGrid grid{"", columns_of("fact|value")};
    add(grid, "compiler", data.build.compiler);
    add(grid, "flags", data.build.flags);
    add(grid, "build type", data.build.build_type);
    add(grid, "git revision", data.build.git_revision);
    add(grid, "build", data.build.id);
    add(grid, "seed", seeds(data));
    bool plan = false;
    for (const auto& [key, value] : data.meta) {
        if (key.starts_with(store::drawing_key) || key.starts_with(store::scene_file_key) ||
            key.starts_with(store::scene_path_key) || key.starts_with(store::peer_key) ||
            key.starts_with(store::run_key) || key.starts_with(store::layout_key) ||
            key.starts_with(store::body_key) || key.starts_with(store::heat_key) ||
            key.starts_with(store::study_key))
            continue;  // in places of their own
        if (key == "build" || key == "seed") continue;
        if (key == store::shard_key || key == store::complete_key || key.starts_with(store::took_key))
            continue;
        if (key.starts_with(store::command_key)) {
            if (value == data.build.id)
                add(grid, "filled by", "edgewise " + key.substr(std::string(store::command_key).size()));
            continue;
        }
        plan = plan || key == "plan";
        add(grid, key, value);
    }
    if (!plan) add(grid, "plan", "");
    std::string others;
    for (const std::string& id : data.other_builds) append(others, id);
    if (!others.empty()) add(grid, "other builds in the store, not shown", others);
    return grid;
}

}  // namespace edgewise::reports
