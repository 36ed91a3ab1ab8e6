// SPDX-License-Identifier: MIT
//
// `edgewise crosscheck`: one cell's modelled misses beside Callgrind's, for the caches of several machines,
// and beside the processor's own counters where there are any.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "edgewise/cli/cell_options.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/measure/machine/machine.hpp"
#include "edgewise/studies/crosscheck.hpp"

namespace edgewise::cli {

namespace {

struct Options {
    studies::CellChoice cell;
    std::vector<std::string> machines = {"pentium3_coppermine", "athlon_thunderbird", "zen2", "zen5"};
};

/// The model and Callgrind on one machine's first two levels.
struct Compared {
    std::string machine, reason;  ///< reason: why there is nothing to compare
    studies::ModelledPass model, with_poses;
    measure::CallgrindCounts tool;
};

Compared compare(const measure::MachineChoice& choice, const Options& options,
                 const studies::SingleCell& cell, const measure::Expected<std::string>& program) {
    Compared row{choice.name, {}, {}, {}, {}};
    const measure::Expected<measure::CacheGeometry> geometry =
        choice.machine.value ? measure::callgrind_geometry(*choice.machine.value)
                             : measure::Expected<measure::CacheGeometry>::none(choice.machine.reason);
    if (!geometry.value || !program.value) {
        row.reason = geometry.value ? program.reason : geometry.reason;
        return row;
    }
    row.model = studies::model_pass(cell, *geometry.value, false);
    row.with_poses = studies::model_pass(cell, *geometry.value, true);
    const measure::Expected<measure::CallgrindCounts> counts =
        studies::callgrind_pass(options.cell, *geometry.value, *program.value);
    if (!counts.value) {
        row.reason = counts.reason;
        return row;
    }
    row.tool = *counts.value;
    return row;
}

void print(const Compared& row, double queries) {
    if (!row.reason.empty()) {
        fmt::print("{:<20} not compared: {}\n", row.machine, row.reason);
        return;
    }
    const double residual = row.tool.d1_misses - row.with_poses.d1_misses;
    fmt::print("{:<20} {:>8.1f} {:>9.1f} {:>9.2f} {:>10.2f} {:>9.2f} {:>8.3f} {:>9.3f} {:>9.3f}\n",
               row.machine, row.model.accesses / queries, row.tool.accesses / queries,
               row.model.d1_misses / queries, row.with_poses.d1_misses / queries,
               row.tool.d1_misses / queries, residual / queries, row.with_poses.ll_misses / queries,
               row.tool.ll_misses / queries);
}

nlohmann::json json_of(const Compared& row, double queries) {
    if (!row.reason.empty()) return {{"machine", row.machine}, {"reason", row.reason}};
    const auto counts = [&](double accesses, double d1, double ll) {
        return nlohmann::json{{"accesses_per_query", accesses / queries},
                              {"d1_misses_per_query", d1 / queries},
                              {"ll_misses_per_query", ll / queries}};
    };
    return {{"machine", row.machine},
            {"reason", nullptr},
            {"model", counts(row.model.accesses, row.model.d1_misses, row.model.ll_misses)},
            {"model_with_poses",
             counts(row.with_poses.accesses, row.with_poses.d1_misses, row.with_poses.ll_misses)},
            {"callgrind", counts(row.tool.accesses, row.tool.d1_misses, row.tool.ll_misses)}};
}

nlohmann::json json_of(const studies::PerfCount& perf, double queries) {
    const bool counted = perf.count.value.has_value();
    return {{"event", perf.event},
            {"encoding", perf.encoding},
            {"level", perf.level ? nlohmann::json(*perf.level) : nlohmann::json()},
            {"value", counted ? nlohmann::json(*perf.count.value / queries) : nlohmann::json()},
            {"reason", counted ? nlohmann::json() : nlohmann::json(perf.count.reason)}};
}

void print(const studies::PerfCount& perf, double queries) {
    const std::string what =
        fmt::format("perf stat {} ({})", perf.event, perf.level.value_or("no known level"));
    if (perf.count.value) {
        fmt::print("{:<40} {:.3f} per query\n", what, *perf.count.value / queries);
    } else {
        fmt::print("{:<40} not measured: {}\n", what, perf.count.reason);
    }
}

constexpr const char* residual_cause =
    "The residual is what Callgrind sees beyond tables, pair caches and poses: the stack (temporaries that "
    "do "
    "not fit registers), answers, setting the pairs back; in the last level also instructions.";

int run(const Options& options, bool json) {
    const std::vector<measure::MachineChoice> machines = measure::choose_machines(options.machines);
    const studies::SingleCell cell(options.cell);
    const auto queries = static_cast<double>(cell.workload().queries.size());
    const measure::Expected<std::string> program = studies::program_for_valgrind();
    nlohmann::json rows = nlohmann::json::array();
    if (!json)
        fmt::print("{:<20} {:>8} {:>9} {:>9} {:>10} {:>9} {:>8} {:>9} {:>9}\n", "per query", "accesses",
                   "callgrind", "D1 model", "with poses", "callgrind", "residual", "LL model", "callgrind");
    for (const measure::MachineChoice& machine : machines) {
        const Compared row = compare(machine, options, cell, program);
        if (json) {
            rows.push_back(json_of(row, queries));
        } else {
            print(row, queries);
        }
    }
    nlohmann::json counted = nlohmann::json::array();
    const std::string self = std::filesystem::read_symlink("/proc/self/exe");
    for (const studies::PerfCount& perf :
         studies::perf_pass(options.cell, self, measure::read_machine().cpu)) {
        counted.push_back(json_of(perf, queries));
        if (!json) print(perf, queries);
    }
    if (json) {
        fmt::print("{}\n", nlohmann::json({{"crosscheck", rows}, {"perf", counted}}).dump());
    } else {
        fmt::print("{}\n", residual_cause);
    }
    return exit_done;
}

}  // namespace

void add_crosscheck(CLI::App& app, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* command = add_command(app, context, "crosscheck",
                                    "One cell's modelled misses compared with Callgrind's and perf's");
    add_cell_options(*command, options->cell);
    command->add_option("--machines", options->machines, "whose first two levels: names, or your NAME.json")
        ->delimiter(',');
    command->callback(
        [options, &context] { context.action = [=, &context] { return run(*options, context.json); }; });
}

}  // namespace edgewise::cli
