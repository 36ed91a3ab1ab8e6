// SPDX-License-Identifier: MIT
//
// The four facts of figure 8: each fails by itself, at both ends where it has two.
#include <gmock/gmock.h>
#include <algorithm>
#include <cmath>
#include <list>

#include "edgewise/studies/thrash/factorial.hpp"
#include "edgewise/studies/thrash/thrash_rows.hpp"

namespace edgewise::studies::thrash {
namespace {

SpeedCurve flat(double ns) {
    SpeedCurve curve;
    curve.fill(ns);
    return curve;
}

/// Returns figure 8 as the paper draws it: V-Clip goes up and down below 1.2 ms, GJK is at the bottom.
Figure8 papers_figure() {
    return {flat(7e4), flat(9e4), {9e5, 6e5, 1.1e6, 8e5, 1e6, 7e5, 1e6}, flat(7e4), flat(1e5), flat(1e5)};
}

std::array<bool, 4> all_but(Fact fact) {
    std::array<bool, 4> facts = {true, true, true, true};
    facts[static_cast<std::size_t>(fact)] = false;
    return facts;
}

TEST(Figure8Facts, HoldForThePapersFigure) {
    const FactScore found = score(papers_figure());
    EXPECT_EQ(found.count(), 4);
    EXPECT_EQ(found.mask(), 15U);
    EXPECT_NEAR(found.rise, 1.1e6 / 9e4, 1e-12);
    EXPECT_EQ(found.top_ns, 1.1e6);
    EXPECT_EQ(found.gjk_rise, 1);
    EXPECT_NEAR(found.gjk_rise_from_8, 1e5 / 7e4, 1e-12);
    EXPECT_NEAR(found.fall, 1.1e6 / 7e5, 1e-12);
}

TEST(Figure8Facts, FailAlone) {
    const auto all_but_of = [](auto&& change) {
        Figure8 figure = papers_figure();
        change(figure);
        return score(figure).holds;
    };
    for (const double small : {1.1e6 / 25, 1.1e6 / 5})
        EXPECT_EQ(all_but_of([&](Figure8& of) { of.vclip_38 = flat(small); }), all_but(Fact::rises)) << small;
    for (const double factor : {0.5, 1.2})
        EXPECT_EQ(all_but_of([&](Figure8& of) {
                      for (double& ns : of.vclip_386) ns *= factor;
                      for (double& ns : of.vclip_38) ns *= factor;
                  }),
                  all_but(Fact::takes_as_long))
            << factor;
    for (const double ns : {2.1e5, 4.9e4})
        EXPECT_EQ(all_but_of([&](Figure8& of) { of.gjk_386 = flat(ns); }), all_but(Fact::spares_gjk)) << ns;
    EXPECT_EQ(all_but_of([](Figure8& of) { of.vclip_386 = {5e5, 6e5, 7e5, 8e5, 9e5, 1e6, 1.1e6}; }),
              all_but(Fact::erratic));
    EXPECT_EQ(all_but_of([](Figure8& of) { of.gjk_386 = {1e5, 7e4, 1e5, 1e5, 1e5, 1e5, 1e5}; }),
              all_but(Fact::erratic))
        << "as erratic as V-Clip";
}

TEST(Figure8Facts, FindTheLargestFallOverAnyDistance) {
    EXPECT_NEAR(largest_fall({1, 4, 3, 5, 2, 6, 7}), 2.5, 1e-12);
    EXPECT_LT(largest_fall({1, 2, 3, 4, 5, 6, 7}), 1);
}

Outcome outcome_of(double fault_ns, std::size_t bodies, int facts, double rise) {
    Outcome outcome;
    outcome.setting.bodies = bodies;
    outcome.setting.fault_ns = fault_ns;
    outcome.score.rise = rise;
    for (int i = 0; i < facts; ++i) outcome.score.holds[static_cast<std::size_t>(i)] = true;
    return outcome;
}

TEST(ThrashRealised, TakesTheBestSettingOfEachCost) {
    Factorial factorial;
    factorial.outcomes = {outcome_of(1e4, 1, 1, 12), outcome_of(1e5, 2, 3, 20), outcome_of(1e5, 3, 3, 11),
                          outcome_of(1e5, 4, 2, 12), outcome_of(4e6, 5, 3, 12), outcome_of(1e7, 6, 3, 2),
                          outcome_of(1e7, 7, 4, 1)};
    factorial.outcomes.push_back(outcome_of(1e4, 8, 4, 12));
    factorial.outcomes.back().setting.mechanism = Mechanism::builds;
    factorial.outcomes.push_back(outcome_of(1e4, 9, 4, 12));
    factorial.outcomes.back().setting.machine = 1;
    std::vector<std::size_t> bodies;
    for (const Outcome& outcome : outcomes_to_realise(factorial, 3)) bodies.push_back(outcome.setting.bodies);
    EXPECT_THAT(bodies, testing::ElementsAre(7U, 5U, 3U));
}

TEST(ThrashRealised, FaultsAsItsTraceSaysWithTheSameAnswers) {
    Levels levels;
    levels.steps = 12;
    levels.filling = 3;
    Outcome outcome{};
    outcome.figure.vclip_386.fill(7);
    Setting& setting = outcome.setting;
    setting.table = "aos_f64";
    setting.time_step = 1.0 / 60;
    setting.bodies = 30;
    setting.memory_bytes = 1 << 20;
    setting.fault_ns = 2e4;
    const RealisedCell cell = realise(outcome, levels, 1e8);
    if (!cell.reason.empty()) {  // where the kernel refuses, it must say so
        EXPECT_THAT(cell.reason, testing::HasSubstr("userfaultfd"));
        EXPECT_TRUE(cell.curves.empty());
        return;
    }
    ASSERT_EQ(cell.curves.size(), 4U);
    double large_faults = 0;
    for (const RealisedCurve& curve : cell.curves) {
        ASSERT_EQ(curve.points.size(), speeds.size());
        for (const RealisedPoint& point : curve.points) {
            EXPECT_TRUE(point.same_answers);
            EXPECT_EQ(point.model_ns, curve.shape == "sphere386" && curve.algorithm == "vclip" ? 7 : 0);
            EXPECT_GT(point.queries, 0U);
            EXPECT_NEAR(point.faults, point.predicted_faults, 0.02 * point.predicted_faults + 0.02)
                << curve.shape << " " << curve.algorithm << " " << point.speed;
            EXPECT_GE(point.measured_ns, point.faults * setting.fault_ns);
            if (curve.shape == "sphere386" && curve.algorithm == "vclip") large_faults += point.faults;
        }
    }
    EXPECT_GT(large_faults, 1) << "1 MiB is too little for 30 tables of 263 KiB";
}

// The model's arithmetic: demands against an LRU memory that is simulated use by use, times against numbers
// added by hand, and what each mechanism adds.

/// Misses of one size, by a list that is searched; first uses count apart.
class PlainLru final : public measure::TraceListener {
  public:
    PlainLru(std::uint64_t unit, std::size_t size, std::size_t filling)
        : unit_(unit), size_(size), filling_(filling) {}

