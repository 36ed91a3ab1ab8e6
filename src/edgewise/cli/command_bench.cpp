// SPDX-License-Identifier: MIT
//
// `edgewise bench`: speed and work of queries and of the measuring itself. Here: `bench model`, how fast the
// cache model and the reuse distances are, `bench gate`, which compares this build's speed with a baseline,
// `bench calibrate`, the cache model of this machine against its counters, and `bench scaling`, queries per
// second over threads that share tables and over threads with their own.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "edgewise/cli/options.hpp"
#include "edgewise/cli/terminal/progress.hpp"
#include "edgewise/input/output_file.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/measure/counters/calibration.hpp"
#include "edgewise/measure/machine/machine.hpp"
#include "edgewise/measure/statistics.hpp"
#include "edgewise/reports/tables/text_grid.hpp"
#include "edgewise/studies/crosscheck.hpp"
#include "edgewise/studies/gate/run.hpp"
#include "edgewise/studies/threads/scaling.hpp"

namespace edgewise::studies {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(WayOfSharing, queries_per_second, speed_up, efficiency)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ScalingRow, threads, shared, apart, contention)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ModelSpeed, what, trace, accesses, accesses_per_second)

}  // namespace edgewise::studies

namespace edgewise::cli {

namespace {

struct ScalingArguments {
    studies::CellChoice cell = studies::scaling_cell;
    std::vector<int> threads;
    int rounds = studies::ScalingPlan{}.rounds;
    bool waits = false;
};

nlohmann::json json_of(const studies::Scaling& scaling, const ScalingArguments& options) {
    return {{"table", scaling.table},
            {"algorithm", scaling.algorithm},
            {"scene", options.cell.scene},
            {"shape", bodies_of(options.cell)},
            {"cores", studies::usable_cores()},
            {"queries", scaling.queries},
            {"frames", scaling.frames},
            {"table_bytes", scaling.table_bytes},
            {"rounds", scaling.rounds},
            {"checked", scaling.checked},
            {"passes", scaling.passes},
            {"wrong", or_null(scaling.wrong)},
            {"rows", scaling.rows}};
}

void print(const studies::Scaling& scaling, const ScalingArguments& options) {
    fmt::print("{} on {}, {} on {}: {} queries in {} frames, tables of {:.2f} MiB, {} cores\n",
               scaling.algorithm, scaling.table, options.cell.scene, bodies_of(options.cell), scaling.queries,
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
        scaling.rounds, scaling.checked, scaling.passes);
}

int run_scaling(const ScalingArguments& options, bool json) {
    say_how_quiet(options.waits, json);
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

void add_scaling(CLI::App& bench, Context& context) {
    auto [command, options] = add_command(
        bench, context, "scaling",
        "Queries per second over threads that share tables, and over threads with their own", run_scaling);
    add_cell_options(*command, options.cell);
    add_checked_option(*command, options.cell.checked);
    add_count(*command, "--threads", options.threads, {0, 1'000'000, "threads"},
              "numbers of threads, such as 2,4; 1 is always measured; else 1, 2, 4, ... and all cores");
    add_rounds_option(*command, options.rounds, {1, 1000, "rounds"});
    add_wait_option(*command, options.waits);
}

/// Only where something was counted; a model of no misses has no ratio.
std::optional<double> ratio(const measure::CalibrationRow& row) {
    if (!row.counted || !(row.modelled > 0)) return std::nullopt;
    return *row.counted / *row.modelled;
}

nlohmann::json calibration_json(const measure::CalibrationRow& row) {
    return {{"level", row.level},           {"times", row.times},
            {"bytes", row.bytes},           {"modelled_per_load", or_null(row.modelled)},
            {"event", row.event},           {"counted_per_load", or_null(row.counted)},
            {"ratio", or_null(ratio(row))}, {"ns_per_load", or_null(row.ns)},
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

void add_calibrate(CLI::App& bench, Context& context) {
    auto [command, options] =
        add_command(bench, context, "calibrate",
                    "Misses of random loads, modelled and counted, by level and size", run_calibrate);
    add_number(*command, "--times", options.times, {0.01, 1000},
               "memory sizes, as multiples of each level's size");
    add_count(*command, "--loads", options.loads, {1000, 1'000'000'000, "loads"}, "loads per pass");
}

struct GateArguments {
    std::string file;
    bool write = false, waits = false;
    int rounds = 17;
    std::optional<double> slack;
    std::size_t queries = studies::CellChoice{}.queries;
    std::vector<std::string> layouts = {"all"};
};

struct ModelArguments {
    studies::CellChoice cell;
    int repetitions = 7;
};

constexpr double usual_slack = 0.1;
constexpr int second_looks = 2;  ///< at what seems slower

/// Measures these groups; all if none is named. Nothing if it was stopped.
std::optional<studies::GateRun> measure_gate(const GateArguments& gate,
                                             const std::vector<std::string>& groups = {}) {
    const studies::GatePlan plan{bench::select_table_types(gate.layouts), gate.rounds, gate.queries, groups};
    Progress progress(groups.empty() ? "gate" : "gate, a second look",
                      groups.empty() ? studies::gate_groups().size() : groups.size());
    return studies::run_gate(
        plan, [&](const std::string& group) { progress.advance(1, group); }, stop_on_signals());
}

/// Only rows of table types that were asked for, and of references: others are not missing.
measure::FigureRecord asked_of(measure::FigureRecord baseline, const GateArguments& gate) {
    const auto types = bench::select_table_types(gate.layouts);
    if (std::ranges::find(gate.layouts, "all") != gate.layouts.end()) return baseline;
    std::erase_if(baseline.rows, [&](const measure::RecordRow& row) {
        return row.figure != studies::over_kernel &&
               std::ranges::find(types, studies::gate_table_of(row.cell), &bench::TableType::name) ==
                   types.end();
    });
    return baseline;
}

int write_baseline(const GateArguments& gate, bool json) {
    static_cast<void>(input::output_place(gate.file));  // refused before minutes of measuring
    say_how_quiet(gate.waits, json);
    auto run = measure_gate(gate);
    if (!run) return exit_check_failed;
    run->record.slack = gate.slack.value_or(usual_slack);
    for (const std::string& line : run->wrong) warn("wrong answers: " + line);
    if (!run->wrong.empty()) return exit_check_failed;
    const std::string text = to_json(run->record);
    input::write_output(gate.file, text);
    if (json)
        fmt::print("{}", text);
    else
        fmt::print("{}: {} ratios of {} rounds\n", gate.file, run->record.rows.size(), gate.rounds);
    return exit_done;
}

/// Throws std::runtime_error, one line that says how to write it again.
measure::FigureRecord read_baseline(const std::string& file) {
    try {
        return measure::read_record(file, studies::speed_kind);
    } catch (const std::runtime_error& problem) {
        throw std::runtime_error(fmt::format("{}; write the baseline again with --write", problem.what()));
    }
}

/// Measures groups again while something in them seems slower. Null when it was stopped.
std::optional<measure::RecordComparison> settled(const measure::FigureRecord& baseline,
                                                 const GateArguments& gate, studies::GateRun& run) {
    measure::RecordComparison found = studies::compare_speed(baseline, run.record);
    for (int look = 0; look < second_looks && found.count(measure::Outcome::worse) > 0; ++look) {
        const auto again = measure_gate(gate, studies::suspect_groups(found));
        if (!again) return std::nullopt;
        studies::look_again(run.record, found, again->record);
        found = studies::compare_speed(baseline, run.record);
    }
    return found;
}

int compare_with_baseline(const GateArguments& gate, bool json) {
    measure::FigureRecord baseline = asked_of(read_baseline(gate.file), gate);
    say_how_quiet(gate.waits, json);
    if (gate.slack) baseline.slack = gate.slack;
    if (const std::string& of = baseline.condition("queries", gate.file); of != std::to_string(gate.queries))
        throw std::invalid_argument(fmt::format("{} is of {} queries a pass, not {}: give --queries {}",
                                                gate.file, of, gate.queries, of));
    auto run = measure_gate(gate);
    if (!run) return exit_check_failed;
    auto found = settled(baseline, gate, *run);
    if (!found) return exit_check_failed;
    for (const std::string& line : run->wrong) found->faults.push_back("wrong answers: " + line);
    return print_comparison(*found, gate.file, json);
}

int run_gate(const GateArguments& gate, bool json) {
    return gate.write ? write_baseline(gate, json) : compare_with_baseline(gate, json);
}

void add_gate(CLI::App& bench, Context& context) {
    auto [command, gate] = add_command(
        bench, context, "gate",
        "This build's speed compared with a baseline; exit code 1 where queries are slower", run_gate);
    command->add_option("file", gate.file, "file of the baseline")->required();
    command->add_flag("--write", gate.write, "write the baseline instead");
    add_queries_option(*command, gate.queries);
    add_rounds_option(*command, gate.rounds,
                      {static_cast<std::uint64_t>(measure::least_sample(0.95)), 10'000, "rounds"});
    add_slack_option(*command, gate.slack,
                     fmt::format(" (else the baseline's; {} where it is written)", usual_slack));
    add_layouts_option(*command, gate.layouts);
    add_wait_option(*command, gate.waits);
}

int run_model(const ModelArguments& options, bool json) {
    const studies::SingleCell cell(options.cell);
    const nlohmann::json rows = studies::model_speeds(cell, options.repetitions);
    if (json)
        print_json(nlohmann::json({{"bench", rows}}));
    else
        fmt::print("{}", reports::rows_text(
                             rows, "what|trace|#accesses|#million per s = accesses_per_second 1000000 1"));
    return exit_done;
}

}  // namespace

void add_bench(CLI::App& app, Context& context) {
    CLI::App& bench = add_group(app, "bench", "Speed and work of queries, and of the measuring itself");
    add_gate(bench, context);
    add_effort(bench, context);
    add_crosscheck(bench, context);
    add_scaling(bench, context);
    add_calibrate(bench, context);
    auto [command, options] = add_command(bench, context, "model",
                                          "How fast the cache model and the reuse distances are", run_model);
    add_cell_options(*command, options.cell);
    add_count(*command, "--repetitions", options.repetitions, {1, 1000, "repetitions"},
              "repetitions of each measurement; the median is printed");
}

}  // namespace edgewise::cli
