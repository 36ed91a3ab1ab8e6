// SPDX-License-Identifier: MIT
//
// The first look of an advice: all cells of the program, each in or out for what it is, whatever they take.
#include "edgewise/studies/advise/screen.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/scenes.hpp"

namespace edgewise::studies::advise {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

CaseAsked three_spheres(double error_limit) {
    CaseAsked asked;
    asked.shape = {"sphere386", "built-in", *scene::make_shape("sphere386"), {}};
    asked.scene = usual_scene(false, 3, 0.1);
    asked.error_limit = error_limit;
    return asked;
}

/// `advise` and the page answer the same question about a body.
TEST(Screen, TheUsualScenesAreScenesOfPlanQuick) {
    const auto numbers = [](const sweep::SceneChoice& scene) {
        return scene::complete_parameters(scene.name, scene.parameters).or_throw();
    };
    const sweep::Plan quick = sweep::make_plan("quick");
    for (const bool own_tables : {false, true}) {
        const sweep::SceneChoice asked = usual_scene(own_tables, usual_bodies(own_tables), usual_turn);
        EXPECT_TRUE(std::ranges::any_of(quick.scenes, [&](const sweep::SceneChoice& scene) {
            return scene.name == asked.name && numbers(scene) == numbers(asked);
        })) << asked.name;
    }
}

constexpr ScreenOptions short_look{.queries = 60, .checked = 6, .passes = 1, .slowest = 1e9};

Screen look(double error_limit, const ScreenOptions& options = short_look) {
    return screen(three_spheres(error_limit), options, [] { return false; });
}

std::size_t cells_of_program() {
    std::size_t cells = 0;
    for (const bench::TableType& type : bench::table_types()) cells += type.algorithms.size();
    return cells;
}

/// Returns the number of cells with layouts for bodies of fewer vertices; not every build has such layouts.
std::size_t cells_that_refuse(const Polyhedron& body) {
    std::size_t cells = 0;
    for (const bench::TableType& type : bench::table_types())
        if (!type.stored_body(body)) cells += type.algorithms.size();
    return cells;
}

TEST(Screen, LooksAtEachCellOnceAndSaysWhyItIsOut) {
    const double limit = 1e-9;
    const Screen seen = look(limit);
    EXPECT_EQ(seen.left_out, 0U);
    std::set<std::string> names;
    std::map<DroppedFor, std::size_t> count;
    double worst_double = 0, least_single = 1;
    for (const ScreenedCell& cell : seen.cells) {
        names.insert(cell.name());
        ++count[cell.dropped_for];
        EXPECT_EQ(cell.is_in(), cell.dropped.empty()) << cell.name();
        if (cell.dropped_for == DroppedFor::failure) continue;
        EXPECT_EQ(cell.dropped_for == DroppedFor::error, cell.error > limit) << cell.name() << cell.error;
        if (cell.dropped_for == DroppedFor::error) {
            EXPECT_THAT(cell.dropped, HasSubstr("is over 1e-09"));
        }
        if (cell.type->storage == "double") worst_double = std::max(worst_double, cell.error);
        if (cell.type->precision == "f32") least_single = std::min(least_single, cell.error);
        EXPECT_GT(cell.ns, 0);
        EXPECT_DOUBLE_EQ(cell.bytes_per_edge * 1152, cell.table_bytes);
    }
    EXPECT_EQ(names.size(), cells_of_program());
    EXPECT_EQ(seen.cells.size(), cells_of_program());
    std::printf("worst error of double %.2g, least of single %.2g\n", worst_double, least_single);
    EXPECT_LT(worst_double, 1e-12);
    EXPECT_GT(least_single, 1e-9);
    EXPECT_GT(count[DroppedFor::nothing], 5U);
    EXPECT_GT(count[DroppedFor::error], 5U);
    EXPECT_EQ(count[DroppedFor::failure], cells_that_refuse(three_spheres(limit).shape.body));
    EXPECT_EQ(count[DroppedFor::time], 0U);
}

TEST(Screen, PutsWhoIsInFirstAndTheFastestBeforeOthers) {
    const Screen seen = look(1e-9);
    EXPECT_TRUE(std::ranges::is_sorted(
        seen.cells, {}, [](const ScreenedCell& cell) { return std::pair(!cell.is_in(), cell.ns); }));
    EXPECT_TRUE(seen.cells.front().is_in());
}

TEST(Screen, LetsAllInThatALargeErrorAllows) {
    for (const ScreenedCell& cell : look(1).cells)
        EXPECT_NE(cell.dropped_for, DroppedFor::error) << cell.name();
}

/// Only the fastest cell is left, with the baseline and cells with the same time as the fastest.
TEST(Screen, LeavesOutWhoIsSlowerThanAllowedButNotTheBaseline) {
    ScreenOptions strict = short_look;
    strict.slowest = 1;
    const Screen seen = look(1e-9, strict);
    const double fastest = seen.cells.front().ns;
    int slow = 0;
    for (const ScreenedCell& cell : seen.cells) {
        if (cell.is_in() && !cell.is_baseline()) {
            EXPECT_EQ(cell.ns, fastest) << cell.name();
        }
        if (cell.dropped_for != DroppedFor::time) continue;
        ++slow;
        EXPECT_GT(cell.ns, fastest) << cell.name();
        EXPECT_FALSE(cell.is_baseline());
        EXPECT_THAT(cell.dropped, HasSubstr("times as long as the fastest"));
    }
    EXPECT_GT(slow, 5);
}

TEST(Screen, BeginsWithTheBaselineAndEndsWithVariantsWhereItIsStopped) {
    for (const std::size_t most : {std::size_t{0}, std::size_t{1}, std::size_t{9}}) {
        std::size_t asked = 0;
        const Screen seen = screen(three_spheres(1e-6), short_look, [&] { return asked++ == most; });
        EXPECT_EQ(seen.cells.size(), most);
        EXPECT_EQ(seen.left_out, cells_of_program() - most);
        EXPECT_EQ(std::ranges::count_if(seen.cells, &ScreenedCell::is_baseline), most > 0 ? 1 : 0);
        for (const ScreenedCell& cell : seen.cells) EXPECT_TRUE(cell.type->variant_of.empty());
    }
}

// How much of a race fits into a time: never more than fits, and as much as does.

TEST(RacePlan, CountsEveryPart) {
    EXPECT_DOUBLE_EQ(race_seconds({2, 0.1, 5}, {3, 25}), 4 * (2 + 25 * 0.1) + 5)
        << "three processes, and one more part for bodies that fit the cache";
}

TEST(RacePlan, IsWholeWhereThereIsTime) {
    const RacePlan plan = race_within(1000, {2, 0.1, 5});
    EXPECT_EQ(plan.processes, 3);
    EXPECT_EQ(plan.rounds, 25);
}

TEST(RacePlan, GivesUpRoundsBeforeProcesses) {
    const RacePlan plan = race_within(4 * (2 + 7.5 * 0.1) + 5, {2, 0.1, 5});
    EXPECT_EQ(plan.processes, 3);
    EXPECT_EQ(plan.rounds, 7);
}

TEST(RacePlan, IsTheLargestThatFits) {
    scene::Rng rng(11);
    std::set<int> processes, rounds;
    int least = 0;
    for (int trial = 0; trial < 5000; ++trial) {
        const RaceCost cost{rng.uniform(0.01, 5), rng.uniform(0.001, 1), rng.uniform(0, 10)};
        const double seconds = rng.uniform(0.1, 60);
        const RacePlan plan = race_within(seconds, cost);
        processes.insert(plan.processes);
        rounds.insert(plan.rounds);
        ASSERT_GE(plan.processes, least_race.processes);
        ASSERT_LE(plan.processes, whole_race.processes);
        ASSERT_GE(plan.rounds, least_race.rounds);
        ASSERT_LE(plan.rounds, whole_race.rounds);
        if (race_seconds(cost, plan) > seconds) {
            ++least;
            EXPECT_EQ(plan.processes, least_race.processes);
            EXPECT_EQ(plan.rounds, least_race.rounds);
            continue;
        }
        if (plan.rounds < whole_race.rounds) {
            EXPECT_GT(race_seconds(cost, {plan.processes, plan.rounds + 1}), seconds);
        }
        if (plan.processes < whole_race.processes) {
            EXPECT_GT(race_seconds(cost, {plan.processes + 1, least_race.rounds}), seconds);
        }
    }
    EXPECT_EQ(processes.size(), 3U);
    EXPECT_EQ(rounds.size(), 21U);
    EXPECT_GT(least, 100);
}

// Pieces of work under a limit, by a clock of the test's own: one is begun only where one as long as the
// longest so far still ends in time.

TEST(TimeLimit, LooksAtTheLongestPieceSoFar) {
    double now = 0;
    TimeLimit limit([&] { return now; }, 10);
    EXPECT_TRUE(limit.begin_piece());
    now = 3;
    EXPECT_TRUE(limit.begin_piece());
    now = 4;
    EXPECT_TRUE(limit.begin_piece()) << "until 7, if it is as long as the first";
    now = 6.9;
    EXPECT_TRUE(limit.begin_piece());
    EXPECT_NEAR(limit.left(), 3.1, 1e-12);
    now = 7;
    EXPECT_FALSE(limit.begin_piece()) << "until 10";
    now = 11;
    EXPECT_FALSE(limit.begin_piece());
    EXPECT_LT(limit.left(), 0);
}

/// Over the end goes only a piece longer than all before it, and never a second one.
TEST(TimeLimit, IsExceededByNoMoreThanAPieceThatNobodyCouldForesee) {
    scene::Rng rng(5);
    int kept = 0, exceeded = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        double now = 0, longest = 0, last = 0;
        const double end = rng.uniform(0.5, 20);
        TimeLimit limit([&] { return now; }, end);
        while (limit.begin_piece()) {
            ASSERT_LE(now, end);
            longest = std::max(longest, last);
            last = rng.uniform(0.1, 2);
            now += last;
        }
        ++(now <= end ? kept : exceeded);
        if (now > end) {
            EXPECT_GT(last, longest);
        }
    }
    EXPECT_GT(kept, 100);
    EXPECT_GT(exceeded, 100);
}