    void on_access(const measure::TracedAccess& access) override {
        access.for_each_unit(unit_, [&](std::uint64_t unit) {
            const auto known = std::find(all_.begin(), all_.end(), unit);
            const bool first = known == all_.end();
            const bool held = std::distance(all_.begin(), known) < static_cast<std::ptrdiff_t>(size_);
            if (step_ >= filling_ && !first && !held) ++misses;
            if (!first) all_.erase(known);
            all_.push_front(unit);
        });
    }
    void on_query_end(bool /*counts*/) override { queries += step_ >= filling_; }
    void on_frame_end() override { ++step_; }

    std::uint64_t misses = 0, queries = 0;

  private:
    std::uint64_t unit_;
    std::size_t size_, filling_, step_ = 0;
    std::list<std::uint64_t> all_;
};

TEST(ThrashDemand, IsThatOfAMemorySimulatedUseByUse) {
    const scene::Workload workload = workload_of({"sphere38", 20, 0.3, 0.02, 12, 5});
    for (const char* algorithm : {"vclip", "gjk"}) {
        const MemoryDemand demand = trace_demand(bench::table_type_called("aos_f64"), algorithm, workload,
                                                 bench::Sharing::per_instance, {{64, 512}, {4, 40}}, 3);
        ASSERT_TRUE(demand.reason.empty()) << demand.reason;
        const auto runner = bench::table_type_called("aos_f64").make_runner(algorithm);
        runner->configure(
            {.tables = {VertexOrder::given, bench::Sharing::per_instance, bench::AllocatorKind::arena}});
        ASSERT_EQ(runner->load(workload), "");
        for (const auto& [unit, size, found] : {std::tuple{line_bytes, 64U, demand.line_misses[0]},
                                                {line_bytes, 512U, demand.line_misses[1]},
                                                {page_bytes, 4U, demand.page_misses[0]},
                                                {page_bytes, 40U, demand.page_misses[1]}}) {
            PlainLru plain(unit, size, 3);
            runner->trace(bench::TraceExtent::everything(), plain);
            EXPECT_EQ(plain.queries, demand.queries);
            EXPECT_NEAR(static_cast<double>(plain.misses) / static_cast<double>(plain.queries), found, 1e-12)
                << algorithm << " " << unit << " x " << size;
        }
        EXPECT_GT(demand.line_misses[0], demand.line_misses[1]);
        EXPECT_EQ(demand.steps, 9U);
        EXPECT_EQ(demand.tables, 20);
    }
}

/// A demand by hand on the Pentium II: 333 MHz; 3, 28 and 142 cycles; 512 and 16384 lines, 64 pages.
struct ByHand {
    std::vector<OldMachine> machines = old_machines();
    MemorySizes sizes = sizes_for(machines, {16 << 20, 64 << 20});
    MemoryDemand demand;
    TimedScene scene;
    Setting setting;

