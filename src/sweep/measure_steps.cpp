// SPDX-License-Identifier: MIT
#include "edgewise/sweep/measure_steps.hpp"

#include <optional>

#include "edgewise/measure/statistics.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/scene/scene_setup.hpp"

namespace edgewise {

namespace {

constexpr int passes = 5;  ///< an odd number, for a median that was measured

/// Which parts of a step a pass takes.
struct Parts {
    bool boxes, broad_phase, queries;
};

class StepWatch {
  public:
    StepWatch(const Runner& runner, const Workload& workload)
        : workload_(workload), narrow_phase_(runner.prepared_range(workload)) {}

    /// One pass over all steps, with these parts of each; ns of those that count.
    double pass(Parts parts) {
        double ns = 0;
        for (std::size_t i = 0; i < workload_.frames.size(); ++i) {
            const Stopwatch watch;
            take(i, parts);
            if (counts(i)) ns += watch.elapsed_ns();
        }
        return ns;
    }

    /// What a step comes to, over those that count.
    [[nodiscard]] StepCosts count() {
        StepCosts costs;
        std::size_t tests = 0, moves = 0, pairs = 0, bodies = 0;
        for (std::size_t i = 0; i < workload_.frames.size(); ++i) {
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
    void take(std::size_t i, Parts parts) {
        const Frame& frame = workload_.frames[i];
        if (frame.starts_anew) broad_phase_.emplace(frame.poses.size());
        if (parts.boxes) update_boxes(frame);
        const std::vector<Aabb>& boxes = parts.boxes ? boxes_ : frame.boxes;
        if (parts.broad_phase) found_ += broad_phase_->update(boxes).size();
        if (parts.queries) sum_ += narrow_phase_(frame.first_query, end_of(i));
    }

    void update_boxes(const Frame& frame) {
        boxes_.resize(frame.poses.size());
        for (std::size_t body = 0; body < boxes_.size(); ++body) {
            const Polyhedron& shape = workload_.bodies[workload_.instances[body]];
            boxes_[body] = world_box(shape, frame.poses[body]).enlarged(frame.margin);
        }
    }

    /// The last step may have been cut short, and the first of a population knows no other.
    [[nodiscard]] bool counts(std::size_t i) const {
        return !workload_.frames[i].starts_anew && i + 1 < workload_.frames.size();
    }

    [[nodiscard]] std::size_t end_of(std::size_t i) const {
        return i + 1 < workload_.frames.size() ? workload_.frames[i + 1].first_query
                                               : workload_.queries.size();
    }

    const Workload& workload_;
    Runner::RangePass narrow_phase_;
    std::optional<SweepAndPrune> broad_phase_;
    std::vector<Aabb> boxes_;
    volatile std::size_t found_ = 0;  ///< what nobody reads might not be worked out
    volatile double sum_ = 0;
};

double median_of(StepWatch& watch, Parts parts) {
    std::vector<double> times;
    for (int i = 0; i < passes; ++i) times.push_back(watch.pass(parts));
    return *median(times);
}

bool has_steps(const Workload& workload) {
    return !workload.frames.empty() && !workload.frames.front().poses.empty();
}

}  // namespace

StepCosts step_costs(const Runner& runner, const Workload& workload) {
    StepCosts costs;
    costs.reason = "the scene has no steps with a broad phase";
    costs.remedy = "tumble with in_time_order=1";
    if (!has_steps(workload)) return costs;
    StepWatch watch(runner, workload);
    const StepCosts counted = watch.count();
    costs.reason = "no step follows another";
    costs.remedy = "ask for more queries";
    if (counted.steps == 0) return costs;
    costs = counted;
    const auto steps = static_cast<double>(costs.steps);
    costs.step_ns = median_of(watch, {true, true, true}) / steps;
    costs.update_ns = median_of(watch, {true, false, false}) / steps / costs.bodies;
    if (costs.box_tests > 0)
        costs.box_test_ns = median_of(watch, {false, true, false}) / steps / costs.box_tests;
    if (costs.pairs > 0) costs.pair_ns = median_of(watch, {false, false, true}) / steps / costs.pairs;
    return costs;
}

}  // namespace edgewise
