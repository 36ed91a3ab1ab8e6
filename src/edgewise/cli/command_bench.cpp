// SPDX-License-Identifier: MIT
//
// `edgewise bench`: how fast Edgewise's own measuring is; with --gate, whether queries became slower.
#include <fmt/format.h>

#include "edgewise/cli/number_option.hpp"
#include "edgewise/cli/parts/bench_gate.hpp"
#include "edgewise/studies/model_speed.hpp"

namespace edgewise::cli {

namespace {

struct BenchArguments {
    studies::CellChoice cell;
    int repetitions = 7;
    GateArguments gate;
};

int run_bench(const BenchArguments& options, bool json) {
    if (!options.gate.file.empty()) return run_gate_command(options.gate, options.cell.queries, json);
    const studies::SingleCell cell(options.cell);
    const std::vector<studies::ModelSpeed> speeds = studies::model_speeds(cell, options.repetitions);
    nlohmann::json rows = nlohmann::json::array();
    if (!json) fmt::print("{:<40} {:<18} {:>10} {:>12}\n", "what", "trace", "accesses", "million per s");
    for (const studies::ModelSpeed& speed : speeds) {
        rows.push_back({{"what", speed.what},
                        {"trace", speed.trace},
                        {"accesses", speed.accesses},
                        {"accesses_per_second", speed.per_second}});
        if (!json)
            fmt::print("{:<40} {:<18} {:>10} {:>12.1f}\n", speed.what, speed.trace, speed.accesses,
                       speed.per_second * 1e-6);
    }
    if (json) print_json(nlohmann::json({{"bench", rows}}));
    return exit_done;
}

}  // namespace

void add_bench(CLI::App& app, Context& context) {
    auto [command, options] = add_command(
        app, context, "bench",
        "How fast the cache model and the reuse distances are; --gate: whether queries became slower",
        run_bench);
    add_cell_options(*command, options.cell);
    add_count(*command, "--repetitions", options.repetitions, {1, 1000, "repetitions"},
              "repetitions of each measurement; the median is printed");
    add_gate_options(*command, options.gate);
}

}  // namespace edgewise::cli
