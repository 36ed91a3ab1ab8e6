// SPDX-License-Identifier: MIT
#include "edgewise/studies/thrash/factorial.hpp"

#include <algorithm>
#include <functional>
#include <mutex>
#include <numeric>
#include <stdexcept>

#include "edgewise/bench/parallel.hpp"
#include "edgewise/measure/statistics.hpp"
#include "edgewise/measure/stopwatch.hpp"

namespace edgewise::studies::thrash {

namespace {

double longest(const SpeedCurve& curve) { return *std::max_element(curve.begin(), curve.end()); }

}  // namespace

double largest_fall(const SpeedCurve& curve) {
    double fall = 0;
    for (std::size_t slow = 0; slow < curve.size(); ++slow)
        for (std::size_t fast = slow + 1; fast < curve.size(); ++fast)
            fall = std::max(fall, curve[slow] / curve[fast]);
    return fall;
}

FactScore score(const Figure8& figure) {
    FactScore found;
    found.rise = longest(figure.vclip_386) / longest(figure.vclip_38);
    found.top_ns = longest(figure.vclip_386);
    found.gjk_rise = longest(figure.gjk_386) / longest(figure.gjk_38);
    found.gjk_rise_from_8 = longest(figure.gjk_386) / longest(figure.gjk_8);
    found.fall = largest_fall(figure.vclip_386);
    found.gjk_fall = largest_fall(figure.gjk_386);
    found.holds = {found.rise >= least_rise && found.rise <= most_rise,
                   found.top_ns >= least_top_ns && found.top_ns <= most_top_ns,
                   found.gjk_rise <= most_gjk_rise && found.gjk_rise >= 1 / most_gjk_rise,
                   found.fall >= least_fall && found.gjk_fall < least_fall};
    return found;
}

namespace {

constexpr std::array<const char*, 3> shapes = {"cube8", "sphere38", "sphere386"};
constexpr std::array<const char*, 2> algorithms = {"vclip", "gjk"};

/// The paper's axes where they end: figure 4 at 1.5 m/s, in bodies of 1 m; 6 at 12.57 rad/s; 7 at 7 rad/s.
struct CalibratedFigure {
    int figure;
    const char* shape;
    double top_ns, rad_per_s, m_per_s;
};
constexpr CalibratedFigure calibrated[] = {
    {4, "cube8", 3e4, 0, 1.5}, {6, "cube8", 7e4, 12.57, 0}, {7, "sphere38", 1e5, 7, 0}};
/// Bodies of the scenes that calibrate: those of figures 4, 6 and 7 here.
constexpr std::size_t calibrating_bodies = 200;
/// No body moves farther in a step in the paper's scenes.
constexpr double most_way_in_dimensions = 0.5;

/// The scenes of all settings, in one order: that of the loops here.
class TracedScenes {
  public:
    struct Key {
        std::size_t table, algorithm, shape, shared, time_step, bodies, speed;
    };

    explicit TracedScenes(const Levels& levels)
        : sizes_{levels.tables.size(),     algorithms.size(),    shapes.size(), levels.shared.size(),
                 levels.time_steps.size(), levels.bodies.size(), speeds.size()} {
        demands_.resize(std::accumulate(sizes_.begin(), sizes_.end(), std::size_t{1}, std::multiplies()));
    }

    [[nodiscard]] std::size_t count() const { return demands_.size(); }
    [[nodiscard]] Key key(std::size_t at) const {
        Key key{};
        for (std::size_t i = sizes_.size(); i-- > 0; at /= sizes_[i]) key.*parts[i] = at % sizes_[i];
        return key;
    }
    [[nodiscard]] MemoryDemand& at(const Key& key) {
        std::size_t place = 0;
        for (std::size_t i = 0; i < sizes_.size(); ++i) place = place * sizes_[i] + key.*parts[i];
        return demands_[place];
    }
    [[nodiscard]] const std::vector<MemoryDemand>& all() const { return demands_; }

  private:
    static constexpr std::array<std::size_t Key::*, 7> parts = {
        &Key::table, &Key::algorithm, &Key::shape, &Key::shared, &Key::time_step, &Key::bodies, &Key::speed};

