// SPDX-License-Identifier: MIT
//
// A comparison with one row of each kind in the formats that CI reads: what each format must hold, and that
// all of them agree with the comparison on what failed.
#include "edgewise/reports/compare/comparison.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

namespace edgewise::reports {
namespace {

using measure::FigureRecord;
using measure::RecordComparison;
using measure::RecordRow;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

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
