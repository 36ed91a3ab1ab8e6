// SPDX-License-Identifier: MIT
//
// `edgewise bench scaling`: queries per second of one cell over threads that share tables, and over threads
// that each have their own.
#include <fmt/format.h>

#include "edgewise/cli/options.hpp"
#include "edgewise/cli/terminal/progress.hpp"
#include "edgewise/reports/tables/text_grid.hpp"
#include "edgewise/studies/threads/scaling.hpp"

namespace edgewise::cli {

namespace {

struct ScalingArguments {
    studies::CellChoice cell = studies::scaling_cell;
    std::vector<int> threads;
    int rounds = studies::ScalingPlan{}.rounds;
};

nlohmann::json json_of(const studies::WayOfSharing& way) {
    return {
        {"queries_per_second", way.per_second}, {"speed_up", way.speed_up}, {"efficiency", way.efficiency}};
}

nlohmann::json json_of(const studies::Scaling& scaling, const ScalingArguments& options) {
    const nlohmann::json rows = json_rows(scaling.rows, [](const studies::ScalingRow& row) {
        return nlohmann::json{{"threads", row.threads},
                              {"shared", json_of(row.shared)},
                              {"apart", json_of(row.apart)},
                              {"contention", row.contention}};
    });
    return {{"table", scaling.table},
            {"algorithm", scaling.algorithm},
            {"scene", options.cell.scene},
            {"shape", options.cell.shape},
            {"cores", studies::usable_cores()},
            {"queries", scaling.queries},
            {"frames", scaling.frames},
            {"table_bytes", scaling.table_bytes},
            {"rounds", options.rounds},
            {"checked", scaling.checked},
            {"passes", scaling.passes},
            {"wrong", or_null(scaling.wrong)},
            {"rows", rows}};
}

void print(const studies::Scaling& scaling, const ScalingArguments& options) {
    fmt::print("{} on {}, {} on {}: {} queries in {} frames, tables of {:.2f} MiB, {} cores\n",
               scaling.algorithm, scaling.table, options.cell.scene, options.cell.shape, scaling.queries,
               scaling.frames, scaling.table_bytes / (1 << 20), studies::usable_cores());
    fmt::print("{}",
               reports::rows_text(json_of(scaling, options)["rows"],
                                  "#threads|#shared tables: queries per s = shared/queries_per_second 1 0|"
                                  "#speed-up = shared/speed_up|#efficiency = shared/efficiency|"
                                  "#own tables: queries per s = apart/queries_per_second 1 0|"
                                  "#speed-up = apart/speed_up|#efficiency = apart/efficiency|#contention"));
    fmt::print(
        "Medians of {} rounds. Contention: a thread's time while the others run, over its time alone. {} answers were "
        "checked exactly; {} passes gave the single queries' sum to the bit.\n",
        options.rounds, scaling.checked, scaling.passes);
}

int run_scaling(const ScalingArguments& options, bool json) {
    const studies::ScalingPlan plan{
        options.cell, studies::scaling_threads(options.threads, studies::usable_cores()), options.rounds};
    Progress progress("scaling", static_cast<std::size_t>(plan.rounds));
    const std::atomic<bool>& stop = stop_on_signals();
    const studies::Scaling scaling = studies::measure_scaling(
        plan, [&] { progress.advance(); }, stop);
    progress.clear();
    if (json) {
        print_json(json_of(scaling, options));
    } else if (scaling.wrong.empty()) {
        print(scaling, options);
    } else {
        fmt::print("{} on {}: {}\n", scaling.algorithm, scaling.table, scaling.wrong);
    }
    return scaling.wrong.empty() && !stop ? exit_done : exit_check_failed;
}

}  // namespace

void add_scaling(CLI::App& bench, Context& context) {
    auto [command, options] = add_command(
        bench, context, "scaling",
        "Queries per second over threads that share tables, and over threads with their own", run_scaling);
    add_cell_options(*command, options.cell);
    add_checked_option(*command, options.cell.checked);
    add_count(*command, "--threads", options.threads, {0, 1'000'000, "threads"},
              "numbers of threads, such as 2,4; 1 is always measured; else 1, 2, 4, ... and all cores");
    add_rounds_option(*command, options.rounds, {1, 1000, "rounds"});
}

}  // namespace edgewise::cli
