// SPDX-License-Identifier: MIT
//
// How the answer writes limits, ratios, sizes and the machine.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/answer/answer_text.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

using UnitsJson = nlohmann::json;

std::string cpu_name(const UnitsJson& machine) {
    const UnitsJson cpu = machine.is_object() ? machine.value("cpu", UnitsJson()) : UnitsJson();
    if (cpu.is_string()) return cpu.get<std::string>();
    if (cpu.is_object() && cpu.contains("name") && cpu["name"].is_string()) return cpu["name"];
    return "a processor that the store does not name";
}

std::vector<std::string> data_caches(const UnitsJson& machine) {
    std::vector<std::string> sizes;
    const UnitsJson caches = machine.is_object() ? machine.value("caches", UnitsJson()) : UnitsJson();
    if (!caches.is_array()) return sizes;
    for (const UnitsJson& cache : caches) {
        if (!cache.is_object() || !cache.contains("bytes") || !cache["bytes"].is_number()) continue;
        if (cache.contains("type") && cache["type"] == "Instruction") continue;
        sizes.push_back(size_text(cache["bytes"].get<double>()));
    }
    return sizes;
}

/// Says for which processor the program was compiled, from the stored compiler flags.
std::string tuning_text(const std::string& flags) {
    constexpr std::string_view option = "-march=";
    const std::size_t at = flags.rfind(option);
    if (flags.empty()) return "compiler flags not recorded";
    if (at == flags.npos) return "compiled with default flags (no -march)";
    const std::size_t from = at + option.size();
    const std::string processor = flags.substr(from, flags.find(' ', from) - from);
    return fmt::format("compiled for {} ({}{})", processor == "native" ? "this processor" : processor, option,
                       processor);
}

}  // namespace

std::string limit_text(double limit) {
    const int power = static_cast<int>(std::floor(std::log10(limit) + 1e-9));
    const std::string factor = fmt::format("{:.3g}", limit / std::pow(10.0, power));
    return fmt::format("{}e{}", factor, power);
}

std::string ratio_text(const RankedCell& cell) {
    if (!cell.interval) return fmt::format("{:.2f}", cell.ratio);
    return fmt::format("{:.2f} [{:.2f}, {:.2f}]", cell.ratio, cell.low(), cell.high());
}

std::string size_text(double bytes) {
    if (bytes >= mebibyte) return number_text(std::round(bytes / mebibyte * 10) / 10) + " MiB";
    if (bytes >= kibibyte) return number_text(std::round(bytes / kibibyte * 10) / 10) + " KiB";
    return number_text(bytes, "B") + " B";
}

std::string processor_text(const ReportData& data) {
    return cpu_name(input::json_or_null(data.build.machine_json));
}

std::string machine_text(const ReportData& data) {
    const UnitsJson machine = input::json_or_null(data.build.machine_json);
    const std::vector<std::string> caches = data_caches(machine);
    const std::string tuning = tuning_text(data.build.flags);
    if (caches.empty()) return fmt::format("{}, {}", cpu_name(machine), tuning);
    return fmt::format("{}, {} of cache, {}", cpu_name(machine), fmt::join(caches, " / "), tuning);
}

}  // namespace edgewise::reports
