// SPDX-License-Identifier: MIT
#include "edgewise/cli/advise/race.hpp"

#include <algorithm>
#include <thread>

#include "edgewise/cli/advise/race_sweep.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/measure/process/child_process.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/reports/answer/candidate.hpp"
#include "edgewise/studies/advise/level_latency.hpp"

namespace edgewise::cli {

namespace {

using studies::advise::CaseAsked;
using studies::advise::Finalist;
using studies::advise::Finals;
using studies::advise::RaceCost;
using studies::advise::RacePlan;
using studies::advise::ScreenedCell;

/// Of the race's time, a process that models machines is planned to take one.
constexpr double parts = 8;

constexpr const char* no_time = "no time was left (--time)";

/// By what the first look took. A traced query takes about 60 times as long, and as long again for the
/// caches of each machine; processors share that. A sweep is of every table with every algorithm of the
/// finalists.
RaceCost cost_of(const std::vector<ScreenedCell>& finalists, std::size_t machines) {
    constexpr double traced_over_timed = 60, checks_over_first_look = 2;
    const RaceSweep sweep = sweep_of(finalists);
    const double swept = static_cast<double>(sweep.tables.size() * sweep.algorithms.size()) /
                         static_cast<double>(finalists.size());
    RaceCost cost;
    for (const ScreenedCell& cell : finalists) {
        cost.process += swept * checks_over_first_look * cell.seconds;
        cost.round += swept * cell.ns * 1e-9 * static_cast<double>(sweep.queries);
    }
    cost.traces = traced_over_timed * static_cast<double>(1 + std::max<std::size_t>(machines, 1)) *
                  cost.round / std::max(1U, std::thread::hardware_concurrency());
    return cost;
}

class Race {
  public:
    Race(const CaseAsked& asked, const std::vector<ScreenedCell>& finalists, const RaceOptions& options)
        : asked_(asked),
          finalists_(finalists),
          named_(options.machines),
          seconds_(options.seconds),
          sweep_(sweep_of(finalists)) {}

    Finals run() {
        std::string problem = named_.empty() ? "" : model_named_machines();
        RacePlan plan = studies::advise::race_within(seconds_left(), cost_of(finalists_, named_.size()));
        plan.processes = std::min(plan.processes, studies::advise::whole_race.processes - ended_);
        const bool hosts_caches = std::ranges::find(named_, studies::advise::this_machine) == named_.end();
        for (int left = plan.processes; left > 0 && problem.empty(); --left) {
            sweep_.rounds = plan.rounds;
            sweep_.times_in_cache = left == plan.processes;
            sweep_.machines.clear();
            if (left == 1 && hosts_caches) sweep_.machines = {studies::advise::this_machine};
            problem = run_process(seconds_left());
        }
        Finals finals = studies::advise::ranked_finals(std::move(found_), asked_.error_limit);
        finals.processes = ended_;
        finals.problem = problem;
        return finals;
    }

  private:
    [[nodiscard]] double seconds_left() const { return seconds_ - watch_.elapsed_ns() * 1e-9; }

    /// A process before all others. Fewer cells on the machines that were named are better than none: the
    /// slowest finalists are dropped until the process is expected to take a small part of the time, for
    /// others may keep the processors busy; where it takes too long all the same, it is begun again with the
    /// fastest and the baseline.
    std::string model_named_machines() {
        sweep_.machines = named_;
        while (expected_seconds(studies::advise::least_race) > seconds_ / parts && drop_slowest()) continue;
        std::string problem = model_within(seconds_ / 2);
        if (problem.empty()) return problem;
        while (drop_slowest()) continue;
        return model_within(seconds_left());
    }

    std::string model_within(double seconds) {
        const bool has_time = expected_seconds(studies::advise::whole_race) < seconds_ / parts;
        sweep_.rounds = (has_time ? studies::advise::whole_race : studies::advise::least_race).rounds;
        const RaceSweep chosen = sweep_of(finalists_);
        sweep_.tables = chosen.tables;
        sweep_.algorithms = chosen.algorithms;
        return run_process(seconds);
    }

