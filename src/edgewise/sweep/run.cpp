// SPDX-License-Identifier: MIT
#include "edgewise/sweep/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/bench/build_info.hpp"
#include "edgewise/bench/cell.hpp"
#include "edgewise/sweep/cell_run.hpp"
#include "edgewise/bench/draw_layout.hpp"
#include "edgewise/bench/parallel.hpp"
#include "edgewise/store/schema.hpp"
#include "edgewise/sweep/trace_scene.hpp"

namespace edgewise {

namespace {

/// What every ratio is against: the paper's algorithm on the paper's layout.
const std::string baseline_algorithm = "vclip", baseline_table = "aos_f64";

/// Small enough to be read, and every kind of feature is there.
constexpr const char* drawn_shape = "cube8";

class Sweep {
  public:
    Sweep(const SweepWork& work, Store& store, const SweepListener& listener, const std::atomic<bool>& stop)
        : work_(work),
          plan_(work.plan),
          store_(store),
          listener_(listener),
          stop_(stop),
          baseline_(baseline_type()),
          baseline_algorithm_(baseline_.serves(baseline_algorithm) ? baseline_algorithm
                                                                   : baseline_.algorithms.front()) {
        const BuildRow build = this_build();
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
            if (!scene.text.empty()) store_.set_meta(scene_file_key + scene.choice.name, scene.text);
        }
        store_drawings();
    }

