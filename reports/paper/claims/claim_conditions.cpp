// SPDX-License-Identifier: MIT
#include "edgewise/reports/paper/claims/claim_conditions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <set>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

std::string seeds_in_words(const ReportData& data) {
    std::set<std::uint64_t> seeds;
    for (const auto* cells : {&data.cells, &data.from_files})
        for (const ReportCell& cell : *cells) seeds.insert(cell.seed);
    if (seeds.empty()) return "for no seed";
    return fmt::format("for seed{} {}", seeds.size() > 1 ? "s" : "", fmt::join(seeds, ", "));
}

/// Larger than the first level: "L2 2 MiB, L3 480 MiB".
std::string outer_caches(const nlohmann::json& machine) {
    std::string out;
    if (!machine.contains("caches") || !machine["caches"].is_array()) return out;
    for (const nlohmann::json& cache : machine["caches"]) {
        const int level = cache.value("level", 0);
        const auto bytes = cache.value("bytes", 0.0);
        if (level < 2 || !(bytes > 0)) continue;
        const bool small = bytes < mebibyte;
        append(out, fmt::format("L{} {:.3g} {}", level, bytes / (small ? kibibyte : mebibyte),
                                small ? "KiB" : "MiB"));
    }
    return out;
}

std::string cpu_name(const nlohmann::json& machine) {
    if (!machine.contains("cpu") || !machine["cpu"].is_object()) return {};
    const nlohmann::json& name = machine["cpu"].value("name", nlohmann::json());
    return name.is_string() ? name.get<std::string>() : std::string();
}

std::string machine_of_claims(const std::string& machine_json) {
    const auto machine = input::json_or_null(machine_json);
    if (!machine.is_object()) return "not stored";
    std::string out = cpu_name(machine);
    if (out.empty()) out = "a processor without a name";
    append(out, outer_caches(machine));
    return out;
}

}  // namespace

std::string claim_conditions(const ReportData& data, bool deterministic) {
    const std::string seeds = seeds_in_words(data);
    if (deterministic) return seeds + ", on any machine";
    return fmt::format("{}, on this machine: {}; {}", seeds, machine_of_claims(data.build.machine_json),
                       data.build.compiler.empty() ? "compiler not stored" : data.build.compiler);
}

}  // namespace edgewise::reports
