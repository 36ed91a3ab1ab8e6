// SPDX-License-Identifier: MIT
#include "edgewise/cli/parts/sweep_parts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "edgewise/cli/command.hpp"
#include "edgewise/cli/terminal/progress.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/store/schema.hpp"
#include "edgewise/sweep/expected_work.hpp"
#include "edgewise/sweep/stored_cells.hpp"
#include "edgewise/sweep/study.hpp"

namespace edgewise::cli {

namespace {

using OnCells = std::function<void(std::size_t cells)>;

/// A study of the work, and the seconds that are expected of a row.
struct Part {
    const sweep::Study* study;
    std::size_t rows;
    double seconds_each;
    bool remembered;  ///< an earlier run measured the seconds

    [[nodiscard]] std::string name() const { return std::string(study->name); }
    [[nodiscard]] std::string key() const { return fmt::format("part {} {}", study->name, rows); }
    [[nodiscard]] std::string kind() const { return remembered ? sweep::TimeLeft::last_run : name(); }
    [[nodiscard]] double seconds() const { return seconds_each * static_cast<double>(rows); }
};

/// Returns the studies that the plan asks for.
std::vector<Part> parts_of(const sweep::SweepWork& work, const store::Store& store) {
    std::vector<Part> parts;
    for (const sweep::Study& study : sweep::registered_studies()) {
        if (!has_rows(study, work)) continue;
        Part part{&study, study.rows(work), study.seconds_each(work), false};
        if (const auto took = sweep::took_in(store, part.key())) {
            part.seconds_each = *took / static_cast<double>(part.rows);
            part.remembered = true;
        }
        parts.push_back(part);
    }
    return parts;
}

sweep::SweepListener listener_for(Progress& progress, const OnCells& on_cells) {
    sweep::SweepListener listener;
    listener.on_done = [&](std::size_t cells, const std::string& what) {
        progress.advance(cells, what);
        if (cells > 0) on_cells(cells);
    };
    listener.on_warning = [&](const std::string& line) {
        progress.clear();
        warn(line);
    };
    return listener;
}

/// What the part took, for later sweeps and shards; a study in parts keeps the seconds of each part itself.
void store_seconds(const Part& part, double seconds, store::Store& store) {
    const std::string took = fmt::format("{:.4g}", seconds);
    store.set_meta(store::took_key + part.key(), took);
    if (!part.study->parts) store.set_meta(store::took_key + part.name(), took);
}

/// Returns true if the study came to its end. Rows that it does not report count as resumed.
bool run_part(const Part& part, const sweep::SweepWork& work, store::Store& store, sweep::TimeLeft& left,
              Progress& progress, StudyCounts& counts) {
    const measure::Stopwatch watch;
    measure::Stopwatch lap;
    const auto on_row = [&](const std::string& what, store::CellStatus status) {
        ++counts.rows;
        counts.failed += status == store::CellStatus::failed;
        counts.unavailable += status == store::CellStatus::unavailable;
        left.done(part.kind(), part.seconds_each, lap.elapsed_ns() * 1e-9);
        lap.restart();
        left.end_group();
        progress.advance(1, part.name() + " " + what);
    };
    store_chapter(*part.study, store);
    if (!part.study->run(work, store, on_row, stop_on_signals())) return false;
    if (counts.rows == part.rows) store_seconds(part, watch.elapsed_ns() * 1e-9, store);
    const std::size_t earlier = part.rows - std::min(counts.rows, part.rows);
    left.skip(part.kind(), part.seconds_each * static_cast<double>(earlier));
    progress.advance(earlier);
    return true;
}

}  // namespace

StudyCounts PartsSummary::all_studies() const {
    StudyCounts all;
    for (const auto& [name, counts] : studies) {
        all.rows += counts.rows;
        all.failed += counts.failed;
        all.unavailable += counts.unavailable;
    }
    return all;
}

PartsSummary run_parts(const sweep::SweepWork& work, store::Store& store, const OnCells& on_cells) {
    PartsSummary summary;
    const std::vector<Part> parts = parts_of(work, store);
    std::size_t steps = work.cells();
    sweep::TimeLeft left;
    for (const Part& part : parts) {
        steps += part.rows;
        left.expect(part.kind(), part.seconds());
    }
    Progress progress("sweep", steps, 0, "cells");
    progress.estimate_by([&] { return left.seconds(); });
    summary.sweep = sweep::run_sweep(work, store, left, listener_for(progress, on_cells), stop_on_signals());
    summary.stopped = summary.sweep.stopped;
    for (const Part& part : parts) {
        if (summary.stopped) break;
        StudyCounts counts;
        summary.stopped = !run_part(part, work, store, left, progress, counts);
        if (counts.rows > 0) summary.studies[part.name()] = counts;
    }
    return summary;
}

}  // namespace edgewise::cli
