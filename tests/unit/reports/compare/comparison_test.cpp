// SPDX-License-Identifier: MIT
//
// Two synthetic stores with known differences: each is found and reported with its kind, and no other is.
#include "edgewise/reports/compare/comparison.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>

#include "../made_up_data.hpp"
#include "edgewise/reports/page/chapters/chapters.hpp"

namespace edgewise::reports {
namespace {

using measure::FigureRecord;
using measure::Outcome;
using measure::RecordComparison;
using measure::RecordRow;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

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
    replace(after.cells[1], "lines.lines_per_query", 0);
    const Chapter none = compare_chapter(compare(data(), after, slack), slack, "old.db");
    expect_texts(none.blocks[1].grids[0].rows[0], {{0, "lines.lines_per_query"}, {3, "0.000"}});
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

// A comparison with one row of each kind in the formats that CI reads: what each format must hold, and that
// all of them agree with the comparison on what failed.

RecordRow time_row(const char* cell, double low, double value, double high) {
    return {cell, "time", value, low, high, true};
}

const FigureRecord old_figures = {"store",
                                  {},
                                  {{"compiler", "one"}},
                                  0.05,
                                  {{"a & b", "bytes", 100},
                                   {"a & b", "lines_per_query", 20},
                                   time_row("a & b", 0.99, 1, 1.01),
                                   time_row("b", 1.9, 2, 2.1),
                                   time_row("c", 0.9, 1, 1.1),
                                   {"gone", "bytes", 1}}};

RecordComparison found() {
    FigureRecord after = old_figures;
    after.rows[0] = {"a & b", "bytes", 150};
    after.rows[1] = {"a & b", "lines_per_query", 10};
    after.rows[2] = time_row("a & b", 1.19, 1.2, 1.21);
    after.rows[3] = time_row("b", 0.9, 1, 1.1);
    after.rows[5].cell = "new";
    return measure::compare(old_figures, after);
}

TEST(CiFormats, MarkdownHasAtMostFiveRows) {
    const std::string text = ci_text(found(), ci_markdown, "old.db");
    EXPECT_THAT(text, testing::StartsWith("| what changed | mean | range | count |\n| --- | ---: |"));
    for (const char* row : {"| regressions of exact figures | +50.0 % | +50.0 % to +50.0 % | 1 |\n",
                            "| improvements of exact figures | -50.0 % | -50.0 % to -50.0 % | 1 |\n",
                            "| regressions of times | +20.0 % | +20.0 % to +20.0 % | 1 |\n",
                            "| improvements of times | -50.0 % | -50.0 % to -50.0 % | 1 |\n",
                            "| missing, new, or another word |  |  | 2 |\n"})
        EXPECT_THAT(text, HasSubstr(row));
    EXPECT_THAT(
        text,
        HasSubstr("\nold.db: failed; 5 rows compared: 2 worse, 1 missing, 1 new, 2 better, 1 within\n"));
    EXPECT_THAT(text, HasSubstr("<details>"));
    EXPECT_THAT(text, HasSubstr("worse: a & b: bytes: was 100, is 150\n"));
    const std::string same = ci_text(measure::compare(old_figures, old_figures), ci_markdown, "old.db");
    EXPECT_THAT(same, testing::StartsWith("old.db: passed; "));
    EXPECT_THAT(same, Not(HasSubstr("|")));
}

/// A mean of ratios: twice and half as much is no change.
TEST(CiFormats, MeanAndRangeAreOfRatios) {
    FigureRecord after = old_figures;
    after.rows[0].value = 200;
    after.rows[1].value = 160;
    EXPECT_THAT(ci_text(measure::compare(old_figures, after), ci_markdown, "old.db"),
                HasSubstr("| regressions of exact figures | +300.0 % | +100.0 % to +700.0 % | 2 |\n"));
    FigureRecord zero = old_figures;
    zero.rows[0].value = 0;
    EXPECT_THAT(ci_text(measure::compare(zero, old_figures), ci_markdown, "old.db"),
                HasSubstr("| regressions of exact figures |  |  | 1 |\n"))
        << "a change from 0 has no ratio";
}

TEST(CiFormats, GithubHasTheNewFigures) {
    const json figures = json::parse(ci_text(found(), ci_github, "old.db"));
    ASSERT_EQ(figures.size(), 5U);
    EXPECT_EQ(figures[0]["name"], "a & b: bytes");
    EXPECT_EQ(figures[0]["unit"], "bytes");
    EXPECT_EQ(figures[0]["value"], 150);
    EXPECT_EQ(figures[0]["extra"], "worse: a & b: bytes: was 100, is 150\n");
    EXPECT_FALSE(figures[0].contains("range"));
    EXPECT_EQ(figures[1]["name"], "a & b: time");
    EXPECT_EQ(figures[1]["range"], "1.19 to 1.21");
    for (const json& figure : figures)
        EXPECT_TRUE(figure["value"].is_number() && figure["unit"].is_string()) << figure;
}

TEST(CiFormats, BencherHasMeasuresByCell) {
    const json cells = json::parse(ci_text(found(), ci_bencher, "old.db"));
    EXPECT_EQ(cells["a & b"]["bytes"], (json{{"value", 150}}));
    EXPECT_EQ(cells["a & b"]["time"], (json{{"value", 1.2}, {"lower_value", 1.19}, {"upper_value", 1.21}}));
    EXPECT_EQ(cells.size(), 3U);
    FigureRecord lock = {"lock", {{"points", "8"}}, {}, {}, {{"", "bytes", 24}}};
    EXPECT_EQ(json::parse(ci_text(measure::compare(lock, lock), ci_bencher, "locks/lean.lock.json")),
              (json{{"lean", {{"bytes", {{"value", 24}}}}}}));
}

TEST(CiFormats, JunitFailsWhereTheComparisonDoes) {
    RecordComparison comparison = found();
    comparison.faults = {"wrong answers"};
    const std::string text = ci_text(comparison, ci_junit, "old.db");
    EXPECT_THAT(text, HasSubstr("<testsuite name=\"old.db\" tests=\"8\" failures=\"3\">"));
    EXPECT_THAT(text, HasSubstr("<testcase classname=\"a &amp; b\" name=\"bytes\"><failure>worse: a &amp; b: "
                                "bytes: was 100, is 150\n</failure></testcase>\n"));
    EXPECT_THAT(text, HasSubstr("<testcase classname=\"c\" name=\"time\"/>\n"));
    EXPECT_THAT(text, HasSubstr("name=\"wrong answers\"><failure>"));
    EXPECT_THAT(ci_text(measure::compare({}, {}), ci_junit, "old.db"), HasSubstr("nothing in common"));
}

}  // namespace
}  // namespace edgewise::reports