// A prediction from made-up misses. Sums were done by hand.

TEST(Prediction, WaitsForEachLevel) {
    CacheCost cost;
    cost.in_cache_ns = 100;
    cost.misses = {{this_machine, {10, 4}}, {"one_level", {10}}, {"three_levels", {10, 4, 1}}};
    predict(cost, std::vector<double>{5, 80});  // the second level, memory
    EXPECT_DOUBLE_EQ(cost.predicted_ns.at(this_machine), 100 + 6 * 5 + 4 * 80);
    EXPECT_DOUBLE_EQ(cost.predicted_ns.at("one_level"), 100 + 10 * 80);
    EXPECT_DOUBLE_EQ(cost.predicted_ns.at("three_levels"), 100 + 6 * 5 + 3 * 80 + 1 * 80);
}

TEST(Prediction, IsNoneWithoutLatenciesOrTheTimeInCache) {
    CacheCost cost;
    cost.misses = {{this_machine, {10, 4}}};
    predict(cost, std::vector<double>{5, 80});
    cost.in_cache_ns = 100;
    predict(cost, {});
    EXPECT_TRUE(cost.predicted_ns.empty());
}

// Sentences on how another question would change an advice: each appears if and only if it is true.

ScreenedCell looked_at(const std::string& table, double ns, double bytes = 10,
                       DroppedFor dropped_for = DroppedFor::nothing, double error = 0) {
    ScreenedCell cell;
    cell.type = &bench::table_type_called(table);
    cell.algorithm = "vclip";
    cell.ns = ns;
    cell.bytes_per_edge = bytes;
    cell.error = error;
    cell.dropped_for = dropped_for;
    return cell;
}

