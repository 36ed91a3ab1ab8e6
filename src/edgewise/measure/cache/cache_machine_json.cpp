// SPDX-License-Identifier: MIT
//
// A machine as the file that parse_cache_machine reads: what is printed can be kept, changed and named.
#include <nlohmann/json.hpp>

#include "edgewise/measure/cache/cache_machine.hpp"

namespace edgewise::measure {

namespace {

using FileJson = nlohmann::ordered_json;

FileJson origin_json(FileJson json, const LevelOrigin& origin) {
    if (origin.latency_cycles > 0) json["latency_cycles"] = origin.latency_cycles;
    json["source"] = origin.source;
    // Of the file's own fields alone: what is not written cannot be doubted.
    FileJson doubted = FileJson::array();
    for (const std::string& field : origin.unverified) {
        if (json.contains(field)) doubted.push_back(field);
    }
    if (!doubted.empty()) json["unverified"] = doubted;
    return json;
}

FileJson level_json(const LevelGeometry& level, const LevelOrigin& origin, std::uint32_t line_bytes) {
    constexpr const char* inclusions[] = {"non_inclusive", "inclusive", "exclusive"};
    constexpr const char* policies[] = {"lru", "tree_plru", "random"};
    return origin_json({{"name", level.name},
                        {"bytes", std::uint64_t{level.sets} * level.ways * line_bytes},
                        {"ways", level.ways},
                        {"inclusion", inclusions[static_cast<std::size_t>(level.inclusion)]},
                        {"replacement", policies[static_cast<std::size_t>(level.replacement)]}},
                       origin);
}

FileJson tlb_json(const CacheMachine& machine) {
    FileJson levels = FileJson::array();
    for (std::size_t i = 0; i < machine.tlbs.levels.size(); ++i) {
        const LevelGeometry& level = machine.tlbs.levels[i];
        levels.push_back(origin_json(
            {{"name", level.name}, {"entries", std::uint64_t{level.sets} * level.ways}, {"ways", level.ways}},
            machine.tlb_origins[i]));
    }
    return {{"page_bytes", machine.tlbs.line_bytes}, {"levels", levels}};
}

}  // namespace

std::string cache_machine_json(const CacheMachine& machine) {
    FileJson json = {{"name", machine.name}, {"what", machine.what}};
    if (machine.clock_mhz > 0) json["clock_mhz"] = machine.clock_mhz;
    json["line_bytes"] = machine.caches.line_bytes;
    json["levels"] = FileJson::array();
    for (std::size_t i = 0; i < machine.origins.size(); ++i)
        json["levels"].push_back(
            level_json(machine.caches.levels[i], machine.origins[i], machine.caches.line_bytes));
    json["memory"] = origin_json(FileJson::object(), machine.memory);
    if (!machine.tlbs.levels.empty()) json["tlb"] = tlb_json(machine);
    return json.dump();
}

}  // namespace edgewise::measure
