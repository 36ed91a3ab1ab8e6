// SPDX-License-Identifier: MIT
#include "edgewise/cli/parts/sweep_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/cli/command.hpp"
#include "edgewise/cli/terminal/progress.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/store/schema.hpp"
#include "edgewise/studies/effort_rows.hpp"
#include "edgewise/studies/paging_rows.hpp"
#include "edgewise/studies/parts/sharded_work.hpp"
#include "edgewise/studies/thrash/thrash_rows.hpp"

namespace edgewise::cli {

namespace {

sweep::SweepSummary run_with_progress(const sweep::SweepWork& work, store::Store& store) {
    std::unique_ptr<Progress> progress;
    sweep::SweepListener listener;
    listener.on_start = [&](std::size_t cells) { progress = std::make_unique<Progress>("sweep", cells); };
    listener.on_done = [&](std::size_t cells, const std::string& what) { progress->advance(cells, what); };
    listener.on_warning = [&](const std::string& line) {
        if (progress) progress->clear();
        warn(line);
    };
    return sweep::run_sweep(work, store, listener, stop_on_signals());
}

/// The hard families, if the plan has them, over the sweep's table types and algorithms.
studies::StabilitySummary run_stability_of(const sweep::SweepWork& work, store::Store& store) {
    if (work.plan.stability == 0) return {};
    studies::StabilityPlan plan;
    plan.count = plan.proofs = work.plan.stability;
    plan.seed = work.plan.seed;
    plan.raw = work.plan.control;
    plan.types = work.types;
    plan.algorithms = work.algorithms;
    plan.families = work.families;
    for (const scene::NamedShape& shape : work.shapes) {
        if (shape.error.empty() && shape.source != "built-in") plan.real.push_back(shape.body);
    }
    const std::string build = bench::this_build().id;
    plan.stored = [&store, build](const std::string& hash) -> std::optional<studies::StabilityRow> {
        auto row = store.find_cell(build, hash);
        if (!row) return std::nullopt;
        return studies::StabilityRow{*std::move(row), store.figures(build, hash)};
    };
    return store_stability(plan, store, {});
}

/// Under memory limits, if the plan has it.
void run_paging_of(const sweep::Plan& of, store::Store& store, bool& stopped) {
    if (of.paging == 0) return;
    studies::PagingPlan plan;
    plan.bodies = of.paging;
    plan.seed = of.seed;
    Progress progress("paging", studies::paging_rows());
    stopped = !studies::run_paging(
        plan, bench::this_build().id, store,
        [&](const store::CellRow& row) { progress.advance(1, row.shape + " " + row.table); },
        stop_on_signals());
}

/// What could have made figure 8, if the plan asks and this program has the table types.
void run_thrash_of(const sweep::Plan& of, store::Store& store, bool& stopped) {
    studies::thrash::Levels levels;
    levels.seed = of.seed;
    if (!of.thrash || !studies::thrash::has_tables(levels)) return;
    Progress progress("thrash", studies::thrash::thrash_units(levels));
    stopped = !studies::thrash::run_thrash(
        levels, bench::this_build().id, store, [&] { progress.advance(1, "figure 8"); }, stop_on_signals());
}

/// What the queries take, of the sweep's table types, algorithms and peers, if the plan has it.
void run_effort_of(const sweep::SweepWork& work, store::Store& store, bool& stopped) {
    if (work.plan.effort == 0) return;
    const std::string machines[] = {studies::effort_machine};
    studies::EffortPlan plan{studies::effort_cell, work.types, work.peers, work.algorithms,
                             measure::choose_machines(machines).front()};
    plan.cell.queries = work.plan.effort;
    plan.cell.checked = std::min(work.plan.checked, work.plan.effort);
    plan.cell.seed = work.plan.seed;
    Progress progress("effort", studies::effort_rows(plan));
    stopped = !studies::store_effort(
        plan, bench::this_build().id, store,
        [&](std::size_t, const studies::EffortRow& row) {
            progress.advance(1, row.cell.algorithm + " " + row.cell.table);
        },
        stop_on_signals());
}

/// The run, unless an earlier one was stopped; its seconds are kept when it was not.
template <class Run>
void timed(const char* unit, bool asked, store::Store& store, bool& stopped, const Run& run) {
    if (!asked || stopped) return;
    const measure::Stopwatch watch;
    run();
    if (!stopped)
        store.set_meta(store::took_key + std::string(unit), fmt::format("{:.3f}", watch.elapsed_ns() * 1e-9));
}

}  // namespace

SweepOutcome run_all(const sweep::SweepWork& work, store::Store& store) {
    SweepOutcome outcome;
    outcome.sweep = run_with_progress(work, store);
    outcome.stopped = outcome.sweep.stopped;
    if (!outcome.stopped) outcome.stability = run_stability_of(work, store);
    outcome.stopped = outcome.stopped || outcome.stability.stopped;
    bool& stopped = outcome.stopped;
    const sweep::Plan& plan = work.plan;
    timed(studies::paging_unit, plan.paging > 0, store, stopped,
          [&] { run_paging_of(plan, store, stopped); });
    timed(studies::thrash_unit, plan.thrash, store, stopped, [&] { run_thrash_of(plan, store, stopped); });
    timed(studies::effort_unit, plan.effort > 0, store, stopped,
          [&] { run_effort_of(work, store, stopped); });
    return outcome;
}

}  // namespace edgewise::cli
