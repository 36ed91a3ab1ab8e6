// SPDX-License-Identifier: MIT
#include "edgewise/measure/cache/cache_machine.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "edgewise/input/json_text.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"

namespace edgewise::measure {
namespace {

using Json = nlohmann::json;

constexpr double most_bytes = 1e12, most_cycles = 1e6;

/// An object of the file and how to say where it is.
struct Place {
    const Json& json;
    std::string file, path;

    [[noreturn]] void refuse(std::string_view field, std::string_view wanted) const {
        throw std::runtime_error(fmt::format("{}: {}{}: wants {}", file, path, field, wanted));
    }
    /// Null where there is no such field.
    [[nodiscard]] const Json& at(std::string_view field) const {
        static const Json none;
        const auto found = json.find(field);
        return found == json.end() ? none : *found;
    }
    [[nodiscard]] Place in(std::string_view field) const {
        if (!at(field).is_object()) refuse(field, "an object");
        return {at(field), file, fmt::format("{}{}.", path, field)};
    }
    [[nodiscard]] std::vector<Place> list(std::string_view field) const {
        const Json& items = at(field);
        if (!items.is_array() || items.empty()) refuse(field, "a list, not empty");
        std::vector<Place> places;
        for (std::size_t i = 0; i < items.size(); ++i) {
            if (!items[i].is_object()) refuse(fmt::format("{}[{}]", field, i), "an object");
            places.push_back({items[i], file, fmt::format("{}{}[{}].", path, field, i)});
        }
        return places;
    }
    /// A misspelt member would be left out without a word.
    void refuse_others(std::string_view what, const std::vector<std::string>& known) const {
        const std::string unknown = input::unknown_member(json, what, known);
        if (!unknown.empty()) throw std::runtime_error(fmt::format("{}: {}{}", file, path, unknown));
    }
    /// From least to most.
    [[nodiscard]] double number(std::string_view field, double least, double most) const {
        const double value = at(field).is_number() ? at(field).get<double>() : std::nan("");
        if (!(value >= least && value <= most))
            refuse(field, fmt::format("a number from {} to {}", least, most));
        return value;
    }
    [[nodiscard]] std::uint64_t whole(std::string_view field, double least, double most) const {
        const double value = number(field, least, most);
        if (value != std::floor(value)) refuse(field, "a whole number");
        return static_cast<std::uint64_t>(value);
    }
    /// 49152, "48K" or "48 KiB".
    [[nodiscard]] std::uint64_t bytes(std::string_view field, double least) const {
        if (!at(field).is_string()) return whole(field, least, most_bytes);
        std::string size = at(field).get<std::string>();
        std::erase(size, ' ');
        const auto value = bytes_of_size(size);
        if (!value || static_cast<double>(*value) < least)
            refuse(field, fmt::format("bytes, as 49152 or \"48K\", {} or more", least));
        return *value;
    }
    /// What may be left out, but not be wrong.
    [[nodiscard]] std::string text_or(std::string_view field, const char* standard) const {
        return json.contains(field) ? text(field) : standard;
    }
    [[nodiscard]] double number_or_0(std::string_view field, double least, double most) const {
        return json.contains(field) ? number(field, least, most) : 0;
    }
    [[nodiscard]] std::string text(std::string_view field) const {
        const std::string value = at(field).is_string() ? at(field).get<std::string>() : "";
        if (value.empty()) refuse(field, "a text, not empty");
        return value;
    }
    /// One of the names, by position; the first if the field is not there.
    [[nodiscard]] std::size_t choice(std::string_view field,
                                     const std::vector<std::string_view>& names) const {
        if (!json.contains(field)) return 0;
        const auto name =
            std::find(names.begin(), names.end(), at(field).is_string() ? at(field).get<std::string>() : "");
        if (name == names.end()) refuse(field, fmt::format("one of {}", fmt::join(names, ", ")));
        return static_cast<std::size_t>(name - names.begin());
    }
};

LevelOrigin read_origin(const Place& place, bool has_latency) {
    LevelOrigin origin;
    if (has_latency) origin.latency_cycles = place.number_or_0("latency_cycles", 0, most_cycles);
    origin.source = place.text_or("source", "the file names none");
    if (!place.json.contains("unverified")) return origin;
    const Json& unverified = place.at("unverified");
    if (!unverified.is_array()) place.refuse("unverified", "a list of this level's fields");
    for (const Json& field : unverified) {
        if (!field.is_string() || !place.json.contains(field.get<std::string>()))
            place.refuse("unverified", "a list of this level's fields");
        origin.unverified.push_back(field);
    }
    return origin;
}

/// Reads a level that has this many lines in all.
LevelGeometry read_level(const Place& place, std::uint64_t lines, std::string_view counted,
                         const std::vector<LevelGeometry>& above) {
    LevelGeometry level;
    level.name = place.text("name");
    if (std::ranges::find(above, level.name, &LevelGeometry::name) != above.end())
        place.refuse("name", fmt::format("a name of its own: another level is called '{}'", level.name));
    level.inclusion =
        static_cast<Inclusion>(place.choice("inclusion", {"non_inclusive", "inclusive", "exclusive"}));
    level.replacement = static_cast<Replacement>(place.choice("replacement", {"lru", "tree_plru", "random"}));
    const double most = level.replacement == Replacement::tree_plru ? most_tree_ways : 65536;
    const double most_ways = std::min(most, static_cast<double>(lines));
    if (place.at("ways") == 0)
        place.refuse(
            "ways", fmt::format("a number from 1 to {0}; the kernel writes 0 where it does not know them, or "
                                "for full associativity: that is {0} here",
                                most_ways));
    const std::uint64_t ways = place.whole("ways", 1, most_ways);
    if (lines % ways != 0) place.refuse(counted, "whole sets: a multiple of the ways' size");
    level.ways = static_cast<std::uint32_t>(ways);
    level.sets = static_cast<std::uint32_t>(lines / ways);
    return level;
}

std::uint32_t read_line(const Place& place, std::string_view field, double least, double most) {
    const std::uint64_t bytes = place.whole(field, least, most);
    if (!std::has_single_bit(bytes)) place.refuse(field, "a power of two");
    return static_cast<std::uint32_t>(bytes);
}

void read_caches(const Place& file, CacheMachine& machine) {
    machine.caches.line_bytes = read_line(file, "line_bytes", 16, 1024);
    for (const Place& place : file.list("levels")) {
        if (place.json.contains("line_bytes"))
            place.refuse(
                "line_bytes",
                "to stand before the levels, once: caches with lines of several sizes are not modelled");
        place.refuse_others("a cache level", {"name", "bytes", "ways", "inclusion", "replacement",
                                              "latency_cycles", "source", "unverified"});
        const std::uint64_t bytes = place.bytes("bytes", machine.caches.line_bytes);
        if (bytes % machine.caches.line_bytes != 0) place.refuse("bytes", "whole lines");
        machine.caches.levels.push_back(
            read_level(place, bytes / machine.caches.line_bytes, "bytes", machine.caches.levels));
        machine.origins.push_back(read_origin(place, true));
    }
    if (machine.caches.levels[0].inclusion == Inclusion::exclusive)
        file.list("levels")[0].refuse("inclusion", "non_inclusive: nothing is above the first level");
    machine.memory.source = "the file names none";
    if (!file.json.contains("memory")) return;
    file.in("memory").refuse_others("the memory", {"latency_cycles", "source", "unverified"});
    machine.memory = read_origin(file.in("memory"), true);
}

void read_tlbs(const Place& file, CacheMachine& machine) {
    if (!file.json.contains("tlb")) return;
    const Place tlb = file.in("tlb");
    tlb.refuse_others("the TLBs", {"page_bytes", "levels"});
    machine.tlbs.line_bytes = read_line(tlb, "page_bytes", 512, 1 << 30);
    for (const Place& place : tlb.list("levels")) {
        place.refuse_others("a TLB level",
                            {"name", "entries", "ways", "inclusion", "replacement", "source", "unverified"});
        machine.tlbs.levels.push_back(
            read_level(place, place.whole("entries", 1, 1e7), "entries", machine.tlbs.levels));
        machine.tlb_origins.push_back(read_origin(place, false));
    }
    if (machine.tlbs.levels[0].inclusion == Inclusion::exclusive)
        tlb.list("levels")[0].refuse("inclusion", "non_inclusive: nothing is above the first level");
}

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

bool LevelOrigin::proves(std::string_view field) const {
    return std::find(unverified.begin(), unverified.end(), field) == unverified.end();
}

CacheMachine parse_cache_machine(const std::string& json, const std::string& name) {
    const auto read = input::parse_json<Json>(json);
    if (!read)
        throw std::runtime_error(fmt::format("{}: {}; wants the description of a machine", name, read.error));
    const Json& parsed = *read;
    const Place file{parsed, name, ""};
    if (!parsed.is_object()) file.refuse("the file", "an object");
    file.refuse_others("a machine", {"name", "what", "clock_mhz", "line_bytes", "levels", "memory", "tlb"});
    CacheMachine machine;
    machine.name = name;
    machine.what = file.text_or("what", name.c_str());
    machine.clock_mhz = file.number_or_0("clock_mhz", 1, 1e5);
    read_caches(file, machine);
    read_tlbs(file, machine);
    return machine;
}

double CacheMachine::memory_ns(std::span<const LevelCounts> counts) const {
    double cycles = 0;
    for (std::size_t level = 0; level < counts.size(); ++level) {
        const std::uint64_t deeper = counts[level].misses;
        const std::uint64_t answered = level + 1 < counts.size() ? deeper - counts[level + 1].misses : deeper;
        const LevelOrigin& by = level + 1 < origins.size() ? origins[level + 1] : memory;
        cycles += static_cast<double>(answered) * by.latency_cycles;
    }
    return cycles * 1e3 / clock_mhz;
}

bool CacheMachine::latencies_known() const {
    return clock_mhz > 0 && memory.latency_cycles > 0 &&
           std::ranges::all_of(origins, [](const LevelOrigin& origin) { return origin.latency_cycles > 0; });
}

bool CacheMachine::latencies_proved() const {
    return memory.proves("latency_cycles") &&
           std::all_of(origins.begin() + 1, origins.end(),
                       [](const LevelOrigin& origin) { return origin.proves("latency_cycles"); });
}

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
