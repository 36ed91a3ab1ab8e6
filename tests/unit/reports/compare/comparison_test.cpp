// SPDX-License-Identifier: MIT
//
// Two synthetic stores with known differences: each is found and reported with its kind, and no other is.
#include "edgewise/reports/compare/comparison.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "../made_up_data.hpp"
#include "edgewise/reports/page/chapters/chapters.hpp"

namespace edgewise::reports {
namespace {

using measure::Outcome;
using testing::HasSubstr;

void set(ReportCell& cell, const store::FigureName& name, double value) {
    for (store::FigureRow& row : cell.figures)
        if (row.probe == name.probe() && row.name == name.name()) row.value = value;
    store::FigureRow row;
    row.probe = name.probe();
    row.name = name.name();
    row.unit = name.unit();
    row.value = value;
    cell.figures.push_back(row);
}

/// Sets 17 rounds with ratios within 0.4 % above `ratio`, and the figures of time that follow from them.
void set_time(ReportCell& cell, double ratio) {
    cell.rounds.clear();
    for (int number = 0; number < 17; ++number) {
        measure::Round round;
        round.number = number;
        round.baseline.separated_queries = round.timing.separated_queries = 100;
        round.baseline.separated_ns = 1000;
        round.timing.separated_ns = 1000 * ratio * (1 + 0.001 * (number % 5));
        cell.rounds.push_back(round);
    }
    std::erase_if(cell.figures, [](const store::FigureRow& row) { return row.probe == "time"; });
    set(cell, store::all_time.ns, 10 * ratio);
    set(cell, store::all_time.ratio, ratio);
}

ReportCell cell(const std::string& table) {
    ReportCell made = base_cell("tumble", "cube8", "vclip", "aos");
    made.table = made.hash = table;
    set(made, "error.mean_steps", 4);
    set(made, "lines.lines_per_query", 20);
    set(made, "bytes.total_bytes_per_edge", 100);
    set_time(made, table == "aos_f64" ? 1 : 0.8);
    return made;
}

ReportData data() {
    ReportData made;
    made.meta = {{"seed", "1"}};
    made.build.compiler = "GNU 12";
    made.build.machine_json = R"({"cpu": {"name": "a processor"}})";
    made.cells = {cell("aos_f64"), cell("lean_f64")};
    return made;
}

void replace(ReportCell& cell, const store::FigureName& name, double value) {
    std::erase_if(cell.figures, [&](const store::FigureRow& row) {
        return row.probe == name.probe() && row.name == name.name();
    });
    set(cell, name, value);
}

constexpr double slack = 0.05;

std::size_t worse(const StoreComparison& comparison) { return comparison.found.count(Outcome::worse); }

const measure::ComparedRow& row_of(const StoreComparison& comparison, const std::string& cell,
                                   const std::string& figure) {
    return *std::ranges::find_if(comparison.found.rows, [&](const measure::ComparedRow& row) {
        return row.is.cell == cell && row.is.figure == figure;
    });
}

TEST(Comparison, OfAStoreWithItselfFindsNothing) {
    const StoreComparison same = compare(data(), data(), slack);
    EXPECT_EQ(same.found.compared(), 8U) << "three exact figures and a time of two cells";
    EXPECT_EQ(same.found.count(Outcome::equal), 6U);
    EXPECT_EQ(same.found.count(Outcome::within), 2U);
    EXPECT_TRUE(same.found.passed());
    EXPECT_DOUBLE_EQ(row_of(same, "tumble cube8 vclip lean_f64", "time.all_ratio").change(), 1);
    for (const auto& condition : same.found.conditions) EXPECT_TRUE(condition.same()) << condition.what;
}

TEST(Comparison, FindsWhatBecameWorseAndWhatBetter) {
    ReportData after = data();
    replace(after.cells[1], "bytes.total_bytes_per_edge", 150);
    replace(after.cells[1], "lines.lines_per_query", 10);
    const StoreComparison comparison = compare(data(), after, slack);
    EXPECT_EQ(comparison.found.rows[0].is.figure, "bytes.total_bytes_per_edge") << "regressions first";
    EXPECT_EQ(comparison.found.rows[0].is.cell, "tumble cube8 vclip lean_f64");
    EXPECT_EQ(worse(comparison), 1U);
    EXPECT_EQ(comparison.found.count(Outcome::better), 1U);
    EXPECT_EQ(comparison.found.exit_code(), 1);
}

/// A time is slower when its whole interval is, beyond the slack and the noise of the baseline.
TEST(Comparison, JudgesTimesByTheirIntervals) {
    ReportData after = data();
    set_time(after.cells[1], 0.96);  // 1.2 times 0.8
    const StoreComparison slower = compare(data(), after, slack);
    EXPECT_EQ(worse(slower), 1U);
    EXPECT_EQ(worse(compare(data(), after, 0.25)), 0U) << "within the slack";
    EXPECT_NEAR(slower.found.rows[0].change(), 1.2, 1e-12);
    EXPECT_LT(slower.found.rows[0].least_change(), 1.2);
    EXPECT_GT(slower.found.rows[0].most_change(), 1.2);
    set_time(after.cells[0], 1.3);  // the baseline differs from itself by as much
    EXPECT_EQ(worse(compare(data(), after, slack)), 0U);
}

/// 1.5 times the steps of the same lines each: all of the change is steps.
TEST(Comparison, SaysWhatAChangeIsMadeOf) {
    ReportData before = data(), after = data();
    set_time(after.cells[1], 1.2);
    EXPECT_EQ(compare(before, after, slack).found.rows[0].note,
              "= 1.000 (steps) x 1.000 (lines per step) x 1.500 (time per line); no exact figure of the cell "
              "changed: code or machine");
    replace(after.cells[1], "error.mean_steps", 6);
    replace(after.cells[1], "lines.lines_per_query", 30);
    EXPECT_EQ(row_of(compare(before, after, slack), "tumble cube8 vclip lean_f64", "time.all_ratio").note,
              "= 1.500 (steps) x 1.000 (lines per step) x 1.000 (time per line)");
    for (ReportData* one : {&before, &after})
        std::erase_if(one->cells[1].figures,
                      [](const store::FigureRow& row) { return row.probe == "error"; });
    EXPECT_THAT(row_of(compare(before, after, slack), "tumble cube8 vclip lean_f64", "time.all_ratio").note,
                HasSubstr("not known"));
}

/// The chapter has what the comparison has, what became worse first, each once.
TEST(Comparison, AsAChapter) {
    ReportData after = data();
    replace(after.cells[1], "bytes.total_bytes_per_edge", 150);
    replace(after.cells[1], "lines.lines_per_query", 10);
    set_time(after.cells[1], 1.2);
    const Chapter chapter = compare_chapter(compare(data(), after, slack), slack, "old.db");
    ASSERT_EQ(chapter.blocks.size(), 3U) << "worse, better, conditions";
    const TextGrid& worse = chapter.blocks[0].grids[0];
    ASSERT_EQ(worse.rows.size(), 2U);
    EXPECT_EQ(worse.caption, "Worse");
    expect_texts(worse.rows[0], {{0, "bytes.total_bytes_per_edge"}, {3, "1.500"}});
    EXPECT_EQ(worse.rows[1][0].text, "time.all_ratio");
    EXPECT_EQ(chapter.blocks[1].grids[0].rows.size(), 1U);
    EXPECT_EQ(chapter.blocks[2].grids[0].rows.size(), 7U);
    EXPECT_EQ(chapter.sentence,
              "2 of 8 figures in both stores became worse, 1 better; 0 cells or figures are missing, 0 new.");
    EXPECT_EQ(compare_chapter(compare(data(), data(), slack), slack, "old.db").blocks.size(), 1U);
}

TEST(Comparison, NamesCausesThatAreNotExcluded) {
    ReportData after = data();
    after.build.compiler = "Clang 14";
    after.cells.pop_back();
    const StoreComparison comparison = compare(data(), after, slack);
    EXPECT_EQ(comparison.found.count(Outcome::missing), 1U) << "a cell is one row";
    EXPECT_TRUE(comparison.found.passed());
    const std::string text = noise_text(comparison) + to_text(comparison.found, "old.db");
    EXPECT_THAT(text, HasSubstr("differ from it by 1.00 to 1.00\n"));
    EXPECT_THAT(text, HasSubstr("missing: tumble cube8 vclip lean_f64\n"));
    EXPECT_THAT(text, HasSubstr("possible cause: compiler: was GNU 12, is Clang 14"));
    EXPECT_THAT(text, HasSubstr("excluded as causes, being the same: seed, bodies, processor"));
    after.cells[0].hash = "another body";
    EXPECT_THAT(to_text(compare(data(), after, slack).found, "old.db"), HasSubstr("possible cause: bodies"));
}

}  // namespace
}  // namespace edgewise::reports