    std::array<std::size_t, 7> sizes_;  ///< numbers of levels of each part
    std::vector<MemoryDemand> demands_;
};

MemoryDemand checked(MemoryDemand demand) {
    if (!demand.reason.empty()) throw std::runtime_error(demand.reason);
    return demand;
}

void trace_all(const Levels& levels, const MemorySizes& sizes, TracedScenes& scenes,
               const std::function<void()>& on_trace, const std::atomic<bool>& stop) {
    std::mutex notified;
    bench::for_each_index(scenes.count(), [&](std::size_t i) {
        if (stop) return;
        const TracedScenes::Key key = scenes.key(i);
        const double angle = speeds[key.speed] * levels.time_steps[key.time_step];
        const scene::Workload workload = workload_of({shapes[key.shape], levels.bodies[key.bodies], angle,
                                                      0.02, levels.steps, levels.seed_of(key.speed)});
        scenes.at(key) = checked(trace_demand(
            bench::table_type_called(levels.tables[key.table]), algorithms[key.algorithm], workload,
            levels.shared[key.shared] ? bench::Sharing::shared : bench::Sharing::per_instance, sizes,
            levels.filling));
        const std::lock_guard lock(notified);
        on_trace();
    });
}

/// The demand of GJK, which a figure draws above V-Clip's throughout: its top is GJK's.
MemoryDemand demand_of(const CalibratedFigure& figure, double time_step, const Levels& levels,
                       const MemorySizes& sizes) {
    const double way = std::min(most_way_in_dimensions, figure.m_per_s * time_step);
    const scene::Workload workload = workload_of(
        {figure.shape, calibrating_bodies, figure.rad_per_s * time_step, way, levels.steps, levels.seed});
    return checked(trace_demand(bench::table_type_called(levels.tables.front()), "gjk", workload,
                                bench::Sharing::per_instance, sizes, levels.filling));
}

void calibrate(const Levels& levels, const MemorySizes& sizes, Factorial& result) {
    for (const double time_step : levels.time_steps) {
        std::vector<MemoryDemand> demands;
        for (const CalibratedFigure& figure : calibrated)
            demands.push_back(demand_of(figure, time_step, levels, sizes));
        for (std::size_t machine = 0; machine < result.machines.size(); ++machine) {
            Calibration found{machine, time_step, 0, {}};
            for (std::size_t i = 0; i < demands.size(); ++i)
                found.points.push_back({calibrated[i].figure, calibrated[i].top_ns, demands[i].reads,
                                        cache_ns(result.machines[machine], sizes, demands[i])});
            found.ns_per_read = ns_per_read(found.points);
            result.calibrations.push_back(std::move(found));
        }
    }
}

/// Measures builds of a table of the first layout: median time over that of a standing pair's read.
void measure_builds(const Levels& levels, Factorial& result) {
    constexpr int repetitions = 21;
    constexpr double angle = 1.0 / 60;
    const bench::TableType& type = bench::table_type_called(levels.tables.front());
    for (const char* shape : shapes) {
        const scene::Workload workload = workload_of({shape, 100, angle, 0.02, levels.steps, levels.seed});
        for (const char* algorithm : algorithms) {
            const auto runner = type.make_runner(algorithm);
            if (const std::string error = runner->load(workload); !error.empty())
                throw std::runtime_error(error);
            const auto pass = runner->prepared_pass();
            std::vector<double> times;
            for (int i = 0; i < repetitions; ++i) {
                const measure::Stopwatch watch;
                pass();
                times.push_back(watch.elapsed_ns() / static_cast<double>(workload.queries.size()));
            }
            const double reads =
                trace_demand(type, algorithm, workload, bench::Sharing::shared, {{1}, {1}}, 0).reads;
            const double build = measure::median(runner->build_times(repetitions).build_ns).value_or(0);
            result.builds.push_back({algorithm, shape, build / (measure::median(times).value_or(1) / reads)});
        }
    }
}

double build_reads(const Factorial& result, std::size_t algorithm, std::size_t shape) {
    for (const BuildCost& build : result.builds)
        if (build.algorithm == algorithms[algorithm] && build.shape == shapes[shape]) return build.reads;
    return 0;
}

const Calibration& calibration_of(const Factorial& result, std::size_t machine, double time_step) {
    return *std::find_if(result.calibrations.begin(), result.calibrations.end(), [&](const Calibration& one) {
        return one.machine == machine && one.time_step == time_step;
    });
}

/// Scores settings; keeps the position of each in the levels.
class Scorer {
  public:
    Scorer(const Levels& levels, const MemorySizes& sizes, TracedScenes& scenes, Factorial& result)
        : levels_(levels), sizes_(sizes), scenes_(scenes), result_(result) {}

