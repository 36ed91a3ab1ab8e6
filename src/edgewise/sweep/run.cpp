// SPDX-License-Identifier: MIT
#include "edgewise/sweep/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/bench/cell.hpp"
#include "edgewise/bench/draw_layout.hpp"
#include "edgewise/bench/parallel.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/store/schema.hpp"
#include "edgewise/store/vocabulary.hpp"
#include "edgewise/sweep/cell_run.hpp"
#include "edgewise/sweep/trace_scene.hpp"

namespace edgewise::sweep {

namespace {

/// What every ratio is against: the paper's algorithm on the paper's layout.
const std::string baseline_algorithm = "vclip", baseline_table = "aos_f64";

/// Small enough to be read, and every kind of feature is there.
constexpr const char* drawn_shape = "cube8";

class Sweep {
  public:
    Sweep(const SweepWork& work, store::Store& store, const SweepListener& listener,
          const std::atomic<bool>& stop)
        : work_(work),
          plan_(work.plan),
          store_(store),
          listener_(listener),
          stop_(stop),
          baseline_(baseline_type()),
          baseline_algorithm_(baseline_.serves(baseline_algorithm) ? baseline_algorithm
                                                                   : baseline_.algorithms.front()) {
        const store::BuildRow build = bench::this_build();
        build_ = build.id;
        store_.put_build(build);
        store_.set_meta("build", build_);
        store_.set_meta("plan", plan_.name);
        store_.set_meta("seed", std::to_string(plan_.seed));
        store_.set_meta("baseline", fmt::format("{} x {}", baseline_algorithm_, baseline_.name));
        store_.set_meta("tables",
                        "in an arena from a multiple of 2 MiB on, the first at its start, one after "
                        "the other; large pages declined; else as the axis allocator says");
        for (const SceneWork& scene : work_.scenes) {
            if (!scene.text.empty()) store_.set_meta(store::scene_file_key + scene.choice.name, scene.text);
        }
        store_drawings();
    }

    SweepSummary run() {
        listener_.on_start(work_.cells());
        for (const SceneWork& scene : work_.scenes) {
            for (const scene::NamedShape* shape : scene.shapes) {
                if (stop_) break;
                run_group(scene, *shape);
            }
        }
        summary_.stopped = stop_;
        return summary_;
    }

  private:
    /// One picture a layout, of its first precision.
    void store_drawings() {
        auto body = scene::make_shape(drawn_shape);
        if (!body) throw std::logic_error(body.error);
        std::string last;
        for (const bench::TableType* type : work_.types) {
            if (type->layout == last) continue;
            last = type->layout;
            store_.set_meta(store::drawing_key + type->name, bench::draw_layout(*type, drawn_shape, *body));
        }
    }

    [[nodiscard]] store::CellRow row_for(const SceneWork& scene, const scene::NamedShape& shape) const {
        store::CellRow row;
        row.scene = scene.choice.name;
        row.scene_kind = scene.kind;
        row.scene_parameters = bench::parameters_json(scene.choice.parameters);
        row.shape = shape.name;
        row.shape_source = shape.source;
        row.vertices = shape.body.vertex_count();
        row.edges = shape.body.edge_count();
        row.faces = shape.body.face_count();
        row.seed = plan_.seed;
        row.queries = scene.queries;
        return row;
    }

    void run_group(const SceneWork& scene, const scene::NamedShape& shape) {
        std::vector<CellRun> cell_runs = cell_runs_for(scene, shape);
        const std::string what = scene.choice.name + " " + shape.name;
        if (!shape.error.empty()) {
            for (CellRun& cell_run : cell_runs) give_up(cell_run, shape.error);
            listener_.on_done(cell_runs.size(), what);
            return;
        }
        if (all_stored(cell_runs)) {
            listener_.on_done(cell_runs.size(), what);
            return;
        }
        Plan plan = plan_;
        plan.queries = scene.queries;
        SceneChoice made = scene.choice;
        if (!scene.kind.empty()) made.name = scene.kind;
        SharedQueries shared(plan, made, shape);
        for (CellRun& cell_run : cell_runs) cell_run.verify(shared);
        trace_all(shared, cell_runs);
        CellRun baseline(baseline_, baseline_algorithm_, {}, row_for(scene, shape));
        baseline.verify(shared);
        time_rounds(shared, cell_runs, baseline);
        if (stop_) return;
        for (CellRun& cell_run : cell_runs) {
            cell_run.count(shared);
            cell_run.study(shared);
        }
        for (const CellRun& cell_run : cell_runs) keep(cell_run, &shared);
        listener_.on_done(cell_runs.size(), what);
    }

    /// On all processors: nothing is timed meanwhile, and traces do not depend on what runs beside them.
    void trace_all(const SharedQueries& shared, std::vector<CellRun>& cell_runs) const {
        bench::for_each_index(cell_runs.size(), [&](std::size_t i) {
            if (!stop_) cell_runs[i].trace(shared, plan_.traced);
        });
    }

    [[nodiscard]] std::vector<CellRun> cell_runs_for(const SceneWork& scene,
                                                     const scene::NamedShape& shape) const {
        std::vector<CellRun> result;
        work_.each_cell(scene,
                        [&](const bench::TableType& type, const std::string& algorithm, const Axes& axes) {
                            result.emplace_back(type, algorithm, axes, row_for(scene, shape));
                            result.back().name(shape.body);
                            if (scene.models_caches(shape)) result.back().model_caches(work_.machines);
                        });
        return result;
    }

