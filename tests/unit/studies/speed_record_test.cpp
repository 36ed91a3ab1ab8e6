// SPDX-License-Identifier: MIT
//
// Runs drawn from known truths: a right build passes, a slowdown is caught and named, whatever the noise.
#include "edgewise/studies/gate/run.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdio>

#include "gate_records.hpp"

namespace edgewise::studies {
namespace {

using measure::ComparedRow;
using measure::FigureRecord;
using measure::Outcome;
using measure::RecordComparison;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr std::uint64_t drawn_runs = 60;
constexpr std::size_t none_slowed = 1'000'000;

struct Ratio {
    double low, value, high;
};

FigureRecord record_of(const std::vector<Ratio>& ratios) {
    FigureRecord record = drawn_record(1, none_slowed, 1);
    record.rows.resize(ratios.size());
    for (std::size_t i = 0; i < ratios.size(); ++i) {
        record.rows[i].low = ratios[i].low;
        record.rows[i].value = ratios[i].value;
        record.rows[i].high = ratios[i].high;
    }
    return record;
}

FigureRecord with_slack(FigureRecord record, double slack) {
    record.slack = slack;
    return record;
}

std::vector<std::string> slower_cells(const RecordComparison& found) {
    std::vector<std::string> cells;
    for (const ComparedRow& row : found.rows)
        if (row.outcome == Outcome::worse) cells.push_back(row.is.cell);
    return cells;
}

TEST(SpeedRecord, ARightBuildPasses) {
    const FigureRecord baseline = drawn_record(1, none_slowed, 1);
    double worst = 0;
    for (std::uint64_t seed = 2; seed < 2 + drawn_runs; ++seed) {
        const RecordComparison found = compare_speed(baseline, drawn_record(seed, none_slowed, 1));
        ASSERT_THAT(found.rows, SizeIs(baseline.rows.size()));
        EXPECT_TRUE(found.passed()) << seed << ": " << slower_cells(found).front();
        EXPECT_EQ(found.count(Outcome::better), 0u);
        for (const ComparedRow& row : found.rows) worst = std::max(worst, row.change());
    }
    std::printf("gate: of a right build's ratios the worst grew by %.3f\n", worst);
    EXPECT_GT(worst, 1) << "noise was none";
}

TEST(SpeedRecord, ASlowdownOfOneCellFailsAndIsNamedFirst) {
    const FigureRecord baseline = drawn_record(1, none_slowed, 1);
    double least = 10;
    for (std::uint64_t seed = 2; seed < 2 + drawn_runs; ++seed) {
        const std::size_t slowed = seed % baseline.rows.size();
        const RecordComparison found = compare_speed(baseline, drawn_record(seed, slowed, 1.3));
        EXPECT_FALSE(found.passed()) << seed;
        EXPECT_THAT(slower_cells(found), ElementsAre(baseline.rows[slowed].cell)) << seed;
        EXPECT_EQ(found.rows.front().is.cell, baseline.rows[slowed].cell) << "worst first";
        least = std::min(least, found.rows.front().least_change());
    }
    std::printf("gate: of a slowdown by 1.3 the intervals showed %.3f at least\n", least);
}

TEST(SpeedRecord, AFasterCellIsNamedAndPasses) {
    const FigureRecord baseline = drawn_record(1, none_slowed, 1);
    const RecordComparison found = compare_speed(baseline, drawn_record(2, 5, 0.5));
    EXPECT_TRUE(found.passed());
    EXPECT_EQ(found.count(Outcome::better), 1u);
    EXPECT_EQ(found.rows.front().is.cell, baseline.rows[5].cell);
}

/// The bound is the baseline's ratio and the slack, and the lower end alone decides.
TEST(SpeedRecord, NoiseWithinTheIntervalPasses) {
    const FigureRecord baseline = record_of({{1.9, 2, 2.1}});
    EXPECT_TRUE(compare_speed(baseline, record_of({{2.19, 3, 9}})).passed());
    EXPECT_FALSE(compare_speed(baseline, record_of({{2.21, 2.3, 2.4}})).passed());
    EXPECT_TRUE(compare_speed(with_slack(baseline, 0.11), record_of({{2.21, 2.3, 2.4}})).passed());
    EXPECT_FALSE(compare_speed(with_slack(baseline, 0), record_of({{2.005, 2.01, 2.02}})).passed());
    EXPECT_EQ(compare_speed(baseline, record_of({{0.9, 1, 1.9}})).count(Outcome::better), 0u);
}

/// Cells divided by a reference follow it.
TEST(SpeedRecord, AReferenceThatChangedHasANote) {
    const FigureRecord baseline = record_of({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}});
    FigureRecord now = baseline;
    now.rows[0].low = now.rows[0].value = now.rows[0].high = 0.5;
    const RecordComparison found = compare_speed(baseline, now);
    EXPECT_EQ(found.rows.front().is.cell, baseline.rows[0].cell);
    EXPECT_THAT(found.rows.front().note, HasSubstr("cold cube8"));
    EXPECT_THAT(found.rows.back().note, IsEmpty());
}

/// A second look is at rows that seem slower, and at no other.
TEST(SpeedRecord, ASecondLookAcquitsAndNeverAccuses) {
    const FigureRecord baseline = record_of({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}});
    FigureRecord now = record_of({{1, 1, 1}, {1.5, 2, 3}, {1.4, 1.6, 2}});
    const RecordComparison found = compare_speed(baseline, now);
    ASSERT_EQ(found.count(Outcome::worse), 2u);
    look_again(now, found, record_of({{4, 5, 6}, {1, 1.05, 1.2}, {1.7, 1.8, 1.9}}));
    EXPECT_EQ(now.rows[0].value, 1) << "it did not seem slower";
    EXPECT_EQ(now.rows[1].value, 1.05) << "acquitted";
    EXPECT_EQ(now.rows[2].value, 1.6) << "the kinder of two";
    EXPECT_THAT(slower_cells(compare_speed(baseline, now)), ElementsAre(baseline.rows[2].cell));
}

