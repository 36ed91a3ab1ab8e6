// SPDX-License-Identifier: MIT
#include <map>
#include <utility>

#include "edgewise/probes/time.hpp"
#include "edgewise/store/rows.hpp"
#include "edgewise/store/schema.hpp"
#include "edgewise/store/store.hpp"
#include "frozen.hpp"

namespace edgewise::golden {

namespace {

constexpr const char* plan = R"({"scenes": [{"name": "cold"}, {"name": "static"},
    {"name": "tumble", "parameters": {"rotation_step": 0.01}}],
    "shapes": ["cube8", "sphere38"], "meshes": [],
    "layouts": ["aos_f64", "aos_f32", "lean_f32", "points_soa_f64"], "algorithms": ["vclip", "gjk"],
    "axes": [], "machines": ["pentium3_katmai", "zen2"], "queries": 200, "checked": 40,
    "rounds": 1, "stability": 2})";

store::StoredBuild merged_build(const cli_test::Folder& folder) {
    folder.write("plan.json", plan);
    for (const std::string part : {"0", "1"}) {
        output_of(
            {"sweep", "--plan", "plan.json", "--shard", part + "/2", "--probes", "bytes", "lines", "caches",
             "reuse", "heat", "work", "error", "--caches", "all", "--no-report", "--store", part + ".db"},
            folder);
    }
    output_of({"merge", "0.db", "1.db", "--out", "merged.db"}, folder);
    return store::read_build(folder / "merged.db");
}

store::BuildRow golden_build() {
    return {"golden",
            "a revision",
            "a compiler",
            "-O3",
            "Release",
            R"({"cpu": "a processor", "counters": [{"event": "cycles", "status": "unavailable", "errno": 2,
            "reason": "no counters here", "remedy": "another machine"}]})"};
}

/// Meta without dates and seconds.
std::string golden_meta(const std::string& key, const std::string& value) {
    if (key == "build" || key.starts_with(store::command_key)) return golden_build().id;
    if (key.starts_with(store::run_key))
        return R"({"build": "golden", "cells": 1, "done": 1, "started": "2001-01-01T00:00:00Z",
            "ended": "2001-01-01T00:01:00Z"})";
    return key.starts_with(store::took_key) ? "1" : value;
}

/// Value of the figure "PROBE.NAME"; 0 if it has none.
double value_of(const store::StoredCell& cell, const char* probe, const char* name) {
    return cell.figure(probe, name).value.value_or(0);
}

/// Made-up time of a query of this cell.
double ns_per_query(const store::StoredCell& cell) {
    return 8 * value_of(cell, "error", "mean_steps") + 3 * value_of(cell, "lines", "lines_per_query");
}

/// Two thirds of the queries are separated; those in contact take half as long.
measure::Timing timing(const store::StoredCell& cell, double factor) {
    const auto queries = static_cast<std::uint64_t>(cell.queries);
    const double ns = ns_per_query(cell) * factor;
    measure::Timing result;
    result.overlapping_queries = queries / 3;
    result.separated_queries = queries - queries / 3;
    result.separated_ns = ns * static_cast<double>(result.separated_queries);
    result.overlapping_ns = ns / 2 * static_cast<double>(result.overlapping_queries);
    return result;
}

/// Some rounds a few per cent apart.
std::vector<measure::Round> rounds(const store::StoredCell& cell, const store::StoredCell& baseline) {
    std::vector<measure::Round> result;
    for (int number = 0; number < 9; ++number) {
        result.push_back({number, timing(cell, 1 + 0.01 * (number * 7 % 9)),
                          timing(baseline, 1 + 0.01 * (number * 5 % 9))});
    }
    return result;
}

bool is_of_sweep(const store::StoredCell& cell) { return cell.run == store::sweep_run && cell.verified(); }

std::string question_of(const store::StoredCell& cell) {
    return cell.scene + cell.scene_parameters + cell.shape + cell.axes;
}

/// Replaces times of hard cases, which the clock measured.
void take_out_clock(store::StoredCell& cell) {
    for (store::FigureRow& figure : cell.figures)
        if (figure.name.starts_with("ns_at") && figure.value) figure.value = 100;
}

/// Adds rounds, and the figures of time that a sweep computes from them.
void add_times(store::StoredCell& cell, const store::StoredCell& baseline) {
    cell.rounds = rounds(cell, baseline);
    for (const measure::Figure& figure : probes::time::figures(cell.rounds, cell.scene == "tumble"))
        cell.figures.push_back({figure, "time"});
}

}  // namespace

std::string make_golden_store(const cli_test::Folder& folder) {
    store::StoredBuild build = merged_build(folder);
    std::map<std::string, store::StoredCell> baselines;
    for (const store::StoredCell& cell : build.cells)
        if (cell.table == "aos_f64" && cell.algorithm == "vclip") baselines[question_of(cell)] = cell;
    const std::string path = folder / "golden.db";
    store::Store store(path);
    store.put_build(golden_build());
    for (const auto& [key, value] : build.meta) store.set_meta(key, golden_meta(key, value));
    for (store::StoredCell& cell : build.cells) {
        take_out_clock(cell);
        if (is_of_sweep(cell)) add_times(cell, baselines.at(question_of(cell)));
        store.put_cell(golden_build().id, cell, cell.figures);
        for (const measure::Round& round : cell.rounds) {
            const std::pair<std::string, measure::Round> one(cell.hash, round);
            store.put_round(golden_build().id, {&one, 1});
        }
    }
    return path;
}

}  // namespace edgewise::golden
