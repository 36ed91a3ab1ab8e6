// SPDX-License-Identifier: MIT
#include "edgewise/probes/cost.hpp"

#include <array>
#include <optional>

#include "edgewise/measure/statistics.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/scene/kinds/scene_setup.hpp"

namespace edgewise::probes {

namespace {

constexpr int passes = 3;  ///< an odd number, for a median that was measured
constexpr std::size_t enough_queries = 10000, fewest_steps = 4;  ///< of a pass

/// Which parts of a step a pass takes.
struct StepParts {
    bool boxes, broad_phase, queries;
};

class StepWatch {
  public:
    StepWatch(const bench::Runner& runner, const scene::Workload& workload)
        : workload_(workload), narrow_phase_(runner.prepared_range()) {
        // The last step may have been cut short.
        const std::size_t whole = workload.frames.size() - 1;
        while (steps_ < whole && (steps_ < fewest_steps || end_of(steps_ - 1) < enough_queries)) ++steps_;
    }

    /// Runs one pass over all steps with the given parts of each; returns the ns of the steps that count.
    double pass(StepParts parts) {
        double ns = 0;
        for (std::size_t i = 0; i < steps_; ++i) {
            const measure::Stopwatch watch;
            take(i, parts);
            if (counts(i)) ns += watch.elapsed_ns();
        }
        return ns;
    }

    /// What a step comes to, over those that count.
    [[nodiscard]] StepCosts count() {
        StepCosts costs;
        std::size_t tests = 0, moves = 0, pairs = 0, bodies = 0;
        for (std::size_t i = 0; i < steps_; ++i) {
            take(i, {true, true, false});
            if (!counts(i)) continue;
            ++costs.steps;
            tests += broad_phase_->tests();
            moves += broad_phase_->moves();
            pairs += end_of(i) - workload_.frames[i].first_query;
            bodies += workload_.frames[i].poses.size();
        }
        const auto a_step = [&](std::size_t sum) {
            return static_cast<double>(sum) / static_cast<double>(costs.steps);
        };
        if (costs.steps == 0) return costs;
        costs.box_tests = a_step(tests);
        costs.moves = a_step(moves);
        costs.pairs = a_step(pairs);
        costs.bodies = a_step(bodies);
        return costs;
    }

  private:
    void take(std::size_t i, StepParts parts) {
        const scene::Frame& frame = workload_.frames[i];
        if (frame.starts_anew) broad_phase_.emplace(frame.poses.size());
        if (parts.boxes) update_boxes(frame);
        const std::vector<Aabb>& boxes = parts.boxes ? boxes_ : frame.boxes;
        if (parts.broad_phase) found_ = found_ + broad_phase_->update(boxes).size();
        if (parts.queries) sum_ = sum_ + narrow_phase_(frame.first_query, end_of(i), nullptr);
    }

    void update_boxes(const scene::Frame& frame) {
        boxes_.resize(frame.poses.size());
        for (std::size_t body = 0; body < boxes_.size(); ++body) {
            const Polyhedron& shape = workload_.bodies[workload_.instances[body]];
            boxes_[body] = scene::world_box(shape, frame.poses[body]).enlarged(frame.margin);
        }
    }

    /// The first step of a population has no step before it and does not count.
    [[nodiscard]] bool counts(std::size_t i) const { return !workload_.frames[i].starts_anew; }

    [[nodiscard]] std::size_t end_of(std::size_t i) const {
        return i + 1 < workload_.frames.size() ? workload_.frames[i + 1].first_query
                                               : workload_.queries.size();
    }

    const scene::Workload& workload_;
    bench::Runner::RangePass narrow_phase_;
    std::optional<SweepAndPrune> broad_phase_;
    std::vector<Aabb> boxes_;
    std::size_t steps_ = 0;           ///< of a pass
    volatile std::size_t found_ = 0;  ///< results must be stored somewhere, or they might not be computed
    volatile double sum_ = 0;
};

/// ns of the whole, then of boxes, broad phase and queries alone: medians of alternating passes, so that
/// what slows the machine for a while slows all of them.
std::array<double, 4> times_of(StepWatch& watch) {
    constexpr std::array<StepParts, 4> what = {
        {{true, true, true}, {true, false, false}, {false, true, false}, {false, false, true}}};
    std::array<std::vector<double>, 4> times;
    for (int i = 0; i < passes; ++i) {
        for (std::size_t k = 0; k < what.size(); ++k) times[k].push_back(watch.pass(what[k]));
    }
    return {*measure::median(times[0]), *measure::median(times[1]), *measure::median(times[2]),
            *measure::median(times[3])};
}

}  // namespace

StepCosts step_costs(const bench::Runner& runner, const scene::Workload& workload) {
    if (workload.frames.empty() || workload.frames.front().poses.empty())
        return {.reason = "the scene has no steps with a broad phase",
                .remedy = "tumble with in_time_order=1"};
    StepWatch watch(runner, workload);
    StepCosts costs = watch.count();
    if (costs.steps == 0) return {.reason = "no step follows another", .remedy = "ask for more queries"};
    const auto steps = static_cast<double>(costs.steps);
    const auto [whole, boxes, broad_phase, queries] = times_of(watch);
    costs.step_ns = whole / steps;
    costs.update_ns = boxes / steps / costs.bodies;
    if (costs.box_tests > 0) costs.box_test_ns = broad_phase / steps / costs.box_tests;
    if (costs.pairs > 0) costs.pair_ns = queries / steps / costs.pairs;
    return costs;
}

}  // namespace edgewise::probes
