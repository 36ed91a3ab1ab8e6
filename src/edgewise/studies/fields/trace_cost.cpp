// SPDX-License-Identifier: MIT
#include "edgewise/studies/fields/trace_cost.hpp"

#include "edgewise/measure/cache/cache_model.hpp"
#include "edgewise/measure/cache/lines_touched.hpp"

namespace edgewise::studies {

namespace {

class ModelledCaches final : public measure::TraceListener {
  public:
    explicit ModelledCaches(std::span<const measure::CacheMachine> machines) {
        for (const measure::CacheMachine& machine : machines) models_.emplace_back(machine.caches);
    }
    void on_access(const measure::TracedAccess& access) override {
        for (measure::CacheModel& model : models_) model.access(access.address, access.bytes, access.kind);
    }
    void on_query_end(bool /*counts*/) override {}

    [[nodiscard]] std::vector<measure::CacheModel>& models() { return models_; }

  private:
    std::vector<measure::CacheModel> models_;
};

}  // namespace

TraceCost cost_of(const TracePass& pass, std::span<const measure::CacheMachine> machines) {
    measure::LineCounter lines;
    ModelledCaches caches(machines);
    measure::TraceFanOut both({&lines, &caches});
    pass(both);
    for (measure::CacheModel& model : caches.models()) model.forget_counts();
    pass(caches);
    const measure::LinesTouched& sum = lines.sums().all;
    TraceCost cost{sum.queries, sum.lines, sum.reads, {}};
    for (std::size_t i = 0; i < machines.size(); ++i) {
        const measure::CacheModel& model = caches.models()[i];
        for (std::size_t level = 0; level < model.counts().size(); ++level) {
            const auto misses = static_cast<double>(model.counts(level).misses);
            cost.misses.push_back({machines[i].name, model.geometry().levels[level].name,
                                   sum.queries == 0 ? 0 : misses / static_cast<double>(sum.queries)});
        }
    }
    return cost;
}

}  // namespace edgewise::studies
