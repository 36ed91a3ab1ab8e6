// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/bench/cell.hpp"
#include "edgewise/bench/drawings.hpp"
#include "edgewise/bench/parallel.hpp"
#include "edgewise/measure/counters/calibration.hpp"
#include "edgewise/measure/machine/quietness.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/store/schema.hpp"
#include "edgewise/sweep/expected_work.hpp"
#include "edgewise/sweep/prepared_cell.hpp"
#include "edgewise/sweep/stored_cells.hpp"
#include "edgewise/sweep/work.hpp"

namespace edgewise::sweep {

namespace {

/// The shape of the drawings: small enough to read, with every kind of feature.
constexpr const char* drawn_shape = "cube8";

/// The baseline need not be among the chosen cells; a program without its layout compares with the first it
/// has.
const bench::TableType& baseline_type() {
    const bench::TableType* found = bench::find_table_type(baseline_table);
    return found ? *found : bench::table_types().front();
}

std::string baseline_algorithm_on(const bench::TableType& type) {
    return type.serves(baseline_algorithm) ? baseline_algorithm : type.algorithms.front();
}

/// Its line and one picture per layout, of its first precision.
void store_layouts(const SweepWork& work, store::Store& store) {
    const Polyhedron body = scene::make_shape(drawn_shape).or_throw();
    std::string last;
    for (const bench::TableType* type : work.types) {
        if (type->layout == last) continue;
        last = type->layout;
        store.set_meta(store::layout_key + type->layout, type->stores + "; " + type->derives);
        store.set_meta(store::drawing_key + type->name, bench::draw_layout(*type, drawn_shape, body));
    }
}

/// Measures what a load costs that each level of this machine answers, if a scene's caches are modelled on
/// it; once for a build on a machine.
void store_latencies(const SweepWork& work, const store::BuildRow& build, store::Store& store) {
    const std::string key = store::latencies_key + build.id;
    if (std::ranges::all_of(work.scenes, [](const SceneWork& scene) { return scene.choice.caches.empty(); }))
        return;
    for (const measure::MachineChoice& choice : work.machines)
        if (choice.name == "host" && choice.machine.value && !store.meta(key))
            store.set_meta(key,
                           nlohmann::json(measure::latencies_beyond_first(*choice.machine.value)).dump());
}

/// What is the same of all cells.
void store_sweep(const SweepWork& work, const store::BuildRow& build, store::Store& store) {
    const bench::TableType& baseline = baseline_type();
    store.put_build(build);
    store.set_meta("build", build.id);
    store.set_meta("plan", work.plan.name);
    store.set_meta("seed", std::to_string(work.plan.seed));
    store.set_meta("baseline", fmt::format("{} x {}", baseline_algorithm_on(baseline), baseline.name));
    store.set_meta("tables",
                   "in an arena from a multiple of 2 MiB on, the first at its start, one after "
                   "the other; large pages declined; else as the axis allocator says");
    for (const SceneWork& scene : work.scenes) {
        if (scene.json.empty()) continue;
        store.set_meta(store::scene_file_key + scene.choice.name, scene.json);
        store.set_meta(store::scene_path_key + scene.choice.name, scene.path);
    }
    for (const bench::TableType* peer : work.peers)
        store.set_meta(store::peer_key + peer->name, peer->stores + "; " + peer->derives);
    store_layouts(work, store);
    store_latencies(work, build, store);
}

using StoredRound = std::vector<std::pair<std::string, measure::Round>>;

StoredRound time_round(const Plan& plan, int number, const std::vector<const CellRun*>& cells,
                       const CellRun& baseline, double clock_cost_ns) {
    StoredRound rounds;
    measure::Timing baseline_timing;
    take_turns(cells.size() + 1, plan.seed + static_cast<std::uint64_t>(number), [&](std::size_t i) {
        if (i == cells.size()) {
            baseline_timing = baseline.time(clock_cost_ns);
        } else {
            rounds.emplace_back(cells[i]->row().hash,
                                measure::Round{number, cells[i]->time(clock_cost_ns), {}});
        }
    });
    for (auto& [hash, round] : rounds) round.baseline = baseline_timing;
    return rounds;
}

/// Every round that a cell to be timed is missing: each such cell once, in an order of its own each round,
/// the baseline somewhere among them. A round is stored when it is done, and `stop` looked at before the
/// next. Returns what others took of the processor meanwhile.
double time_rounds(const Plan& plan, std::span<const CellRun> cells, const CellRun& baseline,
                   StoredCells& stored, const std::atomic<bool>& stop,
                   const std::function<void()>& on_round) {
    measure::ShareOfOthers others;
    const double clock_cost_ns = measure::calibrate();
    std::vector<std::set<int>> missing;
    for (const CellRun& cell : cells) missing.push_back(stored.rounds_missing(cell));
    for (int round = 0; round < plan.rounds && !stop; ++round) {
        std::vector<const CellRun*> lacking;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (cells[i].is_timed() && missing[i].contains(round)) lacking.push_back(&cells[i]);
        }
        if (!lacking.empty()) {
            others.begin();
            const StoredRound timed = time_round(plan, round, lacking, baseline, clock_cost_ns);
            others.end();
            stored.put(timed);
        }
        on_round();
    }
    return others.share();
}

void count(store::CellStatus status, SweepSummary& summary) {
    std::size_t* const counts[] = {&summary.unavailable, &summary.verified, &summary.failed, &summary.judged};
    ++summary.cells;
    ++*counts[static_cast<int>(status)];
}

class Sweep {
  public:
    Sweep(const SweepWork& work, store::Store& store, const std::string& build, TimeLeft& left,
          const SweepListener& listener, const std::atomic<bool>& stop)
        : work_(work), stored_(store, build, work.plan), left_(left), listener_(listener), stop_(stop) {}

