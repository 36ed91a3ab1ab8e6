// SPDX-License-Identifier: MIT
//
// `edgewise crosscheck`: one cell's modelled misses beside Callgrind's, for the caches of several machines,
// and beside the processor's own counters where there are any.
#include <fmt/format.h>

#include "edgewise/cli/command.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/measure/machine/machine.hpp"
#include "edgewise/studies/crosscheck.hpp"

namespace edgewise::cli {

namespace {

struct CrosscheckArguments {
    studies::CellChoice cell;
    std::vector<std::string> machines = {"pentium3_coppermine", "athlon_thunderbird", "zen2", "zen5"};
};

/// The model and Callgrind on one machine's first two levels.
struct Compared {
    measure::CallgrindCounts model, with_poses, tool;
    std::optional<double> most;  ///< D1 misses of tables and poses, however the stack lies
};

measure::Expected<Compared> compare(const measure::MachineChoice& choice, const CrosscheckArguments& options,
                                    const studies::SingleCell& cell,
                                    const measure::Expected<std::string>& program) {
    using Answer = measure::Expected<Compared>;
    if (!choice.machine.value) return Answer::none(choice.machine.reason);
    const auto geometry = measure::callgrind_geometry(*choice.machine.value);
    if (!geometry.value) return Answer::none(geometry.reason);
    if (!program.value) return Answer::none(program.reason + "; " + program.remedy);
    const auto counts = studies::callgrind_pass(options.cell, *geometry.value, *program.value);
    if (!counts.value)
        return Answer::none(counts.reason + (counts.remedy.empty() ? "" : "; " + counts.remedy));
    std::optional<double> most;
    if (const auto fewer = studies::without_ways_of_the_stack(*geometry.value); fewer.value)
        most = studies::model_pass(cell, *fewer.value, true).d1_misses;
    return {Compared{studies::model_pass(cell, *geometry.value, false),
                     studies::model_pass(cell, *geometry.value, true), *counts.value, most}};
}

void print(const std::string& machine, const measure::Expected<Compared>& compared, double queries) {
    if (!compared.value) {
        fmt::print("{:<20} not compared: {}\n", machine, compared.reason);
        return;
    }
    const auto& [model, with_poses, tool, most] = *compared.value;
    const double residual = tool.d1_misses - with_poses.d1_misses;
    fmt::print("{:<20} {:>8.1f} {:>9.1f} {:>9.2f} {:>10.2f} {:>9} {:>9.2f} {:>8.3f} {:>9.3f} {:>9.3f}\n",
               machine, model.accesses / queries, tool.accesses / queries, model.d1_misses / queries,
               with_poses.d1_misses / queries, most ? fmt::format("{:.2f}", *most / queries) : "-",
               tool.d1_misses / queries, residual / queries, with_poses.ll_misses / queries,
               tool.ll_misses / queries);
}

nlohmann::json json_of(const std::string& machine, const measure::Expected<Compared>& compared,
                       double queries) {
    if (!compared.value) return {{"machine", machine}, {"reason", compared.reason}};
    const auto counts = [&](const measure::CallgrindCounts& of) {
        return nlohmann::json{{"accesses_per_query", of.accesses / queries},
                              {"d1_misses_per_query", of.d1_misses / queries},
                              {"ll_misses_per_query", of.ll_misses / queries}};
    };
    return {{"machine", machine},
            {"reason", nullptr},
            {"model", counts(compared.value->model)},
            {"model_with_poses", counts(compared.value->with_poses)},
            {"d1_misses_per_query_at_most",
             compared.value->most ? nlohmann::json(*compared.value->most / queries) : nlohmann::json()},
            {"callgrind", counts(compared.value->tool)}};
}

nlohmann::json json_of(const studies::PerfCount& perf, double queries) {
    const std::optional<double>& count = perf.count.value;
    return {{"event", perf.event},
            {"encoding", perf.encoding},
            {"level", or_null(perf.level)},
            {"value", count ? nlohmann::json(*count / queries) : nlohmann::json()},
            {"reason", count ? nlohmann::json() : nlohmann::json(perf.count.reason)}};
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
    "do not fit registers), answers, setting the pairs back; in the last level also instructions. At most: "
    "tables and poses miss no more often wherever the stack lies, if it keeps two ways of every set (one of two).";

int run_crosscheck(const CrosscheckArguments& options, bool json) {
    const std::vector<measure::MachineChoice> machines = measure::choose_machines(options.machines);
    const studies::SingleCell cell(options.cell);
    const auto queries = static_cast<double>(cell.workload().queries.size());
    const measure::Expected<std::string> program = studies::program_for_valgrind();
    nlohmann::json rows = nlohmann::json::array();
    std::size_t compared_rows = 0;
    if (!json)
        fmt::print("{:<20} {:>8} {:>9} {:>9} {:>10} {:>9} {:>9} {:>8} {:>9} {:>9}\n", "per query", "accesses",
                   "callgrind", "D1 model", "with poses", "at most", "callgrind", "residual", "LL model",
                   "callgrind");
    for (const measure::MachineChoice& machine : machines) {
        const measure::Expected<Compared> compared = compare(machine, options, cell, program);
        compared_rows += compared.value.has_value();
        if (json) {
            rows.push_back(json_of(machine.name, compared, queries));
        } else {
            print(machine.name, compared, queries);
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
        print_json(nlohmann::json({{"crosscheck", rows}, {"perf", counted}}));
    } else {
        fmt::print("{}\n", residual_cause);
    }
    if (compared_rows == 0) warn("nothing was compared; each row says why");
    return compared_rows == 0 ? exit_check_failed : exit_done;
}

}  // namespace

void add_crosscheck(CLI::App& app, Context& context) {
    auto [command, options] =
        add_command(app, context, "crosscheck",
                    "One cell's modelled misses compared with Callgrind's and perf's", run_crosscheck);
    add_cell_options(*command, options.cell);
    command->add_option("--machines", options.machines, "whose first two levels: names, or your NAME.json")
        ->delimiter(',');
}

}  // namespace edgewise::cli