    void score_all() {
        TracedScenes::Key key{};
        for (key.table = 0; key.table < levels_.tables.size(); ++key.table)
            for (key.shared = 0; key.shared < levels_.shared.size(); ++key.shared)
                for (key.time_step = 0; key.time_step < levels_.time_steps.size(); ++key.time_step)
                    for (key.bodies = 0; key.bodies < levels_.bodies.size(); ++key.bodies)
                        for (const auto& mechanism : levels_.mechanisms) score_memories(key, mechanism);
    }

  private:
    void score_memories(const TracedScenes::Key& key, const std::pair<Mechanism, double>& mechanism) {
        // A shared table cannot be in world space for each body.
        if (mechanism.first == Mechanism::whole_table_transform && levels_.shared[key.shared]) return;
        for (std::size_t machine = 0; machine < result_.machines.size(); ++machine)
            for (const std::uint64_t memory : levels_.memories_mib)
                for (const double cost : levels_.fault_costs_ns)
                    score_one(key, {mechanism.first, mechanism.second, levels_.tables[key.table],
                                    levels_.shared[key.shared], levels_.time_steps[key.time_step],
                                    levels_.bodies[key.bodies], memory << 20, cost, machine});
    }

    void score_one(const TracedScenes::Key& key, const Setting& setting) {
        Figure8 figure{};
        SpeedCurve* const curves[2][3] = {{&figure.vclip_8, &figure.vclip_38, &figure.vclip_386},
                                          {&figure.gjk_8, &figure.gjk_38, &figure.gjk_386}};
        for (std::size_t algorithm = 0; algorithm < algorithms.size(); ++algorithm)
            for (std::size_t shape = 0; shape < shapes.size(); ++shape)
                *curves[algorithm][shape] = curve(key, algorithm, shape, setting);
        result_.outcomes.push_back({setting, figure, score(figure)});
    }

    [[nodiscard]] SpeedCurve curve(TracedScenes::Key key, std::size_t algorithm, std::size_t shape,
                                   const Setting& setting) {
        key.algorithm = algorithm;
        key.shape = shape;
        TimedScene scene;
        scene.machine = &result_.machines[setting.machine];
        scene.sizes = &sizes_;
        scene.ns_per_read = calibration_of(result_, setting.machine, setting.time_step).ns_per_read;
        scene.build_reads = build_reads(result_, algorithm, shape);
        scene.is_vclip = algorithm == 0;
        scene.is_large = shape + 1 == shapes.size();
        SpeedCurve found{};
        for (key.speed = 0; key.speed < speeds.size(); ++key.speed) {
            scene.demand = &scenes_.at(key);
            found[key.speed] = query_ns(scene, setting);
        }
        return found;
    }

