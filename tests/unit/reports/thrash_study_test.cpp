// SPDX-License-Identifier: MIT
//
// The chapter on the study of figure 8, from synthetic rows: which mechanisms can cause the figure, which
// cannot, and the modelled cells that were also run on this machine.

#include <gmock/gmock.h>

#include "edgewise/reports/paper/chapter/paper_chapter.hpp"
#include "edgewise/reports/paper/charts/paper_charts.hpp"
#include "made_up_data.hpp"

namespace edgewise::reports {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

void add_row(ReportData& data, const std::string& mechanism, const std::string& machine,
             const std::map<std::string, double>& facts) {
    std::map<std::string, double> figures = {{"thrash.settings", static_cast<double>(facts.size())}};
    double all = 0;
    for (const auto& [setting, mask] : facts) {
        figures["thrash.facts." + setting] = mask;
        all += mask == 15;
    }
    figures["thrash.settings_with_all"] = all;
    data.thrash.push_back(made_up_cell("thrash", "vclip",
                                       R"({"intensity":0,"machine":")" + machine + R"(","mechanism":")" +
                                           mechanism + R"(","own_tables":1,"time_step":0.016666666})",
                                       figures));
    data.thrash.back().run = "thrash";
}

ReportData made_up_study(double best) {
    ReportData data;
    add_row(data, "queries_alone", region_machine,
            {{"200_24MiB_4000000ns", best}, {"300_256MiB_4000000ns", 4}, {"300_256MiB_10000ns", 4}});
    add_row(data, "whole_table_transform", region_machine, {{"200_24MiB_4000000ns", 1}});
    add_row(data, "queries_alone", "pentium3_katmai", {});
    return data;
}

void add_curve(ReportData& data, const char* algorithm, int vertices, double measured, double predicted) {
    std::map<std::string, double> figures;
    for (int speed = 1; speed <= 7; ++speed) {
        const std::string at = "." + std::to_string(speed);
        figures["thrash.measured_us" + at] = measured + speed;
        figures["thrash.predicted_us" + at] = predicted + speed;
        figures["thrash.measured_faults" + at] = 0.25;
    }
    ReportCell cell = made_up_cell("thrash_realised", algorithm,
                                   R"({"bodies":200,"fault_us":4000,"machine":"pentium2_deschutes",)"
                                   R"("mechanism":"queries_alone","memory_mib":24,"number":1,)"
                                   R"("own_tables":1,"time_step":0.016666666})",
                                   figures);
    cell.vertices = vertices;
    cell.run = "thrash_realised";
    data.thrash.push_back(cell);
}

TEST(ThrashStudy, NamesTheMechanismsThatGiveAllFacts) {
    const std::string text = thrash_paragraph(made_up_study(15));
    EXPECT_THAT(text, StartsWith("What can be said of figure 8"));
    EXPECT_THAT(text,
                AllOf(HasSubstr("All four facts of figure 8: queries alone in 1 of 3 settings (200 bodies, "
                                "24 MiB, 4000 us a fault; aos_f64, own tables, steps of 1/60 s)"),
                      HasSubstr("whole table transform in none of 1"),
                      HasSubstr("1 on pentium2_deschutes, 0 on pentium3_katmai"),
                      HasSubstr("caches and TLB, take figure 8's time in 0 of 2 settings"),
                      HasSubstr("Nobody can know"), HasSubstr("No cell was made real.")));
    EXPECT_THAT(text, Not(HasSubstr("It is paging")));
}

TEST(ThrashStudy, SaysThatNoMechanismGivesThem) {
    EXPECT_THAT(
        settled_paragraph(made_up_study(7)),
        AllOf(HasSubstr("All four facts of figure 8: no mechanism gives them; queries alone in none of 3"),
              HasSubstr("without the ups and downs: queries alone in 1 of 3")));
    EXPECT_EQ(settled_paragraph({}), "");
}

TEST(ThrashStudy, ComparesWhatWasMadeRealWithItsPrediction) {
    ReportData data = made_up_study(15);
    add_curve(data, "vclip", 386, 993, 793);
    add_curve(data, "vclip", 38, 93, 93);
    add_curve(data, "gjk", 386, 193, 193);
    add_curve(data, "gjk", 38, 90, 90);
    EXPECT_THAT(settled_paragraph(data),
                AllOf(HasSubstr("1 cell"), HasSubstr("200 bodies, 24 MiB, 4000 us a fault"),
                      HasSubstr("longest time 1000 us at 386 vertices and 100 at 38, GJK's 200 and 97"),
                      HasSubstr("at worst 1.25 times")));
    EXPECT_EQ(realised_grid(data).rows.size(), 4U * 7);
    EXPECT_EQ(mechanism_grid(data).rows.size(), 3U);
    data.thrash.back().status = store::CellStatus::unavailable;
    data.thrash.back().reason = "userfaultfd: not here";
    EXPECT_THAT(settled_paragraph(data), HasSubstr("No cell was made real: userfaultfd: not here"));
}

TEST(ThrashStudy, DrawsItsRegionAndItsCells) {
    ReportData data = made_up_study(15);
    add_curve(data, "vclip", 386, 993, 793);
    const Chart region = paper_region_chart(data);
    ASSERT_EQ(region.points.size(), 3U);
    EXPECT_EQ(region.points[0]["facts"], 4);
    EXPECT_EQ(region.points[0]["which"], "rises, takes as long, spares GJK, erratic");
    EXPECT_EQ(paper_realised_chart(data).points.size(), 7U);
    EXPECT_TRUE(paper_region_chart({}).spec.is_null());
    EXPECT_TRUE(paper_realised_chart({}).spec.is_null());
}

}  // namespace
}  // namespace edgewise::reports
