// SPDX-License-Identifier: MIT
//
// The chapter on fields from synthetic rows: advice and verdicts, records before and after, the matrix.
#include <gmock/gmock.h>

#include "../made_up_data.hpp"
#include "edgewise/reports/page/chapters/chapters.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

void add(ReportCell& row, const std::string& name, double value) {
    row.figures.push_back({{name, value, "1"}, "fields"});
}

ReportCell made_up(const std::string& algorithm, double time, double lines) {
    ReportCell row;
    row.status = store::CellStatus::verified;
    row.run = "fields";
    row.scene = "tumble", row.scene_label = "fields tumble";
    row.shape = "cube8";
    row.algorithm = algorithm;
    row.layout = "aos";
    row.table = "aos_f64";
    double number = 0;
    for (const char* field : {"point", "plane", "ends"}) {
        add(row, std::string("number.") + field, number);
        add(row, std::string("bytes.") + field, 8 * (number + 1));
        add(row, std::string("own_group.") + field, number == 0 ? 0 : 1);
        add(row, std::string("advised_group.") + field, number);
        add(row, std::string("step_part.") + field, 0.25);
        ++number;
    }
    add(row, "same_query.point.plane", 1);
    add(row, "same_step.point.plane", 0.125);
    add(row, "lines.original", 32);
    add(row, "lines.predicted", 27);
    add(row, "lines.advised", 27);
    add(row, "lines_held", lines);
    add(row, "misses.zen5.L1D.original", 9);
    add(row, "misses.zen5.L1D.advised", 7);
    add(row, "time_ratio.advised", 0.98);
    add(row, "time_ratio_low.advised", 0.97);
    add(row, "time_ratio_high.advised", 0.99);
    add(row, "time_held", time);
    return row;
}

ReportData data_with_fields() {
    ReportData data;
    data.fields = {made_up("vclip", 1, 1), made_up("gjk", 0, 1), made_up("other", -1, 0)};
    data.fields.push_back(made_up("failed", 1, 1));
    data.fields.back().status = store::CellStatus::failed;
    return data;
}

TEST(FieldTables, SayWhatBecameOfAdvice) {
    const TextGrid grid = field_advice_grid(data_with_fields());
    ASSERT_EQ(grid.rows.size(), 3U) << "what failed gives no advice";
    for (const auto& row : grid.rows) ASSERT_EQ(row.size(), grid.columns.size());
    EXPECT_EQ(cell_of(grid, 0, "predicted").text, "27");
    EXPECT_EQ(cell_of(grid, 0, "time, advised").text, "0.980 [0.970, 0.990]");
    EXPECT_EQ(cell_of(grid, 0, "misses, zen5 L1D").text, "9");
    EXPECT_EQ(cell_of(grid, 0, "as advised", 1).text, "7");
    EXPECT_EQ(cell_of(grid, 0, "time").text, "held");
    EXPECT_EQ(cell_of(grid, 1, "time").text, "within the noise");
    EXPECT_EQ(cell_of(grid, 2, "time").text, "did not hold");
    EXPECT_EQ(cell_of(grid, 2, "lines", 1).text, "did not hold");
}

TEST(FieldTables, CountVerdicts) {
    EXPECT_EQ(
        field_verdict(data_with_fields()),
        " Of 3 tables and algorithms the advice held in lines 2 times; in time it held 1 times, made 1 slower, "
        "and was within the noise of 1.");
    EXPECT_THAT(field_verdict({}), HasSubstr("Not measured here"));
}

TEST(FieldTables, ShowRecordsNowAndAdvised) {
    const TextGrid grid = field_groups_grid(data_with_fields().fields.front());
    std::vector<std::string> rows;
    for (const auto& row : grid.rows) rows.push_back(row[0].text + ": " + row[1].text + ", " + row[2].text);
    EXPECT_THAT(rows, testing::ElementsAre("now: point, 8", "now: plane, ends, 40", "advised: point, 8",
                                           "advised: plane, 16", "advised: ends, 24"));
}

TEST(FieldTables, PaintTheMatrix) {
    const std::string picture = field_picture(data_with_fields().fields.front());
    EXPECT_THAT(picture, HasSubstr("point and plane, same query: 1.000"));
    EXPECT_THAT(picture, HasSubstr("plane and point, same step: 0.125"));
    EXPECT_THAT(picture, HasSubstr("steps that read ends: 0.250"));
    EXPECT_THAT(picture, Not(HasSubstr("#fff"))) << "reads on black too";
}

TEST(FieldTables, FillAChapterWhereThereAreAny) {
    EXPECT_FALSE(fields_chapter({}));
    const auto chapter = fields_chapter(data_with_fields());
    ASSERT_TRUE(chapter);
    EXPECT_EQ(chapter->title, "Which fields travel together?");
    EXPECT_EQ(chapter->blocks.size(), 4U);
}

TEST(CoAccessPicture, EscapesNames) {
    ReportCell row;
    row.table = "x & y";
    add(row, "number.a<b", 0);
    const std::string picture = field_picture(row);
    EXPECT_THAT(picture, HasSubstr("x &amp; y"));
    EXPECT_THAT(picture, HasSubstr("a&lt;b"));
    EXPECT_THAT(picture, Not(HasSubstr("a<b")));
}

}  // namespace
}  // namespace edgewise::reports
