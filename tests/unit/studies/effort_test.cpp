// SPDX-License-Identifier: MIT
//
// How the effort of queries is put together: differences of counted passes, answers held against those that
// were checked, vertices counted from a trace, and figures that say why there is no number.
#include "edgewise/studies/effort/effort.hpp"

#include <gmock/gmock.h>

#include <cstdio>

#include "edgewise/store/vocabulary.hpp"

namespace edgewise::studies {
namespace {

using testing::HasSubstr;

/// 500 before the passes and after, then 30 queries of 100, 20, 4, 2 and 5.
measure::CallgrindCounts counted(int passes) {
    const double queries = 30.0 * passes;
    return {500 + 100 * queries, 50 + 20 * queries, 7 + 4 * queries, 3 + 2 * queries, 11 + 5 * queries};
}

TEST(Effort, CountsAreDifferencesOfPasses) {
    const auto each = counts_per_query(counted(1), counted(3), 2, 30);
    ASSERT_TRUE(each.value) << each.reason;
    EXPECT_DOUBLE_EQ(each.value->instructions, 100);
    EXPECT_DOUBLE_EQ(each.value->accesses, 20);
    EXPECT_DOUBLE_EQ(each.value->d1_misses, 4);
    EXPECT_DOUBLE_EQ(each.value->ll_misses, 2);
    EXPECT_DOUBLE_EQ(each.value->mispredictions.value(), 5);
}

TEST(Effort, ARunThatCountedLessIsNoMeasurement) {
    EXPECT_THAT(counts_per_query(counted(3), counted(1), 2, 30).reason, HasSubstr("no more instructions"));
    measure::CallgrindCounts without = counted(3);
    without.mispredictions.reset();
    const auto each = counts_per_query(counted(1), without, 2, 30);
    ASSERT_TRUE(each.value);
    EXPECT_FALSE(each.value->mispredictions);
}

TEST(Effort, PassesAreHeldAgainstTheCheckedOnes) {
    const bench::PassSum checked{30, 1.25};
    EXPECT_EQ(compare_passes("30 1.25\n", checked, false), "");
    EXPECT_THAT(compare_passes("30 1.2500000000000002\n", checked, false), HasSubstr("other answers"));
    EXPECT_EQ(compare_passes("30 1.2500000000000002\n", checked, true), "");
    EXPECT_THAT(compare_passes("30 1.26\n", checked, true), HasSubstr("other answers"));
    EXPECT_THAT(compare_passes("29 1.25\n", checked, false), HasSubstr("29"));
    EXPECT_THAT(compare_passes("", checked, false), HasSubstr("did not say"));
}

CellChoice choice(const char* scene, const char* algorithm) {
    CellChoice of;
    of.table = "aos_f64";
    of.scene = scene;
    of.algorithm = algorithm;
    of.shape = "sphere38";
    of.queries = 300;
    of.checked = 20;
    return of;
}

/// A cold query of bodies of up to 64 vertices reads all of them for its search in singles, and those of
/// separated bodies again for the proof.
TEST(Effort, VerticesAreThoseOfSearchAndProof) {
    const SingleCell cell(choice("cold", "gjk"));
    double overlapping = 0;
    for (const Distance& answer : cell.runner().answer()) overlapping += answer.status != Status::separated;
    EXPECT_GT(overlapping, 0);
    EXPECT_LT(overlapping, 300);
    const Effort effort = examine(choice("cold", "gjk"));
    const double least = 2 * 38 * (2 - overlapping / 300), read = *effort.vertices_read.value;
    std::printf("effort: %.1f vertices of at least %.1f, %.2f steps, %.1f lines\n", read, least,
                *effort.steps.value, *effort.lines_read.value);
    EXPECT_GE(read, least);
    EXPECT_LE(read, 1.2 * least) << "a few more for the starts and ends of the runs";
    EXPECT_EQ(effort.wrong, "");
}

std::optional<double> value_of(const std::vector<store::FigureRow>& figures, const store::FigureName& name) {
    for (const store::FigureRow& figure : figures)
        if (figure.probe == name.probe() && figure.name == name.name()) return figure.value;
    ADD_FAILURE() << name.name() << " is missing";
    return std::nullopt;
}

TEST(Effort, FiguresAreNumbersOrSayWhyNot) {
    Effort effort = examine(choice("tumble", "vclip"));
    for (const store::FigureRow& figure : effort_figures(effort, "zen5"))
        EXPECT_TRUE(figure.value || !figure.reason.empty()) << figure.name;
    EXPECT_FALSE(value_of(effort_figures(effort, "zen5"), "effort.instructions"));
    effort.counted = {measure::CallgrindCounts{1000, 100, 10, 1, 20}};
    const auto figures = effort_figures(effort, "zen5");
    const double steps = effort.steps.value.value();
    EXPECT_DOUBLE_EQ(value_of(figures, "effort.instructions_per_step").value(), 1000 / steps);
    EXPECT_DOUBLE_EQ(value_of(figures, "effort.mispredictions_per_step").value(), 20 / steps);
    EXPECT_DOUBLE_EQ(value_of(figures, "effort.instructions_over_floor").value(),
                     1000 / effort.floor.value->flops);
    EXPECT_EQ(value_of(figures, store::FigureName("effort.{machine}.d1_misses").of("zen5")), 10);
    EXPECT_GT(value_of(figures, "effort.lines_over_floor").value(), 1);
}

}  // namespace
}  // namespace edgewise::studies
