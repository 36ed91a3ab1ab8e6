// SPDX-License-Identifier: MIT
#include "edgewise/studies/thrash/thrash_rows.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "edgewise/measure/cache/segmented_lru.hpp"
#include "edgewise/measure/cache/trace.hpp"
#include "edgewise/measure/process/fault_pager.hpp"
#include "edgewise/measure/stopwatch.hpp"

namespace edgewise::studies::thrash {

namespace {

/// The tables' pages in the order in which queries use them.
class PagesUsed final : public measure::TraceListener {
  public:
    void on_access(const measure::TracedAccess& access) override {
        if (access.side == measure::TraceSide::scene) return;
        access.for_each_unit(page_bytes, [&](std::uint64_t page) {
            if (pages_.size() > first_.back() && pages_.back() == page) return;
            pages_.push_back(static_cast<std::uint32_t>(page));
        });
    }
    void on_query_end(bool /*counts*/) override { first_.push_back(pages_.size()); }

    /// use(page) for queries first .. last - 1.
    template <class Use>
    void each(std::size_t first, std::size_t last, const Use& use) const {
        for (std::size_t i = first_[first]; i < first_[last]; ++i) use(pages_[i]);
    }

  private:
    std::vector<std::uint32_t> pages_;
    std::vector<std::size_t> first_ = {0};  ///< by query, into pages_
};

struct PredictedFaults {
    std::uint64_t soft = 0, hard = 0;
};

PredictedFaults faults_of(const PagesUsed& used, std::size_t first, std::size_t last,
                          measure::SegmentedLru& memory) {
    PredictedFaults faults;
    used.each(first, last, [&](std::uint32_t page) {
        const measure::PageUse how = memory.use(page).how;
        faults.soft += how == measure::PageUse::soft || how == measure::PageUse::first;
        faults.hard += how == measure::PageUse::hard;
    });
    return faults;
}

/// Returns the end of the longest run of queries from `first` that waits no longer than the limit.
std::size_t end_within(const PagesUsed& used, std::size_t first, std::size_t last,
                       measure::SegmentedLru memory, double faults_allowed) {
    double faults = 0;
    for (std::size_t i = first; i < last; ++i) {
        faults += static_cast<double>(faults_of(used, i, i + 1, memory).hard);
        if (faults > faults_allowed) return std::max(first + 1, i);
    }
    return last;
}

/// Mapped pages: the number of entries of a TLB of the time. Hardly a page is used unseen, so the pages that
/// are evicted are those not used for longest.
constexpr std::size_t most_mapped = 64;

measure::SegmentedLru memory_of(std::size_t pages, std::uint64_t bytes) {
    const std::size_t held = std::clamp<std::size_t>(bytes / page_bytes, 2, std::max<std::size_t>(2, pages));
    return {pages, std::min(most_mapped, held / 2), held};
}

/// One point: queries before `first` fill the memory, those before `last` count.
class PointRun {
  public:
    PointRun(const bench::Runner& runner, const PagesUsed& used, measure::SegmentedLru memory)
        : runner_(runner), used_(used), memory_(std::move(memory)), range_(runner.prepared_range()) {}

    /// The refusal of the pager is passed on.
    measure::Expected<RealisedPoint> run(std::size_t first, std::size_t end, double wait_ns,
                                         double budget_ns) {
        measure::SegmentedLru filled = memory_;
        const PredictedFaults before = faults_of(used_, 0, first, filled);
        const std::size_t last = end_within(used_, first, end, filled, budget_ns / wait_ns);
        const PredictedFaults counted = faults_of(used_, first, last, filled);
        const Passes plain = passes(first, last, [] {});
        auto pager = measure::FaultPager::make(const_cast<std::byte*>(runner_.table_allocator().base()),
                                               runner_.table_allocator().taken(), memory_);
        if (!pager.value) return pager.refusal();
        measure::FaultPager& living = **pager.value;
        const Passes paged = passes(first, last, [&] {
            living.set_wait_ns(wait_ns);
            static_cast<void>(living.take_counts());
        });
        const measure::FaultCounts counts = living.take_counts();
        const auto queries = static_cast<double>(last - first);
        RealisedPoint point;
        point.queries = last - first;
        point.in_memory_ns = plain.counted_ns / queries;
        point.predicted_faults = static_cast<double>(counted.hard) / queries;
        point.predicted_soft_faults = static_cast<double>(counted.soft) / queries;
        point.faults = static_cast<double>(counts.hard) / queries;
        point.soft_faults = static_cast<double>(counts.soft) / queries;
        const auto filling_faults = static_cast<double>(before.hard + before.soft);
        point.fault_overhead_ns =
            std::max(0.0, paged.filling_ns - plain.filling_ns) / std::max(1.0, filling_faults);
        point.predicted_ns = point.in_memory_ns + point.predicted_faults * wait_ns +
                             (point.predicted_faults + point.predicted_soft_faults) * point.fault_overhead_ns;
        point.measured_ns = paged.counted_ns / queries;
        point.same_answers = plain.sum == paged.sum;
        return {point};
    }

