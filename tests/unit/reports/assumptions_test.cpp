// SPDX-License-Identifier: MIT
//
// The table of assumptions over synthetic cells: each value has its own row, and the sentences say what holds
// under all values and what does not.
#include "edgewise/reports/paper/chapter/paper_chapter.hpp"

#include <gmock/gmock.h>

#include "claim_cases.hpp"
#include "made_up_data.hpp"

namespace edgewise::reports {
namespace {

using testing::HasSubstr;
using testing::Not;

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
