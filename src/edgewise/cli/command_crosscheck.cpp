// SPDX-License-Identifier: MIT
//
// `edgewise bench crosscheck`: one cell's modelled misses next to Callgrind's, for the caches of several
// machines, and next to the processor's own counters if there are any.
//
// And `edgewise pass`: runs passes over one cell's queries and nothing else, for tools that look at the whole
// program. One pass first fills caches; the others are what is to be observed, and what Callgrind collects
// when told not to begin at the start. Prints how many queries the first pass had and the sum of their
// distances, so that whoever counts them knows that they were answered right. Not listed: `edgewise bench
// crosscheck` and `edgewise bench effort` call it.
#include <fmt/format.h>

#include "edgewise/cli/options.hpp"
#include "edgewise/cli/terminal/progress.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/measure/machine/machine.hpp"
#include "edgewise/reports/tables/text_grid.hpp"
#include "edgewise/studies/crosscheck.hpp"

#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#else
#define CALLGRIND_TOGGLE_COLLECT
#endif

namespace edgewise::cli {

namespace {

struct PassArguments {
    studies::CellChoice cell;
    int passes = 1;
};

int run_pass(const PassArguments& options) {
    const studies::SingleCell cell(options.cell);
    const std::function<bench::PassSum()> pass = cell.runner().prepared_pass();
    const bench::PassSum first = pass();
    CALLGRIND_TOGGLE_COLLECT;  // it collects from here if it runs this with --collect-atstart=no
    for (int i = 0; i < options.passes; ++i) static_cast<void>(pass());
    CALLGRIND_TOGGLE_COLLECT;
    fmt::print("{} {}\n", first.queries, first.distances);
    return exit_done;
}

struct CrosscheckArguments {
    studies::CellChoice cell;
    std::vector<std::string> machines = {"pentium3_coppermine", "athlon_thunderbird", "zen2", "zen5"};
};

/// The model and Callgrind on one machine's first two levels.
struct Compared {
    measure::CallgrindCounts model, with_poses, tool;
    std::optional<measure::CallgrindCounts> most;  ///< of tables and poses, however the stack lies
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
    std::optional<measure::CallgrindCounts> most;
    if (const auto fewer = studies::without_ways_of_the_stack(*geometry.value); fewer.value)
        most = studies::model_pass(cell, *fewer.value, true);
    return {Compared{studies::model_pass(cell, *geometry.value, false),
                     studies::model_pass(cell, *geometry.value, true), *counts.value, most}};
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
            {"at_most", compared.value->most ? counts(*compared.value->most) : nlohmann::json()},
            {"callgrind", counts(compared.value->tool)},
            {"residual_d1_misses_per_query",
             (compared.value->tool.d1_misses - compared.value->with_poses.d1_misses) / queries}};
}

nlohmann::json json_of(const studies::PerfCount& perf, double queries) {
    const std::optional<double>& count = perf.count.value;
    return {{"event", perf.event},
            {"encoding", perf.encoding},
            {"level", or_null(perf.level)},
            {"value", count ? nlohmann::json(*count / queries) : nlohmann::json()},
            {"reason", count ? nlohmann::json() : nlohmann::json(perf.count.reason)}};
}

constexpr const char* residual_cause =
    "The residual is what Callgrind sees beyond tables, pair caches and poses: the stack (temporaries that "
    "do not fit registers), answers, setting the pairs back; in the last level also instructions. At most: "
    "if these keep two ways of every set (one of two; one in the last level), tables and poses miss no more often.";

void print(const nlohmann::json& compared, const nlohmann::json& counted) {
    fmt::print("per query\n{}\n{}{}\n",
               reports::rows_text(
                   compared,
                   "machine|#accesses = model/accesses_per_query|"
                   "#Callgrind = callgrind/accesses_per_query|#D1 model = model/d1_misses_per_query|"
                   "#with poses = model_with_poses/d1_misses_per_query|"
                   "#at most = at_most/d1_misses_per_query|#Callgrind = callgrind/d1_misses_per_query|"
                   "#residual = residual_d1_misses_per_query|"
                   "#LL model = model_with_poses/ll_misses_per_query|"
                   "#at most = at_most/ll_misses_per_query|"
                   "#Callgrind = callgrind/ll_misses_per_query"),
               reports::rows_text(counted, "perf stat = event|level|#per query = value"), residual_cause);
}

int run_crosscheck(const CrosscheckArguments& options, bool json) {
    const std::vector<measure::MachineChoice> machines = measure::choose_machines(options.machines);
    const studies::SingleCell cell(options.cell);
    const auto queries = static_cast<double>(cell.workload().queries.size());
    const measure::Expected<std::string> program = studies::program_for_valgrind();
    Progress progress("crosscheck", machines.size());
    std::size_t compared_rows = 0;
    const nlohmann::json rows = json_rows(machines, [&](const measure::MachineChoice& machine) {
        const measure::Expected<Compared> compared = compare(machine, options, cell, program);
        compared_rows += compared.value.has_value();
        progress.advance(1, machine.name);
        return json_of(machine.name, compared, queries);
    });
    progress.clear();
    const std::string self = std::filesystem::read_symlink("/proc/self/exe");
    const nlohmann::json counted =
        json_rows(studies::perf_pass(options.cell, self, measure::read_machine().cpu),
                  [&](const studies::PerfCount& perf) { return json_of(perf, queries); });
    if (json)
        print_json(nlohmann::json({{"crosscheck", rows}, {"perf", counted}}));
    else
        print(rows, counted);
    if (compared_rows == 0) warn("nothing was compared; each row says why");
    return compared_rows == 0 ? exit_check_failed : exit_done;
}

}  // namespace

void add_crosscheck(CLI::App& bench, Context& context) {
    auto [command, options] =
        add_command(bench, context, "crosscheck",
                    "One cell's modelled misses compared with Callgrind's and perf's", run_crosscheck);
    add_cell_options(*command, options.cell);
    add_machines_option(*command, options.machines);
}

void add_pass(CLI::App& app, Context& context) {
    auto options = std::make_shared<PassArguments>();
    CLI::App* command = app.add_subcommand("pass", "Runs one cell's queries, for tools that watch");
    command->group("");
    add_cell_options(*command, options->cell);
    command->add_option("--peer", options->cell.peer,
                        "another library instead of a table type and an algorithm");
    add_count(*command, "--passes", options->passes, {1, 1'000'000, "passes"}, "after the first");
    command->callback([options, &context] { context.action = [=] { return run_pass(*options); }; });
}

}  // namespace edgewise::cli