    /// The baseline need not be among the chosen cells; a program without its layout compares with the first
    /// it has.
    [[nodiscard]] static const bench::TableType& baseline_type() {
        const auto types = bench::table_types();
        const auto is_baseline = [](const bench::TableType& type) { return type.name == baseline_table; };
        const auto found = std::find_if(types.begin(), types.end(), is_baseline);
        return found != types.end() ? *found : types.front();
    }

    /// Rounds and figures of all of them are there; counts them.
    [[nodiscard]] bool all_stored(const std::vector<CellRun>& cell_runs) {
        std::vector<std::string> states;
        for (const CellRun& cell_run : cell_runs) {
            const auto row = store_.find_cell(build_, cell_run.row().hash);
            if (!row) return false;
            if (row->status == "verified" && rounds_missing(cell_run).size() > 0) return false;
            if (row->status == "verified" && lacks_caches(cell_run)) return false;
            states.push_back(row->status);
        }
        for (const std::string& status : states) count(status);
        return true;
    }

    /// An earlier run may not have modelled these machines, or fewer queries.
    [[nodiscard]] bool lacks_caches(const CellRun& cell_run) const {
        if (!cell_run.models_caches()) return false;
        constexpr store::FigureName identity("caches.identity");
        const double wanted = trace_identity(work_.machines, plan_.traced);
        const std::vector<store::FigureRow> stored = store_.figures(build_, cell_run.row().hash);
        return std::none_of(stored.begin(), stored.end(), [&](const store::FigureRow& row) {
            return row.probe == identity.probe() && row.name == identity.name() && row.value == wanted;
        });
    }

    [[nodiscard]] std::vector<int> rounds_missing(const CellRun& cell_run) const {
        const auto done = store_.rounds_done(build_, cell_run.row().hash);
        std::vector<int> missing;
        for (int round = 0; round < plan_.rounds; ++round) {
            if (!done.contains(round)) missing.push_back(round);
        }
        return missing;
    }

    void time_rounds(const SharedQueries& shared, const std::vector<CellRun>& cell_runs,
                     const CellRun& baseline) {
        if (!baseline.verified()) {
            listener_.on_warning(
                "the baseline failed its check in this shared: nothing to compare times with");
        }
        const double clock_cost_ns = measure::calibrate();
        std::vector<std::vector<int>> missing;
        for (const CellRun& cell_run : cell_runs) missing.push_back(rounds_missing(cell_run));
        for (int round = 0; round < plan_.rounds && !stop_; ++round) {
            std::vector<const CellRun*> turn;
            for (std::size_t i = 0; i < cell_runs.size(); ++i) {
                const auto& of_this = missing[i];
                const bool lacks = std::find(of_this.begin(), of_this.end(), round) != of_this.end();
                if (cell_runs[i].verified() && lacks) turn.push_back(&cell_runs[i]);
            }
            if (!turn.empty())
                store_.put_round(build_, time_round(shared, round, turn, baseline, clock_cost_ns));
        }
    }

    /// Every cell once, in an order of its own each round, the baseline somewhere among them.
    [[nodiscard]] std::vector<std::pair<std::string, measure::Round>> time_round(
        const SharedQueries& shared, int number, std::vector<const CellRun*> turn, const CellRun& baseline,
        double clock_cost_ns) const {
        turn.push_back(&baseline);
        scene::Rng rng(plan_.seed + static_cast<std::uint64_t>(number));
        rng.shuffle(turn);
        std::vector<std::pair<std::string, measure::Round>> rounds;
        measure::Timing baseline_timing;
        for (const CellRun* cell_run : turn) {
            const measure::Timing timing = cell_run->time(shared, clock_cost_ns);
            if (cell_run == &baseline) {
                baseline_timing = timing;
            } else {
                rounds.emplace_back(cell_run->row().hash, measure::Round{number, timing, {}});
            }
        }
        for (auto& [hash, round] : rounds) round.baseline = baseline_timing;
        return rounds;
    }

    /// Without a shared there was nothing to measure.
    void keep(const CellRun& cell_run, const SharedQueries* shared) {
        std::vector<store::FigureRow> figures;
        if (shared) figures = cell_run.figures(*shared, sizes_, store_.rounds(build_, cell_run.row().hash));
        store_.put_cell(build_, cell_run.row(), figures);
        count(cell_run.row().status);
        if (cell_run.row().status == "failed") {
            listener_.on_warning(fmt::format("failed: {} {} {} {}: {}", cell_run.row().scene,
                                             cell_run.row().shape, cell_run.row().algorithm,
                                             cell_run.row().table, cell_run.row().reason));
        }
    }

    void give_up(CellRun& cell_run, const std::string& reason) {
        cell_run.make_unavailable(reason);
        keep(cell_run, nullptr);
    }

    void count(const std::string& status) {
        ++summary_.cells;
        ++(status == "verified" ? summary_.verified
           : status == "failed" ? summary_.failed
                                : summary_.unavailable);
    }

    const SweepWork& work_;
    const Plan& plan_;
    store::Store& store_;
    const SweepListener& listener_;
    const std::atomic<bool>& stop_;
    const bench::TableType& baseline_;
    std::string baseline_algorithm_;
    std::string build_;
    SizeFamily sizes_;
    SweepSummary summary_;
};

}  // namespace

SweepSummary run_sweep(const SweepWork& work, store::Store& store, const SweepListener& listener,
                       const std::atomic<bool>& stop) {
    return Sweep(work, store, listener, stop).run();
}

}  // namespace edgewise::sweep