    /// Of one process that traces.
    [[nodiscard]] double expected_seconds(const RacePlan& plan) const {
        const RaceCost one = cost_of(finalists_, named_.size());
        return one.process + plan.rounds * one.round + one.traces;
    }

    /// The fastest and the baseline stay; false where there is nothing else.
    bool drop_slowest() {
        const auto slowest = std::find_if(finalists_.rbegin(), finalists_.rend(), [&](const auto& cell) {
            return !cell.is_baseline() && &cell != &finalists_.front();
        });
        if (slowest == finalists_.rend()) return false;
        finalists_.erase(std::prev(slowest.base()));
        return true;
    }

    /// Empty, or why it did not come to its end.
    std::string run_process(double seconds) {
        if (seconds <= 0) return no_time;
        sweep_.traces = !sweep_.machines.empty();
        sweep_.store = folder_.file(std::to_string(++begun_) + ".db");
        const measure::Stopwatch watch;
        const auto run = measure::run_program(command_of(sweep_, asked_, folder_, seconds));
        if (!run.value) return run.reason;
        if (run.value->exit_code != 0) return watch.elapsed_ns() * 1e-9 >= seconds ? no_time : run.value->err;
        take(reports::read_report(sweep_.store));
        ++ended_;
        return "";
    }

    /// Found before, or new.
    Finalist& finalist(const reports::ReportCell& cell, const reports::Candidate& candidate) {
        const auto known = std::ranges::find_if(
            found_, [&](const Finalist& one) { return one.is(cell.algorithm, candidate.table); });
        if (known != found_.end()) return *known;
        Finalist& added = found_.emplace_back();
        added.algorithm = cell.algorithm;
        added.table = candidate.table;
        return added;
    }

    /// What the process measured.
    void take(const reports::ReportData& data) {
        for (const reports::ReportCell* cell : data.swept()) {
            const auto measured = reports::candidate_of(*cell, asked_.error_limit);
            if (!measured || !measured->worst_error || !measured->bytes_per_edge || !measured->table_bytes)
                continue;
            Finalist& one = finalist(*cell, *measured);
            if (cell->scene == small_scene) one.in_cache_ns = measured->ns;
            if (cell->scene != case_scene) continue;
            one.ratios.push_back(measured->ratio);
            one.ns.push_back(measured->ns);
            one.error = *measured->worst_error;
            one.bytes_per_edge = *measured->bytes_per_edge;
            one.table_bytes = *measured->table_bytes;
            one.steps = measured->steps.value_or(0);
            if (!sweep_.traces) continue;
            one.lines = measured->lines_per_query;
            take_misses(*cell, one);
        }
    }

    /// Of the asked machines and of this one; of a machine that does not tell its caches none.
    void take_misses(const reports::ReportCell& cell, Finalist& one) const {
        for (const measure::MachineChoice& choice : measure::choose_machines(sweep_.machines)) {
            if (!choice.machine.value) continue;
            constexpr store::FigureName misses("caches.{machine}.{level}.misses_per_query");
            std::vector<double> levels;
            for (const measure::LevelGeometry& level : choice.machine.value->caches.levels)
                if (const auto value = cell.figure(misses.of(choice.name, level.name)).value)
                    levels.push_back(*value);
            if (!levels.empty() && levels.size() == choice.machine.value->caches.levels.size())
                one.misses[choice.name] = levels;
        }
    }

    const CaseAsked& asked_;
    std::vector<ScreenedCell> finalists_;
    std::vector<std::string> named_;  ///< machines
    double seconds_;
    RaceSweep sweep_;  ///< of the process in hand
    WorkFolder folder_;
    measure::Stopwatch watch_;
    std::vector<Finalist> found_;
    int begun_ = 0, ended_ = 0;  ///< processes
};

}  // namespace

Finals run_race(const CaseAsked& asked, const std::vector<ScreenedCell>& finalists,
                const RaceOptions& options) {
    Finals finals = Race(asked, finalists, options).run();
    if (const auto host = measure::host_machine(); host.value && finals.processes > 0)
        studies::advise::predict(finals, studies::advise::latencies_beyond_first(*host.value));
    return finals;
}

}  // namespace edgewise::cli