    SweepSummary run() {
        listener_.on_start(work_.cells());
        for (const SceneWork& scene : work_.scenes) {
            for (const NamedShape* shape : scene.shapes) {
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
        auto body = make_shape(drawn_shape);
        if (!body) throw std::logic_error(body.error);
        std::string last;
        for (const TableType* type : work_.types) {
            if (type->layout == last) continue;
            last = type->layout;
            store_.set_meta(drawing_key + type->name, draw_layout(*type, drawn_shape, *body));
        }
    }

    [[nodiscard]] CellRow row_for(const SceneWork& scene, const NamedShape& shape) const {
        CellRow row;
        row.scene = scene.choice.name;
        row.scene_kind = scene.kind;
        row.scene_parameters = parameters_json(scene.choice.parameters);
        row.shape = shape.name;
        row.shape_source = shape.source;
        row.vertices = shape.body.vertex_count();
        row.edges = shape.body.edge_count();
        row.faces = shape.body.face_count();
        row.seed = plan_.seed;
        row.queries = scene.queries;
        return row;
    }

    void run_group(const SceneWork& scene, const NamedShape& shape) {
        std::vector<Contender> contenders = contenders_for(scene, shape);
        const std::string what = scene.choice.name + " " + shape.name;
        if (!shape.error.empty()) {
            for (Contender& contender : contenders) give_up(contender, shape.error);
            listener_.on_done(contenders.size(), what);
            return;
        }
        if (all_stored(contenders)) {
            listener_.on_done(contenders.size(), what);
            return;
        }
        Plan plan = plan_;
        plan.queries = scene.queries;
        SceneChoice made = scene.choice;
        if (!scene.kind.empty()) made.name = scene.kind;
        Group group(plan, made, shape);
        for (Contender& contender : contenders) contender.verify(group);
        trace_all(group, contenders);
        Contender baseline(baseline_, baseline_algorithm_, {}, row_for(scene, shape));
        baseline.verify(group);
        time_rounds(group, contenders, baseline);
        if (stop_) return;
        for (Contender& contender : contenders) {
            contender.count(group);
            contender.study(group);
        }
        for (const Contender& contender : contenders) keep(contender, &group);
        listener_.on_done(contenders.size(), what);
    }

    /// On all processors: nothing is timed meanwhile, and traces do not depend on what runs beside them.
    void trace_all(const Group& group, std::vector<Contender>& contenders) const {
        for_each_index(contenders.size(), [&](std::size_t i) {
            if (!stop_) contenders[i].trace(group, plan_.traced);
        });
    }

    [[nodiscard]] std::vector<Contender> contenders_for(const SceneWork& scene,
                                                        const NamedShape& shape) const {
        std::vector<Contender> result;
        work_.each_cell(scene, [&](const TableType& type, const std::string& algorithm, const Axes& axes) {
            result.emplace_back(type, algorithm, axes, row_for(scene, shape));
            result.back().name(shape.body);
            if (scene.models_caches(shape)) result.back().model_caches(work_.machines);
        });
        return result;
    }

    /// The baseline need not be among the chosen cells; a program without its layout compares with the first
    /// it has.
    [[nodiscard]] static const TableType& baseline_type() {
        const auto types = table_types();
        const auto is_baseline = [](const TableType& type) { return type.name == baseline_table; };
        const auto found = std::find_if(types.begin(), types.end(), is_baseline);
        return found != types.end() ? *found : types.front();
    }

    /// Rounds and figures of all of them are there; counts them.
    [[nodiscard]] bool all_stored(const std::vector<Contender>& contenders) {
        std::vector<std::string> states;
        for (const Contender& contender : contenders) {
            const auto row = store_.find_cell(build_, contender.row().hash);
            if (!row) return false;
            if (row->status == "verified" && rounds_missing(contender).size() > 0) return false;
            if (row->status == "verified" && lacks_caches(contender)) return false;
            states.push_back(row->status);
        }
        for (const std::string& status : states) count(status);
        return true;
    }

    /// An earlier run may not have modelled these machines, or fewer queries.
    [[nodiscard]] bool lacks_caches(const Contender& contender) const {
        if (!contender.models_caches()) return false;
        const double wanted = trace_identity(work_.machines, plan_.traced);
        const std::vector<FigureRow> stored = store_.figures(build_, contender.row().hash);
        return std::none_of(stored.begin(), stored.end(), [&](const FigureRow& row) {
            return row.probe == "caches" && row.figure.name == "identity" && row.figure.value == wanted;
        });
    }

    [[nodiscard]] std::vector<int> rounds_missing(const Contender& contender) const {
        const auto done = store_.rounds_done(build_, contender.row().hash);
        std::vector<int> missing;
        for (int round = 0; round < plan_.rounds; ++round) {
            if (!done.contains(round)) missing.push_back(round);
        }
        return missing;
    }

    void time_rounds(const Group& group, const std::vector<Contender>& contenders,
                     const Contender& baseline) {
        if (!baseline.verified()) {
            listener_.on_warning(
                "the baseline failed its check in this group: nothing to compare times with");
        }
        const double clock_cost_ns = calibrate();
        std::vector<std::vector<int>> missing;
        for (const Contender& contender : contenders) missing.push_back(rounds_missing(contender));
        for (int round = 0; round < plan_.rounds && !stop_; ++round) {
            std::vector<const Contender*> turn;
            for (std::size_t i = 0; i < contenders.size(); ++i) {
                const auto& of_this = missing[i];
                const bool lacks = std::find(of_this.begin(), of_this.end(), round) != of_this.end();
                if (contenders[i].verified() && lacks) turn.push_back(&contenders[i]);
            }
            if (!turn.empty())
                store_.put_round(build_, time_round(group, round, turn, baseline, clock_cost_ns));
        }
    }

    /// Every cell once, in an order of its own each round, the baseline somewhere among them.
    [[nodiscard]] std::vector<std::pair<std::string, Round>> time_round(const Group& group, int number,
                                                                        std::vector<const Contender*> turn,
                                                                        const Contender& baseline,
                                                                        double clock_cost_ns) const {
        turn.push_back(&baseline);
        Rng rng(plan_.seed + static_cast<std::uint64_t>(number));
        rng.shuffle(turn);
        std::vector<std::pair<std::string, Round>> rounds;
        Timing baseline_timing;
        for (const Contender* contender : turn) {
            const Timing timing = contender->time(group, clock_cost_ns);
            if (contender == &baseline) {
                baseline_timing = timing;
            } else {
                rounds.emplace_back(contender->row().hash, Round{number, timing, {}});
            }
        }
        for (auto& [hash, round] : rounds) round.baseline = baseline_timing;
        return rounds;
    }

    /// Without a group there was nothing to measure.
    void keep(const Contender& contender, const Group* group) {
        std::vector<FigureRow> figures;
        if (group) figures = contender.figures(*group, sizes_, store_.rounds(build_, contender.row().hash));
        store_.put_cell(build_, contender.row(), figures);
        count(contender.row().status);
        if (contender.row().status == "failed") {
            listener_.on_warning(fmt::format("failed: {} {} {} {}: {}", contender.row().scene,
                                             contender.row().shape, contender.row().algorithm,
                                             contender.row().table, contender.row().reason));
        }
    }

    void give_up(Contender& contender, const std::string& reason) {
        contender.make_unavailable(reason);
        keep(contender, nullptr);
    }

    void count(const std::string& status) {
        ++summary_.cells;
        ++(status == "verified" ? summary_.verified
           : status == "failed" ? summary_.failed
                                : summary_.unavailable);
    }

    const SweepWork& work_;
    const Plan& plan_;
    Store& store_;
    const SweepListener& listener_;
    const std::atomic<bool>& stop_;
    const TableType& baseline_;
    std::string baseline_algorithm_;
    std::string build_;
    SizeFamily sizes_;
    SweepSummary summary_;
};

}  // namespace

SweepSummary run_sweep(const SweepWork& work, Store& store, const SweepListener& listener,
                       const std::atomic<bool>& stop) {
    return Sweep(work, store, listener, stop).run();
}

}  // namespace edgewise