Taken taken_lean(double error = 0) { return {"V-Clip on lean_f64", 12.8, error}; }

const std::string one_table = "one table for all bodies: ",
                  shared_best = "V-Clip on aos_f64, 290 ns at a first look";

TEST(AdviceChanges, AreNoneWhereNothingWould) {
    EXPECT_THAT(what_would_change({}, {}, {}, taken_lean()), IsEmpty());
}

TEST(AdviceChanges, NameTheFastestWithTablesSharedTheOtherWay) {
    CaseAsked asked;
    asked.own_tables = true;
    const ScreenedCell aos = looked_at("aos_f64", 290), lean = looked_at("lean_f64", 600),
                       other = looked_at("hot_cold_f64", 300);
    EXPECT_THAT(what_would_change(asked, {}, {aos, lean}, taken_lean()),
                ElementsAre(one_table + shared_best + "; V-Clip on lean_f64 then takes 600 ns"));
    EXPECT_THAT(what_would_change(asked, {}, {aos, other}, taken_lean()),
                ElementsAre(one_table + shared_best + "; V-Clip on lean_f64 is then dropped"));
    EXPECT_THAT(what_would_change(asked, {}, {lean, aos}, taken_lean()),
                ElementsAre(one_table + "V-Clip on lean_f64, 600 ns at a first look"));
    asked.own_tables = false;
    EXPECT_THAT(
        what_would_change(asked, {}, {aos, other}, taken_lean()),
        ElementsAre("a table for each body: " + shared_best + "; V-Clip on lean_f64 is then dropped"));
}

TEST(AdviceChanges, NameTheCellThatALargerErrorAllows) {
    Screen screen;
    screen.cells = {looked_at("lean_f64", 700, 12.8),
                    looked_at("linked_f64", 500, 138, DroppedFor::error, 1e-7),
                    looked_at("points_soa_f64", 600, 5, DroppedFor::failure, 1),
                    looked_at("lean_f32", 650, 5, DroppedFor::time, 1e-17),
                    looked_at("quantised_f64", 819, 6.8, DroppedFor::error, 1.1e-5)};
    EXPECT_THAT(
        what_would_change({}, screen, {}, taken_lean()),
        ElementsAre("an error of 1.1e-05 allowed: V-Clip on quantised_f64 becomes possible (6.8 bytes per "
                    "edge, 819 ns)"))
        << "not a larger, wrong or slow cell";
}

TEST(AdviceChanges, NameTheErrorBelowWhichTheTakenGoes) {
    EXPECT_THAT(what_would_change({}, {}, {}, taken_lean(8.2e-8)),
                ElementsAre("an error below 8.2e-08 asked for: V-Clip on lean_f64 is dropped"));
}

}  // namespace
}  // namespace edgewise::studies::advise