    SweepSummary run() {
        const std::vector<GroupWork> expected =
            expected_work(work_, [&](const std::string& group) { return stored_.took(group); });
        for (const GroupWork& group : expected)
            for (const Step step : steps) left_.expect(group.kind(step), group.of(step));
        auto group = expected.begin();
        for (const SceneWork& scene : work_.scenes) {
            for (const scene::NamedShape* shape : scene.shapes) {
                if (!stop_) run_group(scene, *shape, *group++);
            }
        }
        summary_.stopped = stop_;
        return summary_;
    }

  private:
    void run_group(const SceneWork& scene, const scene::NamedShape& shape, const GroupWork& expected) {
        std::vector<CellRun> cells = cells_of(scene, shape);
        if (all_stored(cells)) {
            for (const Step step : steps) left_.skip(expected.kind(step), expected.of(step));
            listener_.on_done(cells.size(), {});
            return;
        }
        const measure::Stopwatch watch;
        lap_.restart();
        run_cells(scene, shape, cells, expected);
        if (stop_) return;
        left_.end_group();
        const double took = watch.elapsed_ns() * 1e-9;
        stored_.put_seconds(group_key(work_.plan, scene, shape, cells.size()), took);
        stored_.put_seconds(comparison_name(scene, shape), took);  // for shards to be weighed by
        listener_.on_done(cells.size(), scene.choice.name + " " + shape.name);
    }

    /// Notes that one part of the step is done; the step has `parts` equal parts.
    void advance(const GroupWork& expected, Step step, std::size_t parts, const std::string& what) {
        left_.done(expected.kind(step), expected.of(step) / static_cast<double>(parts),
                   lap_.elapsed_ns() * 1e-9);
        lap_.restart();
        listener_.on_done(0, what);
    }

    [[nodiscard]] std::vector<CellRun> cells_of(const SceneWork& scene,
                                                const scene::NamedShape& shape) const {
        std::vector<CellRun> cells;
        work_.each_cell(
            scene, [&](const bench::TableType& type, const std::string& algorithm, const Axes& axes) {
                cells.emplace_back(type, algorithm, axes, row_of(work_.plan, scene, shape), shape.body);
                if (scene.models_caches(shape))
                    cells.back().model_caches({work_.machines, work_.plan.traced, work_.plan.traced_steps});
                cells.back().measure_only(work_.plan.probes);
                if (!shape.error.empty()) cells.back().make_unavailable(shape.error);
            });
        return cells;
    }

    /// Returns true if the store has every result of all cells, and then counts the cells.
    [[nodiscard]] bool all_stored(const std::vector<CellRun>& cells) {
        std::vector<store::CellStatus> states;
        for (const CellRun& cell : cells) {
            const auto status = stored_.status_of(cell);
            if (!status) return false;
            states.push_back(*status);
        }
        for (const store::CellStatus status : states) count(status, summary_);
        return true;
    }