    ByHand() {
        demand.queries = 1000;
        demand.steps = 10;
        demand.reads = 100;
        demand.line_misses.assign(sizes.lines.size(), 0);
        demand.page_misses.assign(sizes.pages.size(), 0);
        demand.line_misses[0] = 30;
        for (std::size_t i = 1; i < sizes.lines.size(); ++i) demand.line_misses[i] = 10;
        demand.page_misses[0] = 5;
        demand.page_misses[sizes.pages.size() - 2] = 0.25;
        demand.tables = 300;
        demand.table_bytes = 268992;
        demand.pages = 15000;
        scene = {&machines[0], &sizes, &demand, 2, 50000, true, true};
        setting.memory_bytes = 16 << 20;
        setting.fault_ns = 1e6;
    }
    [[nodiscard]] double of(Mechanism mechanism, double intensity = 0) {
        setting.mechanism = mechanism;
        setting.intensity = intensity;
        return query_ns(scene, setting);
    }
};

constexpr double cycle_ns = 1000.0 / 333;
constexpr double caches_by_hand = (20 * 25 + 10 * 139 + 5 * 2 * 25) * cycle_ns;

TEST(ThrashTime, AddsReadsCachesTlbAndFaults) {
    ByHand by_hand;
    ASSERT_EQ(by_hand.machines.size(), 3U);
    EXPECT_NEAR(by_hand.of(Mechanism::queries_alone), 200 + caches_by_hand + 0.25e6, 1e-6);
    by_hand.setting.memory_bytes = 64 << 20;
    EXPECT_NEAR(by_hand.of(Mechanism::queries_alone), 200 + caches_by_hand, 1e-6);
}

TEST(ThrashTime, AddsWhatMechanismsCost) {
    ByHand by_hand;
    const double alone = by_hand.of(Mechanism::queries_alone);
    EXPECT_NEAR(by_hand.of(Mechanism::builds, 0.01) - alone, 0.01 * 50000 * 2, 1e-6);
    EXPECT_NEAR(by_hand.of(Mechanism::builds_of_vclip, 0.01) - alone, 0.01 * 50000 * 2, 1e-6);
    EXPECT_NEAR(by_hand.of(Mechanism::capped_cycles, 10) - alone, 10 * reads_per_feature_step * 2, 1e-6);
    EXPECT_NEAR(by_hand.of(Mechanism::first_touches) - alone, 15000 / 30000.0 * 1e6, 1e-6);
    by_hand.scene.is_vclip = false;
    for (const Mechanism of_vclip :
         {Mechanism::builds_of_vclip, Mechanism::capped_cycles, Mechanism::whole_table_transform})
        EXPECT_EQ(by_hand.of(of_vclip, 0.01), alone);
}

/// 300 tables of 8406 lines, 65.67 pages, in 100 queries a step: more than any cache, more than 16 MiB, and
/// less than 1 GiB.
TEST(ThrashTime, SweepsOverWholeTablesMissEverything) {
    ByHand by_hand;
    const double alone = by_hand.of(Mechanism::queries_alone);
    const double lines = 300.0 * 268992 / 32, pages = 300.0 * 268992 / 4096;
    const double expected = (lines * (21 + 139) + pages * 50) * cycle_ns / 100 + pages * 1e6 / 100;
    EXPECT_NEAR(by_hand.of(Mechanism::whole_table_transform) - alone, expected, 1e-6 * expected);
    by_hand.setting.memory_bytes = 64 << 20;
    const double faults = by_hand.of(Mechanism::whole_table_transform);
    by_hand.demand.tables = 3;
    by_hand.demand.table_bytes = 100;
    EXPECT_LT(by_hand.of(Mechanism::whole_table_transform) - by_hand.of(Mechanism::queries_alone), 100);
    EXPECT_GT(faults, 1e8);
}

TEST(ThrashTime, IsCalibratedOnTheMeanOfLogarithms) {
    const std::vector<CalibrationPoint> points = {{4, 3e4, 150, 0}, {6, 7e4, 180, 100}, {7, 1e5, 290, 2000}};
    const double k = ns_per_read(points);
    double sum = 0;
    for (const CalibrationPoint& point : points) sum += std::log(point.model_ns(k) / point.top_ns);
    EXPECT_NEAR(sum, 0, 1e-9);
    EXPECT_EQ(ns_per_read({{7, 100, 10, 1000}}), 0) << "memory alone takes longer";
}

TEST(ThrashFactorial, ScoresEveryCombinationOnce) {
    Levels levels;
    levels.tables = {"aos_f64"};
    levels.bodies = {20};
    levels.memories_mib = {16, 64};
    levels.fault_costs_ns = {1e4};
    levels.time_steps = {1.0 / 60};
    levels.steps = 12;
    levels.filling = 2;
    std::size_t traced = 0;
    std::atomic<bool> stop = false;
    const Factorial found = run_factorial(
        levels, [&] { ++traced; }, stop);
    EXPECT_EQ(traced, 2U * 3 * 2 * 7);  // algorithms, shapes, sharing, speeds
    EXPECT_EQ(traced, scenes_to_trace(levels));
    // Mechanisms but the transform of shared tables; memories; machines.
    EXPECT_EQ(found.outcomes.size(), (12U + 11) * 2 * 3);
    EXPECT_EQ(found.builds.size(), 6U);
    for (const BuildCost& build : found.builds) EXPECT_GT(build.reads, 0) << build.shape;
    for (const Outcome& outcome : found.outcomes) {
        const auto rising = outcome.figure.vclip_386;
        EXPECT_GT(*std::min_element(rising.begin(), rising.end()), 0);
        EXPECT_EQ(outcome.score.mask(), score(outcome.figure).mask());
    }
    stop = true;
    EXPECT_TRUE(run_factorial(
                    levels, [] {}, stop)
                    .outcomes.empty());
}

}  // namespace
}  // namespace edgewise::studies::thrash
