// SPDX-License-Identifier: MIT
//
// `edgewise bench calibrate`: the cache model of this machine against its counters, over random chases.
#include <fmt/format.h>

#include <stdexcept>

#include "edgewise/cli/options.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/measure/counters/calibration.hpp"
#include "edgewise/measure/machine/machine.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::cli {

namespace {

/// Only where something was counted; a model of no misses has no ratio.
std::optional<double> ratio(const measure::CalibrationRow& row) {
    if (!row.counted || row.modelled <= 0) return std::nullopt;
    return *row.counted / row.modelled;
}

nlohmann::json calibration_json(const measure::CalibrationRow& row) {
    return {{"level", row.level},           {"times", row.times},
            {"bytes", row.bytes},           {"modelled_per_load", row.modelled},
            {"event", row.event},           {"counted_per_load", or_null(row.counted)},
            {"ratio", or_null(ratio(row))}, {"ns_per_load", row.ns},
            {"reason", or_null(row.reason)}};
}

int run_calibrate(const measure::CalibrationOptions& options, bool json) {
    const measure::Expected<measure::CacheMachine> host = measure::host_machine();
    if (!host.value) throw std::runtime_error("this machine's caches are not known: " + host.reason);
    const nlohmann::json rows = json_rows(
        measure::calibrate_model(*host.value, measure::read_machine().cpu, options), calibration_json);
    if (json)
        print_json(nlohmann::json({{"calibration", rows}}));
    else
        fmt::print("{}", reports::rows_text(
                             rows,
                             "level|#times|#KiB = bytes 1024 0|#modelled per load = modelled_per_load|"
                             "#counted = counted_per_load|#ratio|#ns per load = ns_per_load"));
    return exit_done;
}

}  // namespace

void add_calibrate(CLI::App& bench, Context& context) {
    auto [command, options] =
        add_command(bench, context, "calibrate",
                    "Misses of random loads, modelled and counted, by level and size", run_calibrate);
    add_number(*command, "--times", options.times, {0.01, 1000},
               "memory sizes, as multiples of each level's size");
    add_count(*command, "--loads", options.loads, {1000, 1'000'000'000, "loads"}, "loads per pass");
}

}  // namespace edgewise::cli
