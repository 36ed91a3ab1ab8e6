// SPDX-License-Identifier: MIT
#include "edgewise/studies/thrash/factorial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>
#include <utility>

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
            reuse_.use(unit);
            if (unit >= last_step_.size()) last_step_.resize(2 * unit + 1, 0);
            if (std::exchange(last_step_[unit], step + 1) != step + 1) ++of_steps_;
        });
    }
    void start_counting() {
        reuse_.forget_curve();
        of_steps_ = 0;
    }

    [[nodiscard]] std::uint64_t distinct() const { return reuse_.lines(); }
    [[nodiscard]] std::uint64_t of_steps() const { return of_steps_; }
    /// First uses are no misses here: they are of bodies that no step was near until then, and become fewer
    /// the longer a run is.
    [[nodiscard]] std::vector<double> misses(const std::vector<std::uint64_t>& sizes, double queries) const {
        const measure::MissCurve& curve = reuse_.curve();
        std::vector<double> found;
        for (const std::uint64_t size : sizes)
            found.push_back(static_cast<double>(curve.misses(size) - curve.firsts()) / queries);
        return found;
    }

  private:
    std::uint64_t unit_bytes_;
    measure::ReuseDistance reuse_;
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

OldMachine::OldMachine(const measure::CacheMachine& machine) : machine_(&machine) {
    if (machine.caches.line_bytes != line_bytes || machine.caches.levels.size() != 2 ||
        machine.tlbs.levels.empty() || !machine.latencies_known())
        throw std::invalid_argument(
            fmt::format("machine '{}': wants lines of {} bytes, two cache levels and a TLB with latencies",
                        machine.name, line_bytes));
}

std::vector<OldMachine> old_machines() {
    std::vector<OldMachine> machines;
    for (const char* name : {"pentium2_deschutes", "pentium3_katmai", "pentium3_coppermine"}) {
        for (const measure::CacheMachine& machine : measure::cache_machines())
            if (machine.name == name) machines.emplace_back(machine);
    }
    return machines;
}

MemorySizes sizes_for(const std::vector<OldMachine>& machines, const std::vector<std::uint64_t>& memories) {
    MemorySizes sizes;
    for (const OldMachine& machine : machines) {
        sizes.lines.insert(sizes.lines.end(), {machine.lines(0), machine.lines(1)});
        sizes.pages.push_back(machine.tlb_pages());
    }
    for (const std::uint64_t bytes : memories) sizes.pages.push_back(bytes / page_bytes);
    for (std::vector<std::uint64_t>* list : {&sizes.lines, &sizes.pages}) {
        std::sort(list->begin(), list->end());
        list->erase(std::unique(list->begin(), list->end()), list->end());
    }
    return sizes;
}

double misses_at(const std::vector<std::uint64_t>& sizes, const std::vector<double>& misses,
                 std::uint64_t size) {
    const auto found = std::lower_bound(sizes.begin(), sizes.end(), size);
    assert(found != sizes.end() && *found == size);
    return misses[static_cast<std::size_t>(found - sizes.begin())];
}

double cache_ns(const OldMachine& machine, const MemorySizes& sizes, const MemoryDemand& demand) {
    return machine.memory_time_ns(misses_at(sizes.lines, demand.line_misses, machine.lines(0)),
                                  misses_at(sizes.lines, demand.line_misses, machine.lines(1)),
                                  misses_at(sizes.pages, demand.page_misses, machine.tlb_pages()));
}

double ns_per_read(const std::vector<CalibrationPoint>& points) {
    const auto excess = [&](double k) {
        double sum = 0;
        for (const CalibrationPoint& point : points) sum += std::log(point.model_ns(k) / point.top_ns);
        return sum;
    };
    if (points.empty() || excess(0) >= 0) return 0;
    double low = 0, high = 1;
    while (excess(high) < 0) high *= 2;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (excess(middle) < 0 ? low : high) = middle;
    }
    return high;
}

}  // namespace edgewise::studies::thrash
