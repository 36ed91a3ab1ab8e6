// SPDX-License-Identifier: MIT
#include "edgewise/cli/parts/bench_gate.hpp"
#include "edgewise/cli/number_option.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "edgewise/cli/terminal/progress.hpp"
#include "edgewise/input/output_file.hpp"
#include "edgewise/measure/statistics.hpp"
#include "edgewise/studies/gate/file.hpp"
#include "edgewise/studies/gate/run.hpp"
#include "edgewise/studies/gate/verdict.hpp"

namespace edgewise::cli {

namespace {

using studies::GateReport;
using studies::GateRow;
using studies::GateVerdict;

constexpr double usual_slack = 0.1;
constexpr std::size_t shown_rows = 20;  ///< and every one that fails
constexpr int second_looks = 2;         ///< at what seems slower

/// Of these groups; of all where none is named.
std::optional<studies::GateRun> measure_gate(const GateArguments& gate, std::size_t queries,
                                             const std::vector<std::string>& groups = {}) {
    const studies::GatePlan plan{bench::select_table_types(gate.layouts), gate.rounds, queries, groups};
    Progress progress(groups.empty() ? "gate" : "gate, a second look",
                      groups.empty() ? studies::gate_groups().size() : groups.size());
    return studies::run_gate(
        plan, [&](const std::string& group) { progress.advance(1, group); }, stop_on_signals());
}

/// Only of table types that were asked for, and of references: others are not missing.
studies::GateRecord asked_of(studies::GateRecord baseline, const GateArguments& gate) {
    const auto types = bench::select_table_types(gate.layouts);
    const bool all = std::find(gate.layouts.begin(), gate.layouts.end(), "all") != gate.layouts.end();
    std::erase_if(baseline.entries, [&](const studies::GateEntry& entry) {
        const auto is_its_type = [&](const bench::TableType* type) { return type->name == entry.table; };
        return !all && entry.over != studies::GateOver::kernel &&
               std::none_of(types.begin(), types.end(), is_its_type);
    });
    return baseline;
}

nlohmann::json json_of(const studies::GateRatio& ratio) {
    return {{"ratio", ratio.value}, {"low", ratio.low}, {"high", ratio.high}};
}

nlohmann::json json_of(const GateReport& report, const studies::GateRun& run, double slack) {
    nlohmann::json rows = nlohmann::json::array();
    for (const GateRow& row : report.rows) {
        rows.push_back({{"entry", row.now.name()},
                        {"over", row.now.over == studies::GateOver::kernel ? "kernel" : "reference"},
                        {"baseline", json_of(row.baseline)},
                        {"now", json_of(row.now.ratio)},
                        {"change", row.change()},
                        {"verdict", to_string(row.verdict)}});
    }
    return {{"passed", report.passed() && run.wrong.empty()},
            {"slack", slack},
            {"compared", rows},
            {"missing", report.missing},
            {"added", report.added},
            {"notes", report.notes},
            {"wrong_answers", run.wrong}};
}

void print_row(const GateRow& row) {
    const studies::GateRatio& now = row.now.ratio;
    const std::string measured = fmt::format("{:.4g} [{:.4g}, {:.4g}]", now.value, now.low, now.high);
    fmt::print("{:<52} {:<9} {:>9.4g} {:>26} {:>7.3f}  {}\n", row.now.name(),
               row.now.over == studies::GateOver::kernel ? "kernel" : "reference", row.baseline.value,
               measured, row.change(), row.verdict == GateVerdict::same ? "" : to_string(row.verdict));
}

void print_names(const char* what, const std::vector<std::string>& names) {
    for (const std::string& name : names) fmt::print("{}: {}\n", what, name);
}

void print(const GateReport& report, const studies::GateRun& run, double slack, const std::string& file) {
    const std::size_t slower = report.count(GateVerdict::slower);
    const std::size_t shown = std::min(std::max(slower, shown_rows), report.rows.size());
    fmt::print("{:<52} {:<9} {:>9} {:>26} {:>7}\n", "worst first", "over", "baseline", "now [95 %]",
               "change");
    for (std::size_t i = 0; i < shown; ++i) print_row(report.rows[i]);
    if (shown < report.rows.size()) fmt::print("and {} more; --json has all\n", report.rows.size() - shown);
    print_names("missing now", report.missing);
    print_names("not in the baseline", report.added);
    print_names("note", report.notes);
    print_names("wrong answers", run.wrong);
    fmt::print("{} compared with {}: {} slower by more than {:.0f} %, {} faster, {} missing, {} new\n",
               report.rows.size(), file, slower, 100 * slack, report.count(GateVerdict::faster),
               report.missing.size(), report.added.size());
    if (report.rows.empty()) fmt::print("nothing in common: no check\n");
}

int write_baseline(const GateArguments& gate, std::size_t queries, bool json) {
    static_cast<void>(input::output_place(gate.file));  // refused before minutes of measuring
    auto run = measure_gate(gate, queries);
    if (!run) return exit_check_failed;
    run->record.slack = gate.slack.value_or(usual_slack);
    if (!run->wrong.empty()) {
        for (const std::string& line : run->wrong) warn("wrong answers: " + line);
        return exit_check_failed;
    }
    studies::write_gate(gate.file, run->record);
    if (json) {
        print_json(gate_json(run->record));
    } else {
        fmt::print("{}: {} ratios of {} rounds on {}\n", gate.file, run->record.entries.size(),
                   run->record.rounds, run->record.machine);
    }
    return exit_done;
}

/// Measures groups again while something in them seems slower. Null when it was stopped.
std::optional<GateReport> settled_report(const studies::GateRecord& baseline, const GateArguments& gate,
                                         studies::GateRun& run, double slack) {
    GateReport report = compare_gate(baseline, run.record, slack);
    for (int look = 0; look < second_looks && report.count(GateVerdict::slower) > 0; ++look) {
        const auto again = measure_gate(gate, run.record.queries, studies::suspect_groups(report));
        if (!again) return std::nullopt;
        studies::look_again(run.record, report, again->record);
        report = compare_gate(baseline, run.record, slack);
    }
    return report;
}

int compare_with_baseline(const GateArguments& gate, std::size_t queries, bool json) {
    const studies::GateRecord baseline = asked_of(studies::read_gate(gate.file).or_throw(), gate);
    if (baseline.queries != queries)
        throw std::invalid_argument(fmt::format("{} is of {} queries a pass, not {}: give --queries {}",
                                                gate.file, baseline.queries, queries, baseline.queries));
    auto run = measure_gate(gate, queries);
    if (!run) return exit_check_failed;
    const double slack = gate.slack.value_or(baseline.slack);
    const auto settled = settled_report(baseline, gate, *run, slack);
    if (!settled) return exit_check_failed;
    const GateReport& report = *settled;
    if (json) {
        print_json(json_of(report, *run, slack));
    } else {
        print(report, *run, slack, gate.file);
    }
    return report.passed() && run->wrong.empty() ? exit_done : exit_check_failed;
}

}  // namespace

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

int run_gate_command(const GateArguments& gate, std::size_t queries, bool json) {
    return gate.write ? write_baseline(gate, queries, json) : compare_with_baseline(gate, queries, json);
}

}  // namespace edgewise::cli
