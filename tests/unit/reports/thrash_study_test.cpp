// SPDX-License-Identifier: MIT
//
// The chapter on the study of figure 8, from synthetic rows: which mechanisms can cause the figure, which
// cannot, and the modelled cells that were also run on this machine.

#include <gmock/gmock.h>

#include "claim_cases.hpp"
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

// The table of assumptions over synthetic cells: each value has its own row, and the sentences say what holds
// under all values and what does not.

/// Adds a cell of V-Clip, 1 ns (10 ns at 386 vertices), and a cell of GJK, `gjk` ns.
void add_pair(ReportData& data, const MadeCell& where, int vertices, double gjk) {
    MadeCell made = where;
    made.shape = made_shape(vertices);
    made.algorithm = "vclip";
    add_cell(data, made, made_time(vertices == 386 ? 10 : 1));
    made.algorithm = "gjk";
    add_cell(data, made, made_time(gjk));
}

/// Margins from 0 to 0.2: at 386 vertices V-Clip is faster without one and slower with the widest.
ReportData margins() {
    ReportData data;
    for (const double margin : {0.0, 0.05, 0.1, 0.2}) {
        const MadeCell where{"paper_margin", "", "", "margin", margin};
        add_pair(data, where, 8, 2);
        add_pair(data, where, 38, 0.5);
        add_pair(data, where, 386, margin == 0 ? 20 : margin == 0.2 ? 5 : 10);
    }
    return data;
}

TEST(Assumptions, EachValueStandsForItself) {
    const TextGrid grid = assumptions_grid(margins());
    ASSERT_EQ(grid.rows.size(), 4u);
    for (const auto& row : grid.rows) ASSERT_EQ(row.size(), grid.columns.size());
    expect_texts(grid.rows[0], {{1, "0 diagonals"}, {2, "yes"}});
    EXPECT_EQ(grid.rows[3][2].text, "");
    EXPECT_THAT(grid.rows[0][3].text, HasSubstr("0.500 ["));
    EXPECT_EQ(grid.rows[0][6].text, "faster, slower, faster");
    EXPECT_EQ(grid.rows[1][6].text, "faster, slower, undecided");
    EXPECT_EQ(grid.rows[3][6].text, "faster, slower, slower");
    EXPECT_THAT(grid.rows[0][7].text, HasSubstr("10 [9.6"));
}

TEST(Assumptions, SentencesSayWhatDecides) {
    const std::string text = assumptions_paragraph(margins());
    EXPECT_THAT(text, HasSubstr("At 8 vertices V-Clip is faster under every value measured."));
    EXPECT_THAT(text, HasSubstr("At 38 vertices V-Clip is slower under every value measured."));
    EXPECT_THAT(text, HasSubstr("faster (margin 0 diagonals); slower (margin 0.2 diagonals); "
                                "undecided (margin 0.05 diagonals, margin 0.1 diagonals)"));
}

TEST(Assumptions, OfAnEmptyStoreAreNone) {
    EXPECT_TRUE(assumptions_grid({}).rows.empty());
    EXPECT_EQ(assumptions_paragraph({}), "");
    for (const AssumedValue& one : assumed_values({})) {
        EXPECT_THAT(one.vclip_over_gjk[2].missing, HasSubstr("no cells of scene paper_"));
        EXPECT_FALSE(one.vclip_growth.value);
    }
}

/// An axis is compared with cells of the same axis.
TEST(Assumptions, OfAxesComeFromTheirCells) {
    ReportData data;
    for (const std::string table : {"aos_f64", "aos_f64 sharing=shared"})
        for (const int vertices : {8, 38, 386})
            add_pair(data, {"paper_time_step", "", "", "rotation_step", 4.0 / 60, table}, vertices,
                     table == "aos_f64" ? 100 : 0.01);
    const TextGrid grid = assumptions_grid(data);
    ASSERT_EQ(grid.rows.size(), 2u);
    EXPECT_EQ(grid.rows[0][6].text, "faster, faster, faster");
    expect_texts(grid.rows[1], {{0, "tables"}, {6, "slower, slower, slower"}});
}

}  // namespace
}  // namespace edgewise::reports