    /// Checks the answers of every cell, then runs the probes that may measure several cells at a time.
    void verify_and_trace(std::vector<CellRun>& cells, SharedQueries& shared, const GroupWork& expected,
                          const std::string& what) {
        for (CellRun& cell : cells) {
            if (stop_) return;
            cell.verify(shared);
            advance(expected, Step::verify, cells.size(), what);
        }
        // On all processors: nothing is timed here, and a trace does not depend on what else is running.
        std::mutex telling;
        bench::for_each_index(cells.size(), [&](std::size_t i) {
            if (stop_) return;
            cells[i].measure(CellRun::Stage::beside_others, {});
            const std::scoped_lock lock(telling);
            advance(expected, Step::trace, cells.size(), what);
        });
    }

    void run_cells(const SceneWork& scene, const scene::NamedShape& shape, std::vector<CellRun>& cells,
                   const GroupWork& expected) {
        if (!shape.error.empty()) {  // nothing to measure
            for (const CellRun& cell : cells) keep(cell);
            return;
        }
        const std::string what = scene.choice.name + " " + shape.name;
        SharedQueries shared = queries_of(work_.plan, scene, shape);
        if (!shared.note().empty()) listener_.on_warning(shared.note());
        verify_and_trace(cells, shared, expected, what);
        const bench::TableType& type = baseline_type();
        CellRun baseline(type, baseline_algorithm_on(type), {}, row_of(work_.plan, scene, shape), shape.body);
        baseline.verify(shared);
        if (!baseline.verified())
            listener_.on_warning(fmt::format(
                "the baseline {} on {} {} is {}: {}; nothing to compare times with", baseline.row().table,
                scene.choice.name, shape.name, to_string(baseline.row().status), baseline.row().reason));
        const double others = time_rounds(work_.plan, cells, baseline, stored_, stop_, [&] {
            advance(expected, Step::rounds, static_cast<std::size_t>(work_.plan.rounds), what);
        });
        stored_.put_others(baseline.row(), others);
        if (stop_) return;
        for (CellRun& cell : cells) {
            cell.measure(CellRun::Stage::alone, stored_.rounds_of(cell));
            stored_.put_heat(cell, shape.body);
            keep(cell);
            advance(expected, Step::alone, cells.size(), what);
        }
    }

    void keep(const CellRun& cell) {
        stored_.put(cell);
        count(cell.row().status, summary_);
        if (cell.row().failed()) {
            listener_.on_warning(fmt::format("failed: {} {} {} {}: {}", cell.row().scene, cell.row().shape,
                                             cell.row().algorithm, cell.row().table, cell.row().reason));
        }
    }

    const SweepWork& work_;
    StoredCells stored_;
    TimeLeft& left_;
    const SweepListener& listener_;
    const std::atomic<bool>& stop_;
    SweepSummary summary_;
    measure::Stopwatch lap_;  ///< since the last part of a step was done
};

}  // namespace

store::CellRow row_of(const Plan& plan, const SceneWork& scene, const scene::NamedShape& shape) {
    store::CellRow row;
    row.scene = scene.choice.name;
    row.scene_kind = scene.kind;
    row.scene_parameters = bench::parameters_json(scene.choice.parameters);
    row.shape = shape.name;
    row.shape_source = shape.source;
    row.vertices = shape.body.vertex_count();
    row.edges = shape.body.edge_count();
    row.faces = shape.body.face_count();
    row.seed = plan.seed;
    row.queries = scene.queries;
    row.run = run_of(plan);
    return row;
}

SharedQueries queries_of(Plan plan, const SceneWork& scene, const scene::NamedShape& shape) {
    plan.queries = scene.queries;
    SceneChoice made = scene.choice;
    if (!scene.kind.empty()) made.name = scene.kind;
    return {plan, made, shape};
}

SweepSummary run_sweep(const SweepWork& work, store::Store& store, TimeLeft& left,
                       const SweepListener& listener, const std::atomic<bool>& stop) {
    const store::BuildRow build = bench::this_build();
    check_scene_files(work, store);
    store_sweep(work, build, store);
    return Sweep(work, store, build.id, left, listener, stop).run();
}

}  // namespace edgewise::sweep
