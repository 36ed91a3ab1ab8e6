// SPDX-License-Identifier: MIT
//
// Two stores made here, with differences that are known: each is found, told as what it is, and nothing else.
#include "edgewise/reports/compare/comparison.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "edgewise/reports/compare/comparison_grids.hpp"

namespace edgewise::reports {
namespace {

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

/// Rounds whose ratios lie closely around one.
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
    ReportCell made;
    made.scene = made.scene_label = "tumble";
    made.shape = "cube8";
    made.algorithm = "vclip";
    made.table = table;
    made.status = store::CellStatus::verified;
    made.hash = table;
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

TEST(Comparison, OfAStoreWithItselfFindsNothing) {
    const Comparison same = compare(data(), data());
    EXPECT_EQ(same.paired, 2U);
    EXPECT_GT(same.figures, 4U);
    EXPECT_TRUE(same.exact.empty());
    EXPECT_EQ(same.regressions(0.05), 0U);
    for (const TimeChange& change : same.times) EXPECT_DOUBLE_EQ(change.mid, 1);
    EXPECT_THAT(comparison_text(same, 0.05, true), HasSubstr("no regression"));
    for (const Condition& condition : same.conditions) EXPECT_TRUE(condition.same()) << condition.what;
}

TEST(Comparison, FindsWhatBecameWorseAndWhatBetter) {
    ReportData after = data();
    replace(after.cells[1], "bytes.total_bytes_per_edge", 150);
    replace(after.cells[1], "lines.lines_per_query", 10);
    const Comparison found = compare(data(), after);
    ASSERT_EQ(found.exact.size(), 2U);
    EXPECT_EQ(found.exact[0].figure, "bytes.total_bytes_per_edge") << "regressions first";
    EXPECT_TRUE(found.exact[0].is_worse());
    EXPECT_FALSE(found.exact[1].is_worse());
    EXPECT_EQ(found.regressions(0.05), 1U);
}

/// A time is slower when its whole interval is, beyond the slack and the noise of the baseline.
TEST(Comparison, JudgesTimesByTheirIntervals) {
    ReportData after = data();
    set_time(after.cells[1], 0.96);  // 1.2 times 0.8
    const Comparison slower = compare(data(), after);
    EXPECT_EQ(slower.regressions(0.05), 1U);
    EXPECT_EQ(slower.regressions(0.25), 0U) << "within the slack";
    EXPECT_NEAR(slower.times.front().mid, 1.2, 1e-12);
    EXPECT_LT(slower.times.front().low, 1.2);
    EXPECT_GT(slower.times.front().high, 1.2);
    set_time(after.cells[0], 1.3);  // the baseline differs from itself by as much
    EXPECT_EQ(compare(data(), after).is_slower(slower.times.front(), 0.05), false);
}

/// 1.5 times the steps of the same lines each: all of the change is steps.
TEST(Comparison, SaysWhatAChangeIsMadeOf) {
    ReportData after = data();
    set_time(after.cells[1], 1.2);
    replace(after.cells[1], "error.mean_steps", 6);
    replace(after.cells[1], "lines.lines_per_query", 30);
    const TimeChange change = compare(data(), after).times.front();
    EXPECT_NEAR(change.by_steps, 1.5, 1e-12);
    EXPECT_NEAR(change.by_lines, 1, 1e-12);
    EXPECT_NEAR(change.by_cost, 1, 1e-12);
    EXPECT_NEAR(change.by_steps * change.by_lines * change.by_cost, change.mid, 1e-12);
}

/// The tables have what the comparison has, what became worse first, each once.
TEST(Comparison, AsTables) {
    ReportData after = data();
    replace(after.cells[1], "bytes.total_bytes_per_edge", 150);
    replace(after.cells[1], "lines.lines_per_query", 10);
    set_time(after.cells[1], 1.2);
    const Comparison found = compare(data(), after);
    const std::vector<TextGrid> grids = change_grids(found, 0.05);
    ASSERT_EQ(grids.size(), 3U) << "nothing is faster";
    EXPECT_EQ(grids[0].caption, "Worse, exactly");
    ASSERT_EQ(grids[0].rows.size(), 1U);
    EXPECT_EQ(grids[0].rows[0][0].text, "bytes.total_bytes_per_edge");
    EXPECT_EQ(grids[0].rows[0][3].text, "1.500");
    EXPECT_EQ(grids[1].caption, "Slower");
    EXPECT_EQ(grids[1].rows[0][0].text, "1.500");
    EXPECT_EQ(grids[2].caption, "Better, exactly");
    EXPECT_EQ(comparison_sentence(found, 0.05),
              "1 exact figure and 1 time became worse, 1 and 0 better, of 2 cells in both stores; 0 only "
              "before, 0 only after.");
    EXPECT_TRUE(change_grids(compare(data(), data()), 0.05).empty());
    EXPECT_EQ(conditions_grid(found).rows.size(), found.conditions.size());
}

/// What is not known of a change is said so, and never 1 or 0.
TEST(Comparison, TablesSayWhatIsNotKnown) {
    ReportData before = data(), after = data();
    set_time(after.cells[1], 1.2);
    for (ReportData* one : {&before, &after})
        std::erase_if(one->cells[1].figures,
                      [](const store::FigureRow& row) { return row.probe == "error"; });
    const std::vector<TextGrid> grids = change_grids(compare(before, after), 0.05);
    ASSERT_EQ(grids.size(), 1U);
    EXPECT_EQ(grids[0].rows[0][2].text, "not measured");
    EXPECT_FALSE(grids[0].rows[0][2].why.empty());
}

TEST(Comparison, NamesCausesThatAreNotExcluded) {
    ReportData after = data();
    after.build.compiler = "Clang 14";
    after.cells.pop_back();
    const Comparison found = compare(data(), after);
    EXPECT_EQ(found.only_before, 1U);
    const std::string text = comparison_text(found, 0.05, true);
    EXPECT_THAT(text, HasSubstr("compiler: GNU 12 -> Clang 14"));
    EXPECT_THAT(text, HasSubstr("excluded as causes, since they are the same: seed, bodies, processor"));
    EXPECT_EQ(comparison_json(found, 0.05)["paired"], 1);
}

}  // namespace
}  // namespace edgewise::reports
