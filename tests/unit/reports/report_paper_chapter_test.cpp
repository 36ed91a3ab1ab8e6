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

}  // namespace
}  // namespace edgewise::reports
