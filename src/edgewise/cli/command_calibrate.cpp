// SPDX-License-Identifier: MIT
//
// `edgewise calibrate`: the cache model of this machine against its counters, over random chases.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "edgewise/cli/command.hpp"
#include "edgewise/cli/number_option.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/measure/counters/calibration.hpp"
#include "edgewise/measure/machine/machine.hpp"

namespace edgewise::cli {

namespace {

/// Only where something was counted; a model of no misses has no ratio.
std::optional<double> ratio(const measure::CalibrationRow& row) {
    if (!row.counted || row.modelled <= 0) return std::nullopt;
    return *row.counted / row.modelled;
}

nlohmann::json json_of(const measure::CalibrationRow& row) {
    return {{"level", row.level},           {"times", row.times},
            {"bytes", row.bytes},           {"modelled_per_load", row.modelled},
            {"event", row.event},           {"counted_per_load", or_null(row.counted)},
            {"ratio", or_null(ratio(row))}, {"ns_per_load", row.ns},
            {"reason", or_null(row.reason)}};
}

void print(const std::vector<measure::CalibrationRow>& rows) {
    fmt::print("{:<6} {:>7} {:>11} {:>10} {:>10} {:>7} {:>8}\n", "level", "times", "KiB", "modelled",
               "counted", "ratio", "ns");
    for (const measure::CalibrationRow& row : rows) {
        const auto number = [](const std::optional<double>& value) {
            return value ? fmt::format("{:.4f}", *value) : std::string("-");
        };
        fmt::print("{:<6} {:>7.1f} {:>11.0f} {:>10.4f} {:>10} {:>7} {:>8.2f}\n", row.level, row.times,
                   static_cast<double>(row.bytes) / 1024, row.modelled, number(row.counted),
                   number(ratio(row)), row.ns);
    }
    const bool none = std::none_of(
        rows.begin(), rows.end(), [](const measure::CalibrationRow& row) { return row.counted.has_value(); });
    if (none && !rows.empty()) fmt::print("no counters: {}\n", rows.front().reason);
}

int run_calibrate(const measure::CalibrationOptions& options, bool json) {
    const measure::Expected<measure::CacheMachine> host = measure::host_machine();
    if (!host.value) throw std::runtime_error("this machine's caches are not known: " + host.reason);
    const auto rows = measure::calibrate_model(*host.value, measure::read_machine().cpu, options);
    if (!json) {
        print(rows);
        return exit_done;
    }
    nlohmann::json all = nlohmann::json::array();
    for (const measure::CalibrationRow& row : rows) all.push_back(json_of(row));
    print_json(nlohmann::json({{"calibration", all}}));
    return exit_done;
}

}  // namespace

void add_calibrate(CLI::App& app, Context& context) {
    auto [command, options] =
        add_command(app, context, "calibrate",
                    "Misses of random loads, modelled and counted, by level and size", run_calibrate);
    add_number(*command, "--times", options.times, {0.01, 1000},
               "memory sizes, as multiples of each level's size");
    add_count(*command, "--loads", options.loads, {1000, 1'000'000'000, "loads"}, "loads per pass");
}

}  // namespace edgewise::cli
