// SPDX-License-Identifier: MIT
//
// `edgewise bench`: how fast Edgewise's own measuring is; with --gate, whether queries became slower.
#include <fmt/format.h>

#include "edgewise/cli/number_option.hpp"
#include "edgewise/cli/parts/bench_gate.hpp"
#include "edgewise/reports/tables/text_grid.hpp"
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
    const nlohmann::json rows = json_rows(speeds, [](const studies::ModelSpeed& speed) {
        return nlohmann::json{{"what", speed.what},
                              {"trace", speed.trace},
                              {"accesses", speed.accesses},
                              {"accesses_per_second", speed.per_second}};
    });
    if (json)
        print_json(nlohmann::json({{"bench", rows}}));
    else
        fmt::print("{}", reports::rows_text(
                             rows, "what|trace|#accesses|#million per s = accesses_per_second 1000000 1"));
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
