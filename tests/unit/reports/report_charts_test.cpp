// SPDX-License-Identifier: MIT
//
// The report's parts that need no store: intervals, numbers as text, and what the charts promise about their
// marks.
#include <gmock/gmock.h>

#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/reports/text/report_text.hpp"
#include "report_store.hpp"

namespace edgewise::reports {
namespace {

using testing::HasSubstr;

TEST(MedianInterval, HoldsNinetyFivePercentByCounting) {
    // Oracle: count all 2^n ways the n values can fall below or above the median.
    for (std::size_t n = 6; n <= 16; ++n) {
        std::vector<double> values;
        for (std::size_t i = 0; i < n; ++i) values.push_back(static_cast<double>(n - 1 - i));
        const auto interval = median_interval(values);
        ASSERT_TRUE(interval);
        ASSERT_FALSE(interval->whole_range);
        const auto k = static_cast<std::size_t>(interval->low) + 1;  // the values are n-1 .. 0
        EXPECT_EQ(interval->high, static_cast<double>(n - k));
        const auto outside = [&](std::size_t order) {
            std::size_t ways = 0;
            for (std::size_t bits = 0; bits < (std::size_t{1} << n); ++bits)
                if (static_cast<std::size_t>(__builtin_popcountll(bits)) < order) ++ways;
            return 2.0 * static_cast<double>(ways) / std::ldexp(1.0, static_cast<int>(n));
        };
        EXPECT_LE(outside(k), 0.05) << n;
        EXPECT_GT(outside(k + 1), 0.05) << n;
    }
    EXPECT_TRUE(median_interval({1, 2, 3, 4, 5})->whole_range);
    EXPECT_FALSE(median_interval({1}));
}

TEST(Charts, LayoutsKeepTheirColourWhateverElseIsThere) {
    ReportData data;
    for (const char* layout : {"soa", "lean", "aos"}) {
        ReportCell cell;
        cell.layout = layout;
        data.cells.push_back(cell);
    }
    const ChartJson slots = order_slots(data, ChartJson::array());
    EXPECT_EQ(slots["layouts"], (ChartJson{"aos", "soa", "lean"}));
    data.cells.erase(data.cells.begin());  // soa is gone
    EXPECT_EQ(order_slots(data, ChartJson::array())["layout_colours"][1], slots["layout_colours"][2]);
}

/// A panel without any row would let the next one move into its place, under a wrong name.
TEST_F(Report, TimesHaveARowForEveryPanel) {
    // Its scene tumble has no overlapping pair.
    const ChartJson values = time_chart(read_report(make_store())).spec["data"]["values"];
    std::set<std::string> scenes, panels;
    for (const ChartJson& row : values) {
        scenes.insert(row["scene"].get<std::string>());
        panels.insert(row["scene"].get<std::string>() + "/" + row["pairs"].get<std::string>());
    }
    EXPECT_EQ(scenes.size(), 2U);
    EXPECT_EQ(panels.size(), 4U);
}

TEST(Charts, MarksAreCappedAndSaidSo) {
    ChartJson values = ChartJson::array();
    for (int i = 0; i < 1000; ++i) values.push_back({{"i", i}});
    std::vector<std::string> notes;
    thin(values, 300, notes);
    EXPECT_LE(values.size(), 300u);
    EXPECT_GE(values.size(), 200u);
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_THAT(notes[0], HasSubstr("of 1000 rows"));
}

/// A column of zeros becomes a sentence in the caption; a column with a missing value stays.
TEST(TextGrid, ColumnsOfZerosBecomeASentence) {
    TextGrid grid{"Rows", columns_of("name|#wrong|#cases|#none"), {}};
    grid.rows = {{{"a"}, {"0"}, {"12"}, missing_cell("why")}, {{"b"}, {"0 (1 of 2)"}, {"0"}, {"0"}}};
    drop_zero_columns(grid);
    ASSERT_EQ(grid.columns.size(), 3u);
    EXPECT_EQ(grid.columns[1].title, "cases");
    EXPECT_EQ(grid.rows[0].size(), 3u);
    EXPECT_EQ(grid.caption, "Rows. 0 in every row: wrong");
}

/// Terminal and pages show the same cells; a reason is written once, below.
TEST(TextGrid, ShowsMembersOfJson) {
    const auto rows = nlohmann::json::parse(R"([
        {"name": "a", "bytes": 2048, "time": {"ns": 1.5}, "right": true, "tags": ["x", "y"]},
        {"name": "b", "bytes": 10, "time": {"ns": null, "reason": "no clock"}, "right": false, "reason": "z"},
        {"name": "c", "bytes": null, "right": null, "reason": "no clock", "remedy": "buy one"}])");
    const TextGrid grid = member_grid(rows, "name|#KiB = bytes 1024 1|#ns = time/ns|right|tags");
    EXPECT_EQ(grid_text(grid),
              "name    KiB     ns  right  tags\n"
              "a       2.0   1.50  yes    x, y\n"
              "b       0.0  - [1]  no     - [2]\n"
              "c     - [3]      -  -      -\n"
              "[1] no clock\n[2] z\n[3] no clock; buy one\n");
    EXPECT_THAT(grid_markdown(grid), HasSubstr("| b | 0.0 | not measured (1) | no | not measured (2) |\n"))
        << grid_markdown(grid);
    EXPECT_THAT(grid_html(grid), HasSubstr("<td class=\"missing number\">not measured<sup>1</sup></td>"))
        << grid_html(grid);
}

TEST(TextGrid, FoldsItsLastColumn) {
    TextGrid grid{"", columns_of("name|meaning")};
    grid.add("é", "one two three four five six seven");
    EXPECT_EQ(grid_text(grid, 20),
              "name  meaning\n"
              "é     one two three four five\n"
              "      six seven\n")
        << "24 columns at least";
}

TEST(Text, NumbersKeepTheirMeaning) {
    EXPECT_EQ(number_text(0, "ns"), "0");
    EXPECT_EQ(number_text(168, "B/edge"), "168");
    EXPECT_EQ(number_text(8.0417, "B/edge"), "8.04");
    EXPECT_EQ(number_text(1e-320, "ns"), "1.0e-320");
    EXPECT_EQ(number_text(3.14e-16, "scale"), "3.1e-16");
    EXPECT_EQ(number_text(87.345, "ns"), "87.34");
    EXPECT_EQ(number_text(12345.6, "ns"), "12346");
    EXPECT_EQ(number_text(30000, "queries"), "30000");
}

ChartJson filled(const char* spec, const char* slots = "{}") {
    ChartJson file =
        ChartJson::parse(R"({"parts": {"axis": {"field": "ns", "title": "$title"}, "title": "time"}})");
    file["spec"] = ChartJson::parse(spec);
    return fill_spec(file, ChartJson::parse(slots));
}

TEST(SpecFile, NamesStandForPartsSlotsAndWhatIsAroundThem) {
    EXPECT_EQ(filled(R"({"y": "$axis"})"), ChartJson::parse(R"({"y": {"field": "ns", "title": "time"}})"));
    EXPECT_EQ(filled(R"(["$title"])", R"({"title": "slot"})"), ChartJson::parse(R"(["slot"])"));
    EXPECT_EQ(filled(R"({"$let": {"title": "inner"}, "$with": "$axis", "field": "low"})"),
              ChartJson::parse(R"({"field": "low", "title": "inner"})"));
    EXPECT_EQ(filled(R"([0, "$*rows", 3])", R"({"rows": [1, 2]})"), ChartJson::parse("[0, 1, 2, 3]"));
    EXPECT_EQ(filled(R"([{"$each": "$panels", "at": "$x"}])", R"({"panels": [{"x": 1}, {"x": 2}]})"),
              ChartJson::parse(R"([{"at": 1}, {"at": 2}])"));
    EXPECT_EQ(filled(R"({"a": null, "b": "$absent"})"), ChartJson::parse(R"({"a": null})"));
}

TEST(SpecFile, DataIsNeverReadAsANameAndAnUnknownNameIsAnError) {
    const char* rows = R"({"values": ["$title", {"$with": "$axis"}, "$nothing"]})";
    EXPECT_EQ(filled(R"("$values")", rows), ChartJson::parse(rows)["values"]);
    EXPECT_THROW((void)filled(R"("$nothing")"), std::out_of_range);
}

TEST(ReportTexts, AreAllThereAndWhole) {
    std::size_t charts = 0;
    for (const EmbeddedText& text : embedded_texts()) {
        EXPECT_EQ(report_text(text.name), text.text) << text.name;
        EXPECT_TRUE(!text.name.ends_with(".json") || ChartJson::accept(text.text)) << text.name;
        EXPECT_FALSE(text.name.ends_with(".md") && prose(text.name).empty()) << text.name;
        charts += text.name.ends_with(".vl.json");
    }
    EXPECT_GE(charts, 15U);
}

}  // namespace

}  // namespace edgewise::reports
