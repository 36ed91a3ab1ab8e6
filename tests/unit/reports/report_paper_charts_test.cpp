// SPDX-License-Identifier: MIT
//
// The charts of the chapter on the paper's figures, from synthetic data: both algorithms are there, angles
// are folded, what is not in the store is not drawn.
#include <gmock/gmock.h>

#include <cstdlib>
#include <numbers>

#include "csv_reader.hpp"
#include "edgewise/measure/process/child_process.hpp"
#include "edgewise/reports/page/page.hpp"
#include "edgewise/reports/page/report.hpp"
#include "edgewise/reports/paper/chapter/paper_chapter.hpp"
#include "edgewise/reports/paper/charts/paper_charts.hpp"
#include "made_up_data.hpp"
#include "report_store.hpp"

namespace edgewise::reports {
namespace {

using testing::HasSubstr;

void expect_both(const ChartJson& values) {
    for (const char* algorithm : {"vclip", "gjk"})
        EXPECT_FALSE(rows_where(values, "algorithm", algorithm).empty()) << algorithm;
}

TEST(PaperCharts, OfAStoreWithoutSceneFilesAreNone) {
    EXPECT_TRUE(chapter_charts({}).empty());
    ReportData named;
    add_scene(named, "paper_linear_8", "step_in_dimensions");
    EXPECT_TRUE(chapter_charts(named).empty()) << "a scene without cells";
}

TEST(PaperCharts, LinearSpeedHasBothReadingsInMetres) {
    ReportData data;
    add_scene(data, "paper_linear_8", "step_in_dimensions");
    add_both(data, "paper_linear_8", R"({"step_in_dimensions":0.05})", times(100));
    const Chart chart = paper_linear_chart(data);
    const ChartJson& values = chart.spec["data"]["values"];
    ASSERT_EQ(values.size(), 2U);
    expect_both(values);
    EXPECT_NEAR(values[0]["m_s_at_60_Hz"].get<double>(), 3, 1e-12);
    EXPECT_NEAR(values[0]["m_s_at_2_Hz"].get<double>(), 0.1, 1e-12);
    EXPECT_THAT(chart.how_to_read, testing::AllOf(HasSubstr("1.5 m/s"), HasSubstr("3e-5 s")));
}

TEST(PaperCharts, FoldTurnsToWhatTheyAmountTo) {
    constexpr double pi = std::numbers::pi;
    EXPECT_NEAR(folded_angle(2 * pi), 0, 1e-12);
    EXPECT_NEAR(folded_angle(3.93), 2.353, 1e-3);
    EXPECT_EQ(folded_angle(0.5), 0.5);
    EXPECT_NEAR(folded_angle(4 * pi + 0.1), 0.1, 1e-12);
    EXPECT_NEAR(folded_angle(pi), pi, 1e-12);
    EXPECT_NEAR(random_angle, 2.207, 1e-3);
}

ReportData angular_data() {
    ReportData data;
    for (const int vertices : {8, 38, 386}) {
        const std::string scene = "paper_angular_" + std::to_string(vertices);
        add_scene(data, scene, "rotation_step");
        for (const char* step : {"0.1", "3.93", "6.283185307179586"})
            add_both(data, scene, std::string(R"({"rotation_step":)") + step + "}", times(vertices));
        add_both(data, scene, R"({"rotation_step":0,"random_orientation":1})", times(vertices));
    }
    return data;
}

TEST(PaperCharts, AngularSpeedIsFoldedAndRandomStandsApart) {
    const Chart chart = paper_angular_chart(angular_data(), 8);
    const ChartJson& values = chart.spec["data"]["values"];
    ASSERT_EQ(values.size(), 8U);
    expect_both(values);
    const auto raw = rows_where(values, "raw_angle", 3.93);
    ASSERT_EQ(raw.size(), 2U);
    EXPECT_NEAR(raw[0]["angle"].get<double>(), 2.353, 1e-3);
    EXPECT_EQ(raw[0]["unjoined"], true) << "it would lie on the line of the smaller turns";
    const auto random = rows_where(values, "larger", true);
    ASSERT_EQ(random.size(), 2U);
    EXPECT_EQ(random[0]["angle"], random_angle);
    EXPECT_EQ(random[0]["raw_angle"], nullptr);
    EXPECT_EQ(random[0]["point"], "vclip, random orientations");
    EXPECT_THAT(chart.spec.dump(), HasSubstr("raw_angle")) << "the tooltip has it";
    EXPECT_THAT(chart.how_to_read, testing::AllOf(HasSubstr("1.2e-3 s, 12 times"), HasSubstr("2.207")));
}

TEST(PaperCharts, ThreeFiguresShareOneScaleOfTime) {
    const ReportData data = angular_data();
    for (const int figure : {6, 7, 8}) {
        const ChartJson curves = paper_angular_chart(data, figure).spec["layer"].back();
        const ChartJson scale = curves["layer"][0]["encoding"]["y"]["scale"]["domain"];
        EXPECT_EQ(scale[0], 0) << figure;
        EXPECT_NEAR(scale[1].get<double>(), 1.15 * 1.1 * 386, 1e-9) << figure;
    }
}

TEST(PaperCharts, BodiesStandBesideAllPairsAndThePapersEnd) {
    ReportData data;
    for (const char* scene : {"paper_bodies", "paper_bodies_shrinking"}) {
        add_scene(data, scene, "bodies");
        add_both(data, scene, R"({"bodies":10})", {{"cost.pairs_per_step", 4}});
    }
    const ChartJson values = paper_bodies_chart(data).spec["data"]["values"];
    ASSERT_EQ(values.size(), 4U) << "two scenes, all pairs, the paper's end";
    EXPECT_EQ(rows_where(values, "tests", 45.0).size(), 1U);
    EXPECT_EQ(rows_where(values, "bodies", 600).size(), 1U);
}

TEST(PaperCharts, ComplexityHasTimesAndBytes) {
    ReportData data;
    add_scene(data, "paper_complexity", "");
    MadeUp values = times(100);
    values["bytes.table_bytes"] = 4096;
    add_both(data, "paper_complexity", "{}", values);
    const ChartJson rows = paper_complexity_chart(data).spec["data"]["values"];
    ASSERT_EQ(rows.size(), 4U);
    expect_both(rows);
    EXPECT_EQ(rows_where(rows, "value", 4096.0).size(), 2U);
}

ReportData thrash_data() {
    ReportData data;
    add_scene(data, "paper_thrash_386", "rotation_step");
    for (const char* step : {"0.0166667", "0.1166667"})
        add_both(data, "paper_thrash_386", std::string(R"({"bodies":300,"rotation_step":)") + step + "}",
                 {{"caches.pentium3_coppermine.L1D.misses_per_query.warm", 20},
                  {"reuse.line_misses_at_2^10.warm", 30},
                  {"reuse.page_misses_at_2^14.warm", 3}});
    return data;
}

TEST(PaperCharts, MissesSayWhichCachesAreMissing) {
    const Chart chart = paper_misses_chart(thrash_data());
    EXPECT_EQ(chart.spec["data"]["values"].size(), 4U);
    expect_both(chart.spec["data"]["values"]);
    EXPECT_EQ(chart.notes.size(), 3U) << "of four levels one was modelled";
}

TEST(PaperCharts, ReuseIsOfOneTurnWithTheOldSizesAsRules) {
    const ChartJson values = paper_reuse_chart(thrash_data()).spec["data"]["values"];
    EXPECT_EQ(rows_where(values, "unit", "lines").size(), 2U + 1U) << "two algorithms, one rule";
    EXPECT_EQ(rows_where(values, "unit", "pages").size(), 2U + 2U);
}

TEST(PaperCharts, PagingIsPointsAndALineInOnePlot) {
    ReportData data;
    data.paging.push_back(made_up_cell("paging", "vclip", R"({"bodies":600})",
                                       {{"paging.limit_bytes.0", 2e8},
                                        {"paging.held_bytes.0", 1e8},
                                        {"paging.faults_per_query.0", 0.5},
                                        {"paging.predicted_at_held.0", 0.4},
                                        {"paging.predicted_at_limit.0", 0.1},
                                        {"paging.limit_bytes.1", 1e8}}));
    const Chart chart = paper_paging_chart(data);
    const ChartJson& values = chart.spec["data"]["values"];
    EXPECT_EQ(rows_where(values, "kind", "measured").size(), 1U);
    EXPECT_EQ(rows_where(values, "kind", "predicted").size(), 2U);
    ASSERT_EQ(chart.notes.size(), 1U);
    EXPECT_THAT(chart.notes[0], HasSubstr("1 limit")) << "the second has no measurement";
    EXPECT_TRUE(chart.section.empty()) << "without the chapter the chart is listed with the other charts";
}

TEST(PaperCharts, ThisMachineHasItsCachesBesideTheKnees) {
    ReportData data;
    data.build.machine_json = R"({"caches":[{"level":2,"bytes":1048576,"type":"Unified"}]})";
    add_scene(data, "paper_caches_here", "bodies");
    MadeUp values = times(100);
    values["reuse.line_knee_bytes.warm"] = 4096;
    add_both(data, "paper_caches_here", R"({"bodies":75})", values);
    const ChartJson spec = paper_here_chart(data).spec;
    ASSERT_EQ(spec["hconcat"].size(), 2U);
    expect_both(spec["hconcat"][0]["data"]["values"]);
    EXPECT_THAT(spec["hconcat"][1].dump(), HasSubstr("L2 of this machine"));
}

/// 300 bodies need 3 MB; 75 of the same need a quarter of it.
TEST(PaperCharts, KneesThatWereNotTracedAreThoseOfTheThrashInProportion) {
    ReportData data;
    add_scene(data, "paper_caches_here", "bodies");
    add_both(data, "paper_caches_here", R"({"bodies":75})", times(100));
    EXPECT_EQ(paper_here_chart(data).spec["hconcat"].size(), 1U);
    add_scene(data, "paper_thrash_386", "rotation_step");
    add_both(data, "paper_thrash_386", R"({"bodies":300,"rotation_step":0.1166667})",
             {{"reuse.line_knee_bytes.warm", 3e6}});
    const Chart chart = paper_here_chart(data);
    ASSERT_EQ(chart.spec["hconcat"].size(), 2U);
    EXPECT_EQ(chart.spec["hconcat"][1]["data"]["values"][0]["knee"], 7.5e5);
    ASSERT_EQ(chart.notes.size(), 1U);
    EXPECT_THAT(chart.notes[0], HasSubstr("in proportion"));
}

TEST(PaperCharts, AUsersSceneHasAChartOverWhatItVaries) {
    ReportData data;
    add_scene(data, "mine<1>", "margin");
    add_both(data, "mine<1>", R"({"margin":0.25})", times(100));
    data.from_files.push_back(made_up_cell("mine<1>", "gjk", R"({"margin":1})", {}));
    const auto charts = chapter_charts(data);
    ASSERT_EQ(charts.size(), 1U);
    EXPECT_EQ(charts[0].name, "scene_mine_1_") << "the name of a file and of an element";
    expect_both(charts[0].spec["data"]["values"]);
    EXPECT_EQ(charts[0].spec["data"]["values"][0]["place"], 0.25);
    EXPECT_EQ(charts[0].notes.size(), 1U) << "one cell was not timed";
}

using testing::AllOf;
using testing::Not;

/// The cell of a small store, moved to a scene from a file.
std::string scene_sql(const std::string& name) {
    return store_sql() + "insert into meta values('scene " + name +
           R"(','{"scene":"tumble","vary":{"rotation_step":[0.01]}}');)" + "update cell set scene = '" +
           name + "' where hash = 'h-null';" + figure_sql("h-null", "time", "all_ns", "250", "ns");
}

TEST_F(Report, OfThePaperIsAChapterOfThePage) {
    (void)write_report(make_store(scene_sql("paper_angular_8")), (directory_ / "out").string(), "");
    EXPECT_THAT(text("out/index.html"),
                AllOf(HasSubstr("<h2 id=\"paper\">What did the paper find, and do we?</h2>"),
                      HasSubstr("id=\"chart-figure_6\""), HasSubstr("href=\"#paper\""),
                      Not(HasSubstr("id=\"chart-figure_7\""))));
    EXPECT_THAT(text("out/figures/figure_6.vl.json"), HasSubstr("250"));
}

TEST_F(Report, OfAUsersSceneNamesNoPaper) {
    (void)write_report(make_store(scene_sql("mine")), (directory_ / "out").string(), "");
    EXPECT_THAT(text("out/index.html"),
                AllOf(HasSubstr("Your own scenes"), HasSubstr("id=\"chart-scene_mine\""),
                      Not(HasSubstr("Figure 6")), HasSubstr("layouts/sweep --paper")));
}

TEST_F(Report, WithoutSceneFilesSaysHowToGetThePapers) {
    const ReportData data = read_report(make_store());
    const std::vector<Chapter> chapters = paper_chapters(data, {});
    ASSERT_EQ(chapters.size(), 1u);
    EXPECT_TRUE(chapters[0].blocks.empty());
    EXPECT_THAT(chapters[0].paragraph, HasSubstr("layouts/sweep --paper"));
}

// Files of a figure of the paper: the data file has the points of the picture, the PDF is a valid PDF, and
// the text names the commands of the store.

std::string figure_6_sql() {
    return store_sql() +
           R"(insert into meta values('scene paper_angular_8','{"scene":"tumble","vary":{"rotation_step":[0.01]}}'),)"
           "('command sweep --plan paper --rounds 5','b2'),('command sweep --rounds 9','b1');"
           "update cell set scene = 'paper_angular_8' where hash = 'h-null';" +
           figure_sql("h-null", "time", "all_ns", "0.1", "ns");
}

const Chart& figure_6(const std::vector<Chart>& charts) {
    for (const Chart& chart : charts)
        if (chart.name == "figure_6") return chart;
    throw std::runtime_error("no figure 6");
}

TEST_F(Report, HasThePointsOfEachFigureOfThePaper) {
    const std::string store = make_store(figure_6_sql());
    (void)write_report(store, (directory_ / "out").string(), "");
    const Chart chart = figure_6(all_charts(read_report(store)));
    EXPECT_EQ(chart.points, chart.spec["data"]["values"]) << "what is drawn";
    const CsvTable points(text("out/figures/figure_6.csv"));
    ASSERT_EQ(points.rows(), chart.points.size());
    ASSERT_GT(points.rows(), 0u);
    for (std::size_t row = 0; row < points.rows(); ++row)
        for (const auto& [name, value] : chart.points[row].items()) {
            if (value.is_number()) {
                EXPECT_EQ(std::strtod(points.raw(row, name).c_str(), nullptr), value.get<double>()) << name;
            } else if (value.is_string()) {
                EXPECT_EQ(points.text(row, name), value.get<std::string>()) << name;
            }
        }
    EXPECT_THAT(text("out/figures/figure_6.txt"),
                AllOf(HasSubstr("Figure 6: time against angular speed"),
                      HasSubstr("    edgewise sweep --plan paper --rounds 5\n"), Not(HasSubstr("--rounds 9")),
                      HasSubstr("paper_angular_8: {\"scene\""), HasSubstr("Processor: Test CPU"),
                      HasSubstr("No figure_6.pdf: there is no SVG")));
    EXPECT_FALSE(fs::exists(directory_ / "out/figures/time.csv")) << "figures of the paper alone";
    EXPECT_FALSE(fs::exists(directory_ / "out/figures/figure_7.csv")) << "nothing to draw";
}

TEST_F(Report, TurnsThePapersPicturesIntoPdf) {
    const ReportData data = read_report(make_store(figure_6_sql()));
    const std::vector<Chart> charts = all_charts(data);
    StaticPictures pictures;
    pictures.svg["figure_6"] =
        R"(<svg xmlns="http://www.w3.org/2000/svg" width="40" height="30"><path d="M0 0L40 30"/></svg>)";
    fs::create_directories(directory_ / "figures");
    input::write_output(directory_ / "figures/figure_6.svg", pictures.svg["figure_6"]);
    const std::string note = write_cited_figures(data, charts, pictures, directory_);
    const auto version = measure::run_program({"env", "rsvg-convert", "--version"});
    if (version.value && version.value->exit_code == 0) {
        EXPECT_EQ(note, "");
        const std::string pdf = text("figures/figure_6.pdf");
        EXPECT_THAT(pdf, testing::StartsWith("%PDF-"));
        EXPECT_EQ(write_cited_figures(data, charts, pictures, directory_), "");
        EXPECT_EQ(text("figures/figure_6.pdf"), pdf) << "the same store gives the same bytes";
        EXPECT_THAT(text("figures/figure_6.txt"), HasSubstr("rsvg-convert --format pdf"));
    } else {
        EXPECT_THAT(note, HasSubstr("librsvg2-bin"));
        EXPECT_THAT(text("figures/figure_6.txt"),
                    HasSubstr("No figure_6.pdf: rsvg-convert is not installed"));
        EXPECT_FALSE(fs::exists(directory_ / "figures/figure_6.pdf"));
    }
}

TEST(PaperFigures, PointsKeepEveryMemberOfEveryRow) {
    const ChartJson rows = {{{"a", 1.5}, {"b", "=x"}}, {{"a", nullptr}, {"c", true}}};
    EXPECT_EQ(points_csv(rows), "a,b,c\r\n1.5,'=x,\r\n,,true\r\n");
}

}  // namespace
}  // namespace edgewise::reports