  private:
    struct Passes {
        double filling_ns = 0, counted_ns = 0, sum = 0;
    };

    template <class Between>
    Passes passes(std::size_t first, std::size_t last, const Between& between) const {
        Passes result;
        const measure::Stopwatch filling;
        result.sum = range_(0, first, nullptr);
        result.filling_ns = filling.elapsed_ns();
        between();
        const measure::Stopwatch counted;
        result.sum += range_(first, last, nullptr);
        result.counted_ns = counted.elapsed_ns();
        return result;
    }

    const bench::Runner& runner_;
    const PagesUsed& used_;
    measure::SegmentedLru memory_;
    bench::Runner::RangePass range_;
};

measure::Expected<RealisedPoint> realise_point(const Setting& setting, const Levels& levels,
                                               const RealisedCurve& curve, std::size_t speed,
                                               double budget_ns) {
    const scene::Workload workload =
        workload_of({curve.shape, setting.bodies, speeds[speed] * setting.time_step, 0.02, levels.steps,
                     levels.seed_of(speed)});
    const bench::TableType& type = bench::table_type_called(setting.table);
    const auto runner = type.make_runner(curve.algorithm);
    const bench::Sharing sharing = setting.shared ? bench::Sharing::shared : bench::Sharing::per_instance;
    runner->configure({.tables = {VertexOrder::given, sharing, bench::AllocatorKind::memfd}});
    if (const std::string error = runner->load(workload); !error.empty()) return measure::Refusal{error};
    PagesUsed used;
    runner->trace(bench::TraceExtent::everything(), used);
    const std::size_t pages = (runner->table_allocator().taken() + page_bytes - 1) / page_bytes;
    PointRun run(*runner, used, memory_of(pages, setting.memory_bytes));
    const std::size_t filled = workload.frames[levels.filling].first_query;
    auto point = run.run(filled, workload.queries.size(), setting.fault_ns, budget_ns);
    if (point.value) point.value->speed = speeds[speed];
    return point;
}

}  // namespace

double RealisedCell::worst_ratio() const {
    double worst = 0;
    for (const RealisedCurve& curve : curves)
        for (const RealisedPoint& point : curve.points)
            worst = std::max(
                {worst, point.measured_ns / point.predicted_ns, point.predicted_ns / point.measured_ns});
    return worst;
}

std::vector<Outcome> outcomes_to_realise(const Factorial& factorial, std::size_t count) {
    const auto nearness = [](const Outcome& outcome) { return -std::abs(std::log(outcome.score.rise / 12)); };
    const auto better = [&](const Outcome* a, const Outcome* b) {
        if (a->score.count() != b->score.count()) return a->score.count() > b->score.count();
        return nearness(*a) > nearness(*b);
    };
    std::map<double, const Outcome*> best;
    for (const Outcome& outcome : factorial.outcomes) {
        if (outcome.setting.mechanism != Mechanism::queries_alone || outcome.setting.machine != 0) continue;
        const Outcome*& known = best[outcome.setting.fault_ns];
        if (!known || better(&outcome, known)) known = &outcome;
    }
    std::vector<const Outcome*> sorted;
    for (const auto& [cost, outcome] : best) sorted.push_back(outcome);
    std::stable_sort(sorted.begin(), sorted.end(), better);
    std::vector<Outcome> outcomes;
    for (std::size_t i = 0; i < std::min(count, sorted.size()); ++i) outcomes.push_back(*sorted[i]);
    return outcomes;
}

RealisedCell realise(const Outcome& outcome, const Levels& levels, double budget_ns) {
    RealisedCell cell;
    cell.setting = outcome.setting;
    const Figure8& model = outcome.figure;
    const std::tuple<const char*, const char*, const SpeedCurve*> curves[] = {
        {"sphere38", "vclip", &model.vclip_38},
        {"sphere38", "gjk", &model.gjk_38},
        {"sphere386", "vclip", &model.vclip_386},
        {"sphere386", "gjk", &model.gjk_386}};
    for (const auto& [shape, algorithm, modelled] : curves) {
        RealisedCurve curve{shape, algorithm, {}};
        for (std::size_t speed = 0; speed < speeds.size(); ++speed) {
            auto point = realise_point(cell.setting, levels, curve, speed, budget_ns);
            if (!point.value) return {cell.setting, {}, point.reason, point.remedy};
            point.value->model_ns = (*modelled)[speed];
            curve.points.push_back(*point.value);
        }
        cell.curves.push_back(std::move(curve));
    }
    return cell;
}

}  // namespace edgewise::studies::thrash
