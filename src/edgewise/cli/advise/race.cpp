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

constexpr const char* no_time = "no time was left (--time)";

class Race {
  public:
    Race(const CaseAsked& asked, const std::vector<ScreenedCell>& finalists, const RaceOptions& options)
        : asked_(asked), finalists_(finalists), named_(options.machines), seconds_(options.seconds) {}

    /// Machines that were named are modelled by the first process, this one for the prediction by the last.
    Finals run() {
        if (!named_.empty()) drop_what_does_not_fit();
        sweep_ = sweep_of(finalists_);
        const RacePlan plan = studies::advise::race_within(seconds_, cost());
        sweep_.rounds = plan.rounds;
        int ended = 0;
        std::string problem;
        while (ended < plan.processes && problem.empty()) {
            sweep_.times_in_cache = ended == 0;
            sweep_.machines.clear();
            if (ended == 0) sweep_.machines = named_;
            if (ended + 1 == plan.processes && !names_this_machine())
                sweep_.machines.emplace_back(studies::advise::this_machine);
            sweep_.traces = !sweep_.machines.empty();
            sweep_.store = folder_.file(std::to_string(ended) + ".db");
            problem = run_process();
            if (problem.empty()) ++ended;
        }
        Finals finals = studies::advise::ranked_finals(std::move(found_), asked_.error_limit);
        finals.processes = ended;
        finals.problem = problem;
        return finals;
    }

  private:
    [[nodiscard]] double seconds_left() const { return seconds_ - watch_.elapsed_ns() * 1e-9; }

    [[nodiscard]] bool names_this_machine() const {
        return std::ranges::find(named_, studies::advise::this_machine) != named_.end();
    }

    /// Of the slowest finalists first; the fastest and the baseline stay: fewer cells on the machines that
    /// were named rather than none.
    void drop_what_does_not_fit() {
        while (studies::advise::race_seconds(cost(), studies::advise::least_race) > seconds_) {
            const auto slowest = std::find_if(finalists_.rbegin(), finalists_.rend(), [&](const auto& cell) {
                return !cell.is_baseline() && &cell != &finalists_.front();
            });
            if (slowest == finalists_.rend()) return;
            finalists_.erase(std::prev(slowest.base()));
        }
    }

    /// By what the first look took. A traced query takes about 60 times as long, and as long again for the
    /// caches of each machine; processors share that.
    [[nodiscard]] RaceCost cost() const {
        constexpr double traced_over_timed = 60, checks_over_first_look = 2;
        RaceCost cost;
        for (const ScreenedCell& cell : finalists_) {
            cost.process += checks_over_first_look * cell.seconds;
            cost.round += cell.ns * 1e-9 * static_cast<double>(sweep_.queries);
        }
        const double traces = traced_over_timed * (2 + static_cast<double>(named_.size()));
        cost.traces = traces * cost.round / std::max(1U, std::thread::hardware_concurrency());
        return cost;
    }

    /// Empty, or why it did not come to its end.
    std::string run_process() {
        if (seconds_left() <= 0) return no_time;
        const auto run = measure::run_program(command_of(sweep_, asked_, folder_, seconds_left()));
        if (!run.value) return run.reason;
        if (run.value->exit_code != 0) return seconds_left() <= 0 ? no_time : run.value->err;
        take(reports::read_report(sweep_.store));
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
