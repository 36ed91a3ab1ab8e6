// SPDX-License-Identifier: MIT
//
// `edgewise bench`: how fast Edgewise's own measuring is; with --gate, whether queries became slower.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "edgewise/cli/number_option.hpp"
#include "edgewise/cli/terminal/progress.hpp"
#include "edgewise/input/output_file.hpp"
#include "edgewise/measure/statistics.hpp"
#include "edgewise/reports/tables/text_grid.hpp"
#include "edgewise/studies/gate/run.hpp"
#include "edgewise/studies/model_speed.hpp"

namespace edgewise::cli {

namespace {

struct GateArguments {
    std::string file;
    bool write = false;
    int rounds = 17;
    std::optional<double> slack;
    std::vector<std::string> layouts = {"all"};
};

struct BenchArguments {
    studies::CellChoice cell;
    int repetitions = 7;
    GateArguments gate;
};

constexpr double usual_slack = 0.1;
constexpr int second_looks = 2;  ///< at what seems slower

/// Measures these groups; all if none is named. Nothing if it was stopped.
std::optional<studies::GateRun> measure_gate(const GateArguments& gate, std::size_t queries,
                                             const std::vector<std::string>& groups = {}) {
    const studies::GatePlan plan{bench::select_table_types(gate.layouts), gate.rounds, queries, groups};
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

int write_baseline(const GateArguments& gate, std::size_t queries, bool json) {
    static_cast<void>(input::output_place(gate.file));  // refused before minutes of measuring
    auto run = measure_gate(gate, queries);
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
                                                 const GateArguments& gate, std::size_t queries,
                                                 studies::GateRun& run) {
    measure::RecordComparison found = studies::compare_speed(baseline, run.record);
    for (int look = 0; look < second_looks && found.count(measure::Outcome::worse) > 0; ++look) {
        const auto again = measure_gate(gate, queries, studies::suspect_groups(found));
        if (!again) return std::nullopt;
        studies::look_again(run.record, found, again->record);
        found = studies::compare_speed(baseline, run.record);
    }
    return found;
}

int compare_with_baseline(const GateArguments& gate, std::size_t queries, bool json) {
    measure::FigureRecord baseline = asked_of(read_baseline(gate.file), gate);
    if (gate.slack) baseline.slack = gate.slack;
    if (const std::string& of = baseline.condition("queries", gate.file); of != std::to_string(queries))
        throw std::invalid_argument(
            fmt::format("{} is of {} queries a pass, not {}: give --queries {}", gate.file, of, queries, of));
    auto run = measure_gate(gate, queries);
    if (!run) return exit_check_failed;
    auto found = settled(baseline, gate, queries, *run);
    if (!found) return exit_check_failed;
    for (const std::string& line : run->wrong) found->faults.push_back("wrong answers: " + line);
    fmt::print("{}", json ? to_json(*found) : input::shown_text(to_text(*found, gate.file)));
    return found->exit_code();
}

/// Options that only the gate has, and those that it does not take.
void add_gate_options(CLI::App& command, GateArguments& gate) {
    CLI::Option* file = command.add_option(
        "--gate", gate.file, "compare this build's speed with the baseline in FILE; exit code 1 if slower");
    for (const char* other : {"--table", "--algorithm", "--scene", "--shape", "--seed", "--parameter",
                              "--needs", "--margin", "--repetitions"})
        file->excludes(command.get_option(other));
    command.add_flag("--write", gate.write, "write the baseline into the gate's FILE")->needs(file);
    add_count(command, "--rounds", gate.rounds,
              {static_cast<std::uint64_t>(measure::least_sample(0.95)), 10'000, "rounds"},
              "of the gate; each is a ratio")
        ->needs(file);
    add_number(command, "--slack", gate.slack, {0, 100},
               fmt::format("by how much a ratio of the gate may grow (else the FILE's; {} where it is "
                           "written)",
                           usual_slack))
        ->needs(file);
    command.add_option("--layouts", gate.layouts, "table types that the gate measures")
        ->delimiter(',')
        ->needs(file);
}

int run_bench(const BenchArguments& options, bool json) {
    if (!options.gate.file.empty())
        return options.gate.write ? write_baseline(options.gate, options.cell.queries, json)
                                  : compare_with_baseline(options.gate, options.cell.queries, json);
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