    const Levels& levels_;
    const MemorySizes& sizes_;
    TracedScenes& scenes_;
    Factorial& result_;
};

void count_cycles(const TracedScenes& scenes, Factorial& result) {
    for (std::size_t i = 0; i < scenes.count(); ++i) {
        if (scenes.key(i).algorithm != 0) continue;
        const MemoryDemand& demand = scenes.all()[i];
        result.cycles += demand.cycles;
        result.vclip_queries += static_cast<double>(demand.queries);
    }
}

}  // namespace

std::size_t scenes_to_trace(const Levels& levels) { return TracedScenes(levels).count(); }

Factorial run_factorial(const Levels& levels, const std::function<void()>& on_trace,
                        const std::atomic<bool>& stop) {
    Factorial result;
    result.machines = old_machines();
    std::vector<std::uint64_t> memories;
    for (const std::uint64_t mebibytes : levels.memories_mib) memories.push_back(mebibytes << 20);
    const MemorySizes sizes = sizes_for(result.machines, memories);
    TracedScenes scenes(levels);
    trace_all(levels, sizes, scenes, on_trace, stop);
    if (stop) return result;
    count_cycles(scenes, result);
    calibrate(levels, sizes, result);
    measure_builds(levels, result);
    Scorer(levels, sizes, scenes, result).score_all();
    return result;
}

namespace {

/// An LRU memory smaller than what is swept over once a step misses every unit of the sweep, one as large
/// misses none.
double swept_misses(double units, double memory_units) { return units > memory_units ? units : 0; }

/// Returns the misses of a step's queries after a sweep: the memory holds the sweep's last units, so this
/// part of the step's distinct units misses on average.
double misses_after_sweep(double distinct, double units, double memory_units) {
    return distinct * std::max(0.0, 1 - memory_units / units);
}

double page_faults(const TimedScene& scene, std::uint64_t memory_bytes) {
    return misses_at(scene.sizes->pages, scene.demand->page_misses, memory_bytes / page_bytes);
}

/// Every table's plane, vertex and direction turned in every step, then the queries on what that left.
double transform_ns(const TimedScene& scene, const Setting& setting) {
    const MemoryDemand& demand = *scene.demand;
    const OldMachine& machine = *scene.machine;
    const double lines = demand.tables * demand.table_bytes / line_bytes,
                 pages = demand.tables * demand.table_bytes / page_bytes;
    const double steps_per_query = static_cast<double>(demand.steps) / static_cast<double>(demand.queries);
    const auto first = static_cast<double>(machine.lines(0)), second = static_cast<double>(machine.lines(1)),
               tlb = static_cast<double>(machine.tlb_pages()),
               memory = static_cast<double>(setting.memory_bytes / page_bytes);
    const double sweep = lines * machine.ns_of_cycles(cycles_per_turned_line) +
                         machine.memory_time_ns(swept_misses(lines, first), swept_misses(lines, second),
                                                swept_misses(pages, tlb)) +
                         swept_misses(pages, memory) * setting.fault_ns;
    const double second_misses = misses_at(scene.sizes->lines, demand.line_misses, machine.lines(1));
    const double more_lines =
        std::max(0.0, misses_after_sweep(demand.lines_of_a_step, lines, second) - second_misses);
    const double more_faults = std::max(0.0, misses_after_sweep(demand.pages_of_a_step, pages, memory) -
                                                 page_faults(scene, setting.memory_bytes));
    return sweep * steps_per_query + more_lines * (machine.memory_ns() - machine.second_level_ns()) +
           more_faults * setting.fault_ns;
}

double mechanism_ns(const TimedScene& scene, const Setting& setting) {
    const MemoryDemand& demand = *scene.demand;
    switch (setting.mechanism) {
        case Mechanism::queries_alone:
            return 0;
        case Mechanism::whole_table_transform:
            return scene.is_vclip ? transform_ns(scene, setting) : 0;
        case Mechanism::builds:
            return setting.intensity * scene.build_reads * scene.ns_per_read;
        case Mechanism::builds_of_vclip:
            return scene.is_vclip ? setting.intensity * scene.build_reads * scene.ns_per_read : 0;
        case Mechanism::capped_cycles:
            return scene.is_vclip && scene.is_large
                       ? setting.intensity * reads_per_feature_step * scene.ns_per_read
                       : 0;
        case Mechanism::first_touches:
            return demand.pages / papers_iterations * setting.fault_ns;
    }
    return 0;
}

}  // namespace

double query_ns(const TimedScene& scene, const Setting& setting) {
    return scene.demand->reads * scene.ns_per_read + cache_ns(*scene.machine, *scene.sizes, *scene.demand) +
           page_faults(scene, setting.memory_bytes) * setting.fault_ns + mechanism_ns(scene, setting);
}

}  // namespace edgewise::studies::thrash
