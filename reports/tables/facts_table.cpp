// SPDX-License-Identifier: MIT
//
// What ran, on what machine, built how. The machine's JSON belongs to the program that wrote it: the keys
// that the store promises (cpu, caches, counters) are shown in words, whatever else is there is left in the
// store.
#include <fmt/core.h>

#include <map>
#include <nlohmann/json.hpp>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/store/schema.hpp"

namespace edgewise::reports {

namespace {

// Ordered: facts are shown in the order in which the machine report gives them.
using FactsJson = nlohmann::ordered_json;

std::string plain(const FactsJson& value) {
    if (value.is_null()) return "not known";
    return value.is_string() ? value.get<std::string>() : value.dump();
}

/// "model x, cores 2": an object's members in order; a list's items separated by semicolons.
std::string facts_in_words(const FactsJson& value) {
    std::string out;
    if (value.is_object())
        for (const auto& item : value.items()) append(out, item.key() + " " + facts_in_words(item.value()));
    else if (value.is_array())
        for (const FactsJson& item : value) append(out, facts_in_words(item), "; ");
    else
        out = plain(value);
    return out;
}

/// "L1 data 32 KiB, line 64" for a cache in the usual words, else its members as they are.
std::string cache_in_words(FactsJson cache) {
    if (!cache.is_object() || !cache.contains("level")) return facts_in_words(cache);
    std::string out = "L" + plain(cache["level"]);
    cache.erase("level");
    if (cache.contains("type")) out += " " + plain(cache["type"]);
    cache.erase("type");
    if (cache.contains("bytes")) {
        const FactsJson& size = cache["bytes"];
        const bool kibibytes = size.is_number_unsigned() && size.get<std::uint64_t>() % 1024 == 0;
        out += kibibytes ? fmt::format(" {} KiB", size.get<std::uint64_t>() / 1024) : " " + plain(size);
    }
    cache.erase("bytes");
    const std::string rest = facts_in_words(cache);
    return rest.empty() ? out : out + " (" + rest + ")";
}

std::string caches_in_words(const FactsJson& caches) {
    if (!caches.is_array()) return facts_in_words(caches);
    std::string out;
    for (const FactsJson& cache : caches) append(out, cache_in_words(cache), "; ");
    return out;
}

std::string member(const FactsJson& object, const char* key) {
    return object.is_object() && object.contains(key) && !object[key].is_null() ? plain(object[key]) : "";
}

/// "3 counted (cycles, instructions, ...); 2 unavailable: misses (reason; remedy)"
std::string counters_in_words(const FactsJson& counters) {
    std::string counted;
    std::map<std::string, std::string> unavailable;
    for (const FactsJson& counter : counters) {
        const std::string event = member(counter, "event");
        if (member(counter, "status") == "counted") {
            append(counted, event);
            continue;
        }
        std::string why = member(counter, "reason");
        if (const std::string remedy = member(counter, "remedy"); !remedy.empty()) why += " – " + remedy;
        append(unavailable[why], event);
    }
    std::string out = "counted: " + (counted.empty() ? "none" : counted);
    for (const auto& [why, events] : unavailable)
        out += fmt::format("; unavailable: {} ({})", events, why.empty() ? "no reason stored" : why);
    return out;
}

void add(TextGrid& grid, const std::string& key, const std::string& value) {
    grid.rows.push_back({{key}, value.empty() ? missing_cell("not stored") : GridCell{value}});
}

/// The machine's remaining plain facts; where one could not be read, the reason that the machine gave.
std::string further_facts(const FactsJson& machine) {
    std::string out;
    for (const auto& item : machine.items()) {
        if (item.value().is_structured()) continue;
        const std::string why = item.value().is_null() && machine.contains("unreadable")
                                    ? member(machine["unreadable"], item.key().c_str())
                                    : "";
        append(out, item.key() + " " + plain(item.value()), "; ");
        if (!why.empty()) out += " (" + why + ")";
    }
    return out;
}

void add_machine(TextGrid& grid, const std::string& machine_json) {
    const FactsJson machine = input::json_or_null(machine_json);
    const auto words = [&](const char* key, std::string (*say)(const FactsJson&)) {
        return machine.is_object() && machine.contains(key) ? say(machine[key]) : "";
    };
    add(grid, "CPU", words("cpu", facts_in_words));
    add(grid, "caches", words("caches", caches_in_words));
    add(grid, "hardware counters", words("counters", counters_in_words));
    const std::string further = machine.is_object() ? further_facts(machine) : "";
    if (!further.empty()) add(grid, "machine", further);
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

TextGrid facts_grid(const ReportData& data) {
    TextGrid grid{"", columns_of("fact|value"), {}};
    add_machine(grid, data.build.machine_json);
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
            key.starts_with(store::body_key) || key.starts_with(store::heat_key))
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
