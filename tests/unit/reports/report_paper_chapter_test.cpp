// SPDX-License-Identifier: MIT
//
// The chapter on the paper's figures as a whole: there with scenes from files, not there without them.
#include <gmock/gmock.h>

#include "edgewise/reports/page/report.hpp"
#include "edgewise/reports/paper/chapter/paper_chapter.hpp"
#include "report_store.hpp"

namespace edgewise::reports {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// The cell of a small store, moved to a scene from a file.
std::string scene_sql(const std::string& name) {
    return store_sql() + "insert into meta values('scene " + name +
           R"(','{"scene":"tumble","vary":{"rotation_step":[0.01]}}');)" + "update cell set scene = '" +
           name + "' where hash = 'h-null';" + figure_sql("h-null", "time", "all_ns", "250", "ns");
}

TEST_F(Report, OfThePaperIsAChapterOfBothPages) {
    (void)write_report(make_store(scene_sql("paper_angular_8")), (directory_ / "out").string(), "");
    EXPECT_THAT(text("out/index.html"),
                AllOf(HasSubstr("<h2 id=\"paper\">The paper, replicated</h2>"),
                      HasSubstr("id=\"chart-figure_6\""), HasSubstr("href=\"#paper\"")));
    EXPECT_THAT(text("out/report.md"), AllOf(HasSubstr("## The paper, replicated"),
                                             HasSubstr("#### Figure 6"), Not(HasSubstr("#### Figure 7"))));
    EXPECT_THAT(text("out/figures/figure_6.vl.json"), HasSubstr("250"));
}

TEST_F(Report, OfAUsersSceneNamesNoPaper) {
    (void)write_report(make_store(scene_sql("mine")), (directory_ / "out").string(), "");
    EXPECT_THAT(text("out/report.md"), AllOf(HasSubstr("## Scenes from files"),
                                             HasSubstr("mine: time against"), Not(HasSubstr("Figure 6"))));
}

TEST_F(Report, WithoutSceneFilesHasNoSuchChapter) {
    const ReportData data = read_report(make_store());
    EXPECT_FALSE(paper_chapter(data, {}));
    for (const Chart& chart : all_charts(data)) EXPECT_TRUE(chart.section.empty()) << chart.name;
}

}  // namespace
}  // namespace edgewise::reports
