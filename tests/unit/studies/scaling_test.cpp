// SPDX-License-Identifier: MIT
//
// Structure of the scaling study: numbers of threads, rows for each number, sums that must equal those of
// single queries, and refused options. No test expects a speedup from more threads.
#include "edgewise/studies/threads/scaling.hpp"

#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "../complaint.hpp"

namespace edgewise::studies {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

CellChoice small_cell(const char* table, const char* algorithm) {
    return {.table = table,
            .algorithm = algorithm,
            .scene = "pressure",
            .shape = "sphere18",
            .parameters = {{"bodies", 200}},
            .queries = 1000,
            .checked = 20};
}

TEST(Scaling, NumbersOfThreadsGoUpToTheCores) {
    EXPECT_THAT(scaling_threads({}, 1), ElementsAre(1));
    EXPECT_THAT(scaling_threads({}, 8), ElementsAre(1, 2, 4, 8));
    EXPECT_THAT(scaling_threads({}, 6), ElementsAre(1, 2, 4, 6));
    const int asked[] = {4, 2, 4};
    EXPECT_THAT(scaling_threads(asked, 4), ElementsAre(1, 2, 4));
    EXPECT_GE(usable_cores(), 1);
}

TEST(Scaling, RefusesMoreThreadsThanCores) {
    for (const int count : {3, 0, -1}) {
        const std::string why = complaint_of<std::invalid_argument>([&] {
            return scaling_threads({&count, 1}, 2);
        });
        EXPECT_THAT(why, HasSubstr("--threads " + std::to_string(count)));
        EXPECT_THAT(why, HasSubstr("has 2 cores"));
        EXPECT_THAT(why, HasSubstr("ask for 1 to 2"));
    }
}

TEST(Scaling, HoldsSumsAgainstTheSinglePass) {
    EXPECT_EQ(compare_sums(1.25, 1.25, 2, "share the tables"), "");
    const std::string wrong = compare_sums(std::nextafter(1.25, 2), 1.25, 2, "share the tables");
    EXPECT_THAT(wrong, HasSubstr("2 threads that share the tables gave other answers"));
    EXPECT_THAT(wrong, HasSubstr("1.2500000000000002, not 1.25"));
}

TEST(Scaling, RefusesWhatBatchesDoNotAnswer) {
    for (const Needs needs : {Needs::nearer, Needs::features, Needs::certificate}) {
        ScalingPlan plan{small_cell("lean_f64", "gjk")};
        plan.cell.needs = needs;
        const std::string why = complaint_of<std::invalid_argument>([&] {
            return measure_scaling(
                plan, [] {}, std::atomic<bool>(false));
        });
        EXPECT_THAT(why, HasSubstr(std::string(to_string(needs)))) << why;
    }
}

void expect_way(const WayOfSharing& way, int threads) {
    EXPECT_GT(way.queries_per_second, 0);
    EXPECT_GT(way.speed_up, 0);
    EXPECT_DOUBLE_EQ(way.efficiency, way.speed_up / threads);
}

TEST(Scaling, HasARowForEachNumberOfThreads) {
    const tbb::global_control three(tbb::global_control::max_allowed_parallelism, 3);
    for (const auto& [table, algorithm] : {std::pair{"lean_f64", "vclip"}, {"points_soa_f64", "gjk"}}) {
        int rounds = 0;
        const ScalingPlan plan{small_cell(table, algorithm), {1, 2, 3}, 3};
        const Scaling found = measure_scaling(
            plan, [&] { ++rounds; }, std::atomic<bool>(false));
        EXPECT_EQ(found.wrong, "");
        EXPECT_EQ(rounds, 3);
        EXPECT_EQ(found.queries, 1000U);
        EXPECT_EQ(found.frames, 6U) << "of 199 pairs";
        EXPECT_EQ(found.checked, 20U);
        EXPECT_EQ(found.passes, 3 * (2 + 3 + 4U)) << "one of shared tables, one for each thread of its own";
        EXPECT_GT(found.table_bytes, 200 * 18 * 3 * sizeof(float));
        ASSERT_EQ(found.rows.size(), 3U);
        for (std::size_t i = 0; i < 3; ++i) {
            const ScalingRow& row = found.rows[i];
            EXPECT_EQ(row.threads, plan.threads[i]);
            expect_way(row.shared, row.threads);
            expect_way(row.apart, row.threads);
            EXPECT_GT(row.contention, 0);
            std::printf("%s %d threads: speed-up %.2f and %.2f, contention %.2f\n", table, row.threads,
                        row.shared.speed_up, row.apart.speed_up, row.contention);
        }
        EXPECT_EQ(found.rows[0].shared.speed_up, 1) << "over itself";
        EXPECT_EQ(found.rows[0].contention, 1);
    }
}

TEST(Scaling, StopsWhenAsked) {
    std::atomic<bool> stop = false;
    const Scaling found = measure_scaling(
        {small_cell("lean_f64", "gjk"), {1}, 1000}, [&] { stop = true; }, stop);
    ASSERT_EQ(found.rows.size(), 1U);
    EXPECT_EQ(found.passes, 2U) << "one round";
    const Scaling nothing = measure_scaling(
        {small_cell("lean_f64", "gjk"), {1}, 1000}, [] {}, stop);
    EXPECT_TRUE(nothing.rows.empty());
}

TEST(ThreadRace, CopiesHaveNothingInCommonButTheirAnswers) {
    const tbb::global_control three(tbb::global_control::max_allowed_parallelism, 3);
    const SingleCell cell(small_cell("lean_f64", "vclip"));
    std::vector<CellCopy> copies;
    for (int i = 0; i < 4; ++i) copies.emplace_back(cell, bench::RunnerOptions{});
    const double expected = cell.runner().prepared_range()(0, 1000, nullptr);
    const std::vector<TimedPass> passes = time_apart(copies);
    ASSERT_EQ(passes.size(), 4U);
    for (const TimedPass& pass : passes) {
        EXPECT_EQ(pass.sum, expected);
        EXPECT_GT(pass.ns, 0);
    }
    EXPECT_EQ(time_shared(copies[0].pass(), 3).sum, expected);
}

}  // namespace
}  // namespace edgewise::studies
