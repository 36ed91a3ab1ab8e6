// SPDX-License-Identifier: MIT
//
// Files of a figure of the paper: the data file has the points of the picture, the PDF is a valid PDF, and
// the text names the commands of the store.
#include "edgewise/reports/page/page.hpp"

#include <gmock/gmock.h>

#include <cstdlib>

#include "csv_reader.hpp"
#include "edgewise/measure/process/child_process.hpp"
#include "edgewise/reports/page/report.hpp"
#include "made_up_data.hpp"
#include "report_store.hpp"

namespace edgewise::reports {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

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
