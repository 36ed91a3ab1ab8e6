// SPDX-License-Identifier: MIT
#include "edgewise/studies/thrash/memory_demand.hpp"

#include <algorithm>
#include <memory>

#include "edgewise/measure/cache/trace.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise::studies::thrash {

namespace {

/// Units of one size: their reuse distances, and how many distinct ones each step uses.
class UnitReuse {
  public:
    explicit UnitReuse(std::uint64_t unit_bytes) : unit_bytes_(unit_bytes) {}

    void use(const measure::TracedAccess& access, std::uint32_t step) {
        access.for_each_unit(unit_bytes_, [&](std::uint64_t unit) {
            const std::uint64_t distance = reuse_.use(unit);
            if (distance == measure::ReuseDistance::never)
                curve_.add_first();
            else
                curve_.add(distance);
            if (unit >= last_step_.size()) last_step_.resize(2 * unit + 1, 0);
            if (last_step_[unit] != step + 1) {
                last_step_[unit] = step + 1;
                ++of_steps_;
            }
        });
    }
    void start_counting() {
        curve_ = {};
        of_steps_ = 0;
    }

    [[nodiscard]] std::uint64_t distinct() const { return reuse_.lines(); }
    [[nodiscard]] std::uint64_t of_steps() const { return of_steps_; }
    /// First uses are no misses here: they are of bodies that no step was near until then, and become fewer
    /// the longer a run is.
    [[nodiscard]] std::vector<double> misses(const std::vector<std::uint64_t>& sizes, double queries) const {
        std::vector<double> found;
        for (const std::uint64_t size : sizes)
            found.push_back(static_cast<double>(curve_.misses(size) - curve_.firsts()) / queries);
        return found;
    }

  private:
    std::uint64_t unit_bytes_;
    measure::ReuseDistance reuse_;
    measure::MissCurve curve_;
    std::vector<std::uint32_t> last_step_;  ///< by unit: step + 1; 0: none
    std::uint64_t of_steps_ = 0;
};

class DemandTracer final : public measure::TraceListener {
  public:
    explicit DemandTracer(std::size_t filling) : filling_(filling) {}

    void on_access(const measure::TracedAccess& access) override {
        ++reads_;
        lines_.use(access, step_);
        pages_.use(access, step_);
    }
    void on_query_end(bool /*counts*/) override { ++queries_; }
    void on_frame_end() override {
        if (++step_ != filling_) return;
        lines_.start_counting();
        pages_.start_counting();
        queries_ = reads_ = 0;
    }

    [[nodiscard]] MemoryDemand demand(const MemorySizes& sizes) const {
        MemoryDemand result;
        result.queries = queries_;
        result.steps = step_ - std::min<std::size_t>(step_, filling_);
        if (queries_ == 0) {
            result.reason = "no pair was near in the counted steps";
            return result;
        }
        const auto queries = static_cast<double>(queries_);
        result.reads = static_cast<double>(reads_) / queries;
        result.line_misses = lines_.misses(sizes.lines, queries);
        result.page_misses = pages_.misses(sizes.pages, queries);
        result.pages = static_cast<double>(pages_.distinct());
        result.lines_of_a_step = static_cast<double>(lines_.of_steps()) / queries;
        result.pages_of_a_step = static_cast<double>(pages_.of_steps()) / queries;
        return result;
    }

  private:
    std::size_t filling_;
    std::uint32_t step_ = 0;
    std::uint64_t queries_ = 0, reads_ = 0;
    UnitReuse lines_{line_bytes}, pages_{page_bytes};
};

}  // namespace

scene::Workload workload_of(const Scene& scene) {
    const scene::SceneParameters parameters = {{"bodies", static_cast<double>(scene.bodies)},
                                               {"rotation_step", scene.rotation_step},
                                               {"step_in_dimensions", scene.step_in_dimensions},
                                               {"margin", 0},
                                               {"precession", 0.2360680},
                                               {"least_steps", static_cast<double>(scene.steps)},
                                               {"in_time_order", 1}};
    return scene::make_scene("tumble", scene::make_shape(scene.shape).or_throw(), parameters, scene.seed, 1,
                             {})
        .or_throw();
}

MemoryDemand trace_demand(const bench::TableType& type, const std::string& algorithm,
                          const scene::Workload& workload, bench::Sharing sharing, const MemorySizes& sizes,
                          std::size_t filling) {
    MemoryDemand result;
    const auto runner = type.make_runner(algorithm);
    runner->configure({.tables = {VertexOrder::given, sharing, bench::AllocatorKind::arena}});
    result.reason = runner->load(workload);
    if (!result.reason.empty()) return result;
    DemandTracer tracer(filling);
    std::vector<Distance> answers(workload.queries.size());
    runner->trace(bench::TraceExtent::everything(), tracer, answers.data());
    result = tracer.demand(sizes);
    for (const Distance& answer : answers) result.cycles += answer.cycles;
    const bench::MemoryUse memory = runner->memory();
    result.tables = static_cast<double>(memory.tables);
    result.table_bytes = memory.taken / result.tables;
    return result;
}

}  // namespace edgewise::studies::thrash
