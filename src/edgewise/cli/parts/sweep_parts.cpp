// SPDX-License-Identifier: MIT
#include "edgewise/cli/parts/sweep_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/cli/command.hpp"
#include "edgewise/cli/terminal/progress.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/store/schema.hpp"
#include "edgewise/studies/effort_rows.hpp"
#include "edgewise/studies/fields/fields_rows.hpp"
#include "edgewise/studies/paging_rows.hpp"
#include "edgewise/studies/parts/expected_seconds.hpp"
#include "edgewise/studies/parts/sharded_work.hpp"
#include "edgewise/studies/thrash/thrash_rows.hpp"
#include "edgewise/sweep/stored_cells.hpp"

namespace edgewise::cli {

namespace {

using OnCells = std::function<void(std::size_t cells)>;
/// A part calls this when one of its rows is done.
using OnRow = std::function<void(const std::string& what)>;

struct Part {
    std::string name;
    std::size_t rows = 0;
    double seconds_each = 0;                ///< expected, of a row
    std::function<bool(const OnRow&)> run;  ///< false: stopped
    bool remembered = false;                ///< an earlier run measured the seconds

    [[nodiscard]] std::string key() const { return fmt::format("part {} {}", name, rows); }
    [[nodiscard]] std::string kind() const { return remembered ? sweep::TimeLeft::last_run : name; }
};

studies::StabilityPlan stability_plan(const sweep::SweepWork& work) {
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
    return plan;
}

studies::PagingPlan paging_plan(const sweep::Plan& of) {
    studies::PagingPlan plan;
    plan.bodies = of.paging;
    plan.seed = of.seed;
    return plan;
}

studies::EffortPlan effort_plan(const sweep::SweepWork& work) {
    const std::string machines[] = {studies::effort_machine};
    studies::EffortPlan plan{studies::effort_cell, work.types, work.peers, work.algorithms,
                             measure::choose_machines(machines).front()};
    plan.cell.queries = work.plan.effort;
    plan.cell.checked = std::min(work.plan.checked, work.plan.effort);
    plan.cell.seed = work.plan.seed;
    return plan;
}

constexpr const char* stability_part_name = "stability";

Part stability_part(const sweep::SweepWork& work, store::Store& store, studies::StabilitySummary& stability) {
    auto of = stability_plan(work);
    of.stored = [&store, build = bench::this_build().id](
                    const std::string& hash) -> std::optional<studies::StabilityRow> {
        auto row = store.find_cell(build, hash);
        if (!row) return std::nullopt;
        return studies::StabilityRow{*std::move(row), store.figures(build, hash)};
    };
    return {stability_part_name, studies::stability_rows(of),
            studies::stability_case_seconds * static_cast<double>(work.plan.stability),
            [=, &store, &stability](const OnRow& on_row) {
                stability = store_stability(of, store, [&](const studies::StabilityRow& row) {
                    on_row(row.cell.shape + " " + row.cell.table);
                });
                return !stability.stopped;
            }};
}

Part paging_part(const sweep::Plan& plan, store::Store& store) {
    return {
        studies::paging_unit, studies::paging_rows(), studies::paging_row_seconds, [&](const OnRow& on_row) {
            return studies::run_paging(
                paging_plan(plan), bench::this_build().id, store,
                [&](const store::CellRow& row) { on_row(row.shape + " " + row.table); }, stop_on_signals());
        }};
}

Part thrash_part(const studies::thrash::Levels& levels, store::Store& store) {
    return {studies::thrash_unit, studies::thrash::thrash_units(levels), studies::thrash_unit_seconds,
            [=, &store](const OnRow& on_row) {
                return studies::thrash::run_thrash(
                    levels, bench::this_build().id, store, [&] { on_row("figure 8"); }, stop_on_signals());
            }};
}

Part effort_part(const sweep::SweepWork& work, store::Store& store) {
    return {studies::effort_unit, studies::effort_rows(effort_plan(work)),
            studies::effort_query_seconds * static_cast<double>(work.plan.effort), [&](const OnRow& on_row) {
                return studies::store_effort(
                    effort_plan(work), bench::this_build().id, store,
                    [&](std::size_t, const studies::EffortRow& row) {
                        on_row(row.cell.algorithm + " " + row.cell.table);
                    },
                    stop_on_signals());
            }};
}

Part fields_part(const sweep::Plan& plan, store::Store& store) {
    const auto cells = studies::fields_cells(plan.fields, plan.seed);
    return {studies::fields_unit, cells.size(), studies::fields_cell_seconds,
            [=, &store](const OnRow& on_row) {
                return studies::store_fields(
                    cells, bench::this_build().id, store,
                    [&](const store::CellRow& row) { on_row(row.algorithm + " " + row.table); },
                    stop_on_signals());
            }};
}

/// The parts after the sweep that the plan has.
std::vector<Part> later_parts(const sweep::SweepWork& work, store::Store& store,
                              studies::StabilitySummary& stability) {
    std::vector<Part> parts;
    if (work.plan.stability > 0) parts.push_back(stability_part(work, store, stability));
    if (work.plan.paging > 0) parts.push_back(paging_part(work.plan, store));
    studies::thrash::Levels levels;
    levels.seed = work.plan.seed;
    if (work.plan.thrash && studies::thrash::has_tables(levels)) parts.push_back(thrash_part(levels, store));
    if (work.plan.effort > 0) parts.push_back(effort_part(work, store));
    if (work.plan.fields > 0) parts.push_back(fields_part(work.plan, store));
    return parts;
}

sweep::SweepListener listener_for(Progress& progress, const OnCells& on_cells) {
    sweep::SweepListener listener;
    listener.on_done = [&](std::size_t cells, const std::string& what) {
        progress.advance(cells, what);
        if (cells > 0) on_cells(cells);
    };
    listener.on_resumed = [&](std::size_t cells) {
        progress.advance(cells);
        on_cells(cells);
    };
    listener.on_warning = [&](const std::string& line) {
        progress.clear();
        warn(line);
    };
    return listener;
}

/// What the part took, for later sweeps and shards.
void store_seconds(const Part& part, double seconds, store::Store& store) {
    const std::string took = fmt::format("{:.4g}", seconds);
    store.set_meta(store::took_key + part.key(), took);
    if (part.name != stability_part_name) store.set_meta(store::took_key + part.name, took);
}

/// Returns true if it came to its end. Rows that are already stored count as resumed.
bool run_part(const Part& part, store::Store& store, sweep::TimeLeft& left, Progress& progress) {
    const measure::Stopwatch watch;
    measure::Stopwatch lap;
    std::size_t done = 0;
    const bool ended = part.run([&](const std::string& what) {
        ++done;
        left.done(part.kind(), part.seconds_each, lap.elapsed_ns() * 1e-9);
        lap.restart();
        left.end_group();
        progress.advance(1, part.name + " " + what);
    });
    if (!ended) return false;
    if (done == part.rows) store_seconds(part, watch.elapsed_ns() * 1e-9, store);
    const std::size_t earlier = part.rows - std::min(done, part.rows);
    left.skip(part.kind(), part.seconds_each * static_cast<double>(earlier));
    progress.advance(earlier);
    return true;
}

}  // namespace

PartsSummary run_parts(const sweep::SweepWork& work, store::Store& store, const OnCells& on_cells) {
    PartsSummary summary;
    std::vector<Part> parts = later_parts(work, store, summary.stability);
    std::size_t steps = work.cells();
    for (const Part& part : parts) steps += part.rows;
    sweep::TimeLeft left;
    Progress progress("sweep", steps, 0, "cells");
    progress.estimate_by([&] { return left.seconds(); });
    for (Part& part : parts) {
        const auto took = sweep::took_in(store, part.key());
        part.remembered = took && part.rows > 0;
        if (part.remembered) part.seconds_each = *took / static_cast<double>(part.rows);
        left.expect(part.kind(), part.seconds_each * static_cast<double>(part.rows));
    }
    summary.sweep = sweep::run_sweep(work, store, left, listener_for(progress, on_cells), stop_on_signals());
    summary.stopped = summary.sweep.stopped;
    for (const Part& part : parts) {
        if (!summary.stopped) summary.stopped = !run_part(part, store, left, progress);
    }
    return summary;
}

}  // namespace edgewise::cli