TEST(SpeedRecord, GroupsOfWhatSeemsSlowerAreNamedOnce) {
    FigureRecord baseline = record_of({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}});
    baseline.rows[3].cell = "gjk lean_f64 cold sphere38";
    FigureRecord now = baseline;
    for (const std::size_t slower : {1, 2, 3}) now.rows[slower].low = now.rows[slower].value = 1.9;
    EXPECT_THAT(suspect_groups(compare_speed(baseline, now)),
                testing::UnorderedElementsAre("cold cube8", "cold sphere38"));
    EXPECT_THAT(suspect_groups(compare_speed(baseline, baseline)), IsEmpty());
    EXPECT_EQ(gate_table_of(baseline.rows[3].cell), "lean_f64");
}

/// Over many builds that are right, one look errs on some where intervals are as wrong as 95 % ones may be;
/// three looks on none, and a slowdown outlasts them all.
TEST(SpeedRecord, ThreeLooksErrLessThanOneAndMissNothing) {
    // A slack below the noise of a median of 17 rounds.
    const FigureRecord baseline = with_slack(drawn_record(1, none_slowed, 1), 0.012);
    std::size_t one_look = 0, three_looks = 0, missed = 0;
    for (std::uint64_t seed = 2; seed < 2 + drawn_runs; ++seed) {
        for (const bool slow : {false, true}) {
            const std::size_t slowed = slow ? 7 : none_slowed;
            FigureRecord now = drawn_record(seed, slowed, 1.3);
            RecordComparison found = compare_speed(baseline, now);
            if (!slow) one_look += found.count(Outcome::worse);
            for (std::uint64_t look = 1; look <= 2; ++look) {
                look_again(now, found, drawn_record(seed + 1000 * look, slowed, 1.3));
                found = compare_speed(baseline, now);
            }
            if (!slow) three_looks += found.count(Outcome::worse);
            const std::vector<std::string> names = slower_cells(found);
            missed += slow && std::ranges::find(names, baseline.rows[7].cell) == names.end();
        }
    }
    std::printf("gate: of %llu right builds one look accused %zu cells, three looks %zu; missed %zu\n",
                static_cast<unsigned long long>(drawn_runs), one_look, three_looks, missed);
    EXPECT_GT(one_look, 0u) << "noise was none";
    EXPECT_LT(4 * three_looks, one_look);
    EXPECT_EQ(missed, 0u);
}

TEST(SpeedRecord, RatiosAreOfTheSameRound) {
    const std::vector<double> times = {2, 4, 6, 8, 10, 12}, beside = {1, 2, 3, 4, 5, 6};
    const auto row = gate_row("c", over_kernel, times, beside);
    ASSERT_TRUE(row);
    EXPECT_THAT((std::vector{row->low, row->value, row->high}), Each(2));
    EXPECT_TRUE(row->has_interval);
    EXPECT_FALSE(gate_row("c", "f", std::span(times).first(5), std::span(beside).first(5))) << "no interval";
    EXPECT_FALSE(gate_row("c", "f", beside, std::vector<double>{1, 2, 0, 4, 5, 6}));
    EXPECT_FALSE(gate_row("c", "f", std::vector<double>{1, 2, 0, 4, 5, 6}, beside));
}

}  // namespace
}  // namespace edgewise::studies
