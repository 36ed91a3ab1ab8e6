// SPDX-License-Identifier: MIT
//
// The report of small stores written with raw SQL from the schema: every figure of the store is in the
// report, a figure that was not measured is never a number, failed cells come first, and the page fetches
// nothing when it is viewed.
#include "edgewise/reports/page/report.hpp"

#include <gmock/gmock.h>

#include <regex>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/compare/comparison.hpp"
#include "edgewise/reports/page/html.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "made_up_data.hpp"
#include "report_store.hpp"

namespace edgewise::reports {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST_F(Report, SummaryCountsTheLatestBuildOnly) {
    const ReportSummary summary = write_report(make_store(), (directory_ / "out").string(), "");
    EXPECT_EQ(summary.cells, 5u);
    EXPECT_EQ(summary.verified, 3u);
    EXPECT_EQ(summary.failed, 1u);
    EXPECT_EQ(summary.unavailable, 1u);
    EXPECT_THAT(text("out/results/static.csv"), Not(HasSubstr(",old,")));
    EXPECT_THAT(text("out/index.html"), HasSubstr("other builds in the store, not shown</td><td>b1<"));
    EXPECT_THAT(summary.answer, HasSubstr("3 of 5 cells verified, 1 failed, 1 unavailable."));
}

/// Separated pairs alone have been timed: all pairs together are these.
TEST_F(Report, RoundsHaveRatiosByKindAndOfAllPairs) {
    const ReportData data = read_report(make_store(
        store_sql() + "insert into round values('b2','h-null',0,10,1000,10,5000,10,1000,30,3000,0,0,0,0);"));
    for (const ReportCell& cell : data.cells) {
        if (cell.hash == "h-full") {
            ASSERT_EQ(cell.rounds.size(), 7u);
            const auto all = cell.rounds[5].ratio(&measure::Timing::all);
            EXPECT_EQ(all, cell.rounds[5].ratio(&measure::Timing::separated));
            EXPECT_DOUBLE_EQ(all.value_or(0), 1.005);
            EXPECT_FALSE(cell.rounds[5].ratio(&measure::Timing::overlapping));
        }
        if (cell.hash == "h-null") {
            EXPECT_DOUBLE_EQ(cell.rounds.at(0).ratio(&measure::Timing::all).value_or(0), 3);
        }
    }
}

TEST_F(Report, WhatWasNotMeasuredIsNeverANumber) {
    (void)write_report(make_store(), (directory_ / "out").string(), "");
    const TextGrid grid = time_grid(read_report((directory_ / "store.db").string()),
                                    "tumble (rotation_step 0.01)", PairKind::Overlapping);
    ASSERT_EQ(grid.rows.size(), 1u);
    for (std::size_t column = 4; column < 8; ++column) {
        EXPECT_EQ(grid.rows[0][column].text, "not measured");
        EXPECT_EQ(grid.rows[0][column].why, "no overlapping pair in this cell");
    }
    for (const std::string page : {"out/index.html", "out/report.md"})
        EXPECT_THAT(text(page), HasSubstr("not measured")) << page;
    EXPECT_THAT(text("out/index.html"), HasSubstr("no overlapping pair in this cell"));
}

TEST_F(Report, ChartsLeaveOutWhatWasNotMeasuredAndSaySo) {
    const ReportData data = read_report(make_store());
    const Chart chart = time_chart(data);
    std::size_t rows = 0;
    for (const auto& row : chart.spec["data"]["values"]) {
        if (row["ns"].is_null()) continue;  // keeps a panel's place, draws nothing
        EXPECT_GT(row["ns"], 0.0);
        ++rows;
    }
    EXPECT_EQ(rows, 3u);  // h-full twice, h-null once
    ASSERT_FALSE(chart.notes.empty());
    bool said = false;
    for (const std::string& note : chart.notes)
        said = said || note.find("no overlapping pair in this cell") != std::string::npos;
    EXPECT_TRUE(said);
}

TEST_F(Report, FailedCellsStandBeforeTheChaptersWithTheirReasons) {
    (void)write_report(make_store(), (directory_ / "out").string(), "");
    const std::string page = text("out/index.html");
    const auto failed = page.find("3 wrong verdicts, &quot;first&quot; at 17"),
               gone = page.find("mesh unreadable");
    EXPECT_LT(failed, gone);
    EXPECT_LT(gone, page.find("id=\"fronts\""));
    EXPECT_THAT(page, HasSubstr("<p class=\"verdict bad\">3 of 5 cells verified, 1 failed, 1 unavailable."));
    const std::string markdown = text("out/report.md");
    EXPECT_LT(markdown.find("3 wrong verdicts"), markdown.find("## Method"));
}

/// Held against another store, the report begins with what changed since; in a page and in short.
TEST_F(Report, WhatChangedIsTheFirstChapter) {
    const ReportData before = read_report(make_store());
    ReportData after = before;
    for (ReportCell& cell : after.cells)
        for (store::FigureRow& figure : cell.figures)
            if (figure.name == "topology") figure.value = 41;
    const StoreComparison changed = compare(before, after, 0.05);
    ASSERT_EQ(changed.found.count(measure::Outcome::worse), 2U);
    (void)write_report(after, (directory_ / "out").string(), "", ReportBeside{&changed, 0.05, "old<1>.db"});
    const std::string page = text("out/index.html"), markdown = text("out/report.md");
    const auto chapter = page.find("<h2 id=\"changes\">What changed since old&lt;1&gt;.db?</h2>");
    ASSERT_NE(chapter, std::string::npos);
    EXPECT_LT(chapter, page.find("<h2 id=\"fronts\">"));
    EXPECT_THAT(page, HasSubstr("figures in both stores became worse, 0 better"));
    EXPECT_THAT(page,
                HasSubstr("<td>bytes.topology</td><td class=\"number\">40</td><td class=\"number\">41</td>"));
    EXPECT_THAT(markdown, HasSubstr("| bytes.topology | 40 | 41 |"));
    (void)write_report(before, (directory_ / "out").string(), "");
    EXPECT_THAT(text("out/index.html"), Not(HasSubstr("id=\"changes\"")));
}

TEST_F(Report, FactsNameMachineBuildSeedPlanAndCounters) {
    (void)write_report(make_store(), (directory_ / "out").string(), "");
    for (const std::string fact : {"Test CPU", "r2", "-O3", "quick", "18446744073709551615",
                                   "<td>cycles</td>", "<li>no PMU; bare metal</li>"})
        EXPECT_THAT(text("out/index.html"), HasSubstr(fact)) << fact;
    for (const std::string fact : {"Test CPU", "r2", "-O3"})
        EXPECT_THAT(text("out/report.md"), HasSubstr(fact)) << fact;
    EXPECT_THAT(text("out/index.html"), HasSubstr("g++ &lt;12&gt;"));
}

/// Bundles that only look like bundles: what is tested is how they are packed.
void make_bundles(const fs::path& directory) {
    fs::create_directories(directory);
    for (const std::string name : {"vega", "vega-lite", "vega-embed"}) {
        input::write_output(directory / (name + ".min.js"),
                            "const t='</script><!--';\n//# sourceMappingURL=" + name + ".map\n");
        input::write_output(directory / (name + ".LICENSE"), "Copyright of " + name + "\n");
    }
}

TEST_F(Report, PageFetchesNothingAndEscapesNames) {
    make_bundles(directory_ / "bundles");
    const auto summary =
        write_report(make_store(), (directory_ / "out").string(), (directory_ / "bundles").string());
    EXPECT_THAT(summary.note, Not(HasSubstr("tables only")));
    const std::string page = text("out/index.html");
    const std::regex fetched(R"re(<(link|iframe|object|embed|img|base)\b|@import|url\(\s*["']?(?!["'#]))re"
                             R"re(|\b(src|href|action)=["']?(?!["'#]))re",
                             std::regex::icase);
    const std::string elements = page.substr(0, page.find("<script"));
    std::smatch found;
    EXPECT_FALSE(std::regex_search(elements, found, fetched)) << found.str();
    EXPECT_THAT(page, HasSubstr("content=\"default-src 'none'; script-src 'sha256-"));
    EXPECT_THAT(page, Not(HasSubstr("script-src 'unsafe-inline'")));
    EXPECT_THAT(page, Not(HasSubstr("cow</script>")));
    EXPECT_THAT(page, HasSubstr("cow&lt;/script&gt;&lt;b&gt;&amp;&quot;"));
    EXPECT_THAT(page, Not(HasSubstr("sourceMappingURL")));
}

/// A store from an unknown source can hold any text under the key of a drawing.
TEST_F(Report, DrawingsThatCouldRunAreNotShown) {
    const std::string plain = R"(<svg viewBox="0 0 1 1"><title>a</title><rect fill="#fff" x="1"/></svg>)";
    (void)write_report(make_store(store_sql() + "insert into meta values('drawing aos_f64','" + plain +
                                  "'),('drawing evil_f64','<svg><script>alert(1)</script></svg>');"),
                       (directory_ / "out").string(), "");
    EXPECT_THAT(text("out/index.html"), Not(HasSubstr("alert(1)")));
    EXPECT_TRUE(safe_svg(plain));
    for (const char* evil :
         {"<svg onload=\"alert(1)\"></svg>", "<svg><script>1</script></svg>", "<svg><foreignObject/></svg>",
          "<svg><rect fill=\"url(http://a)\"/></svg>", "<svg><rect fill=\"Url(http://a)\"/></svg>",
          "<svg><a href=\"javascript:1\"/></svg>", "<b>", "<svg></svg><script>1</script>",
          "<svg><rect fill=\"&#106;\"/></svg>", "<svg><rect", "<svg", "<svg><!--</svg>",
          "<svg><style>*{}</style></svg>", "<svg></g></svg>x", ""})
        EXPECT_FALSE(safe_svg(evil)) << evil;
}

TEST_F(Report, ScriptElementsOpenAndCloseInPairs) {
    make_bundles(directory_ / "bundles");
    (void)write_report(make_store(), (directory_ / "out").string(), (directory_ / "bundles").string());
    const std::string page = text("out/index.html");
    const auto count = [&](const std::string& word) {
        std::size_t n = 0;
        for (auto at = page.find(word); at != std::string::npos; at = page.find(word, at + 1)) ++n;
        return n;
    };
    EXPECT_EQ(count("<script"), 8u + 3u + 6u);  // what is packed, bundles, the page's own
    EXPECT_EQ(count("</script>"), count("<script"));
    EXPECT_EQ(count("<!--"), 0u);
}

TEST_F(Report, WithoutBundlesThePageSaysSoAndShowsTables) {
    const auto summary =
        write_report(make_store(), (directory_ / "out").string(), (directory_ / "none").string());
    EXPECT_THAT(summary.note, HasSubstr("The chart bundles are missing"));
    const std::string page = text("out/index.html");
    EXPECT_THAT(page, HasSubstr("The chart bundles were not available"));
    EXPECT_THAT(page, Not(HasSubstr("packed-bundle-vega\">")));
    EXPECT_THAT(page, HasSubstr("data-chart=\"bytes\""));
    EXPECT_THAT(page, HasSubstr("id=\"chart-bytes\""));
}

TEST_F(Report, TheSameStoreGivesTheSameBytes) {
    const std::string store = make_store();
    for (const char* out : {"one", "two"}) (void)write_report(store, (directory_ / out).string(), "");
    for (const std::string name : {"index.html", "report.md", "results/static.csv", "figures/time.vl.json"}) {
        EXPECT_EQ(text("one/" + name), text("two/" + name)) << name;
        EXPECT_GT(text("one/" + name).size(), 200u) << name;
    }
}

TEST_F(Report, BadStoresGiveOneClearLine) {
    EXPECT_THAT(failure((directory_ / "absent.db").string()), HasSubstr("no results store at"));
    input::write_output(directory_ / "text.db",
                        "this is no database, just a long enough line of text to be read as one\n");
    EXPECT_THAT(failure((directory_ / "text.db").string()), HasSubstr("not an SQLite file"));
    const std::string empty = make_store(empty_store_sql());
    EXPECT_THAT(failure(empty), HasSubstr("holds no cell"));
    fs::remove(directory_ / "store.db");
    EXPECT_THAT(failure(make_store("create table other(a);")), HasSubstr("is not a results store"));
    fs::remove(directory_ / "store.db");
    const std::string newer = store_sql() + "pragma user_version = 999;";
    EXPECT_THAT(failure(make_store(newer)), HasSubstr("schema version 999"));
}

TEST_F(Report, BytesTableAsMarkdown) {
    const TextGrid grid = bytes_grid(read_report(make_store()), "cube8");
    EXPECT_EQ(
        grid_markdown(grid),
        "*Bytes per edge of the built tables, cube8*\n\n"
        "| algorithm | table type | voronoi planes | topology | total | paper's subtotal (slope) | total "
        "(slope) "
        "| table, bytes |\n"
        "| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: |\n"
        "| vclip | aos_f64 | 128 | 40 | not measured (1) | 168 | not measured (1) | not measured (1) |\n"
        "| gjk | aos_f32 | not measured (1) | not measured (1) | not measured (1) | not measured (1) "
        "| not measured (1) | not measured (1) |\n"
        "\n1. no such figure is stored\n\n");
}

TEST_F(Report, RatioIntervalsComeFromTheRounds) {
    const ReportData data = read_report(make_store());
    const TextGrid grid = time_grid(data, "static", PairKind::Separated);
    ASSERT_FALSE(grid.rows.empty());
    expect_texts(grid.rows[0], {{6, "1.000"}, {7, "1.000 to 1.006"}});
    for (const ReportCell& cell : data.cells)
        for (const measure::Round& round : cell.rounds)
            EXPECT_FALSE(round.ratio(&measure::Timing::overlapping));
}

}  // namespace
}  // namespace edgewise::reports
