// SPDX-License-Identifier: MIT
//
// Tables of effort from synthetic rows: the algorithms and libraries that they show, their order, the
// machines with simulated misses, and the chapter that shows the tables.
#include <gmock/gmock.h>

#include "edgewise/reports/page/chapters/chapters.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {
namespace {

ReportCell made_up(store::CellStatus status, const std::string& name, std::optional<double> instructions) {
    ReportCell row;
    row.status = status;
    row.run = "effort";
    row.scene = "tumble", row.scene_label = "effort tumble";
    row.shape = "cube8";
    row.vertices = 8;
    row.algorithm = row.layout = name;
    row.precision = "f64";
    row.table = status == store::CellStatus::judged ? name + "_f64" : "lean_f64";
    row.figures = {{{"instructions", instructions, "1", "no valgrind"}, "effort"},
                   {{"zen5.d1_misses", 2.5, "1"}, "effort"},
                   {{"steps", std::nullopt, "steps", "not told"}, "effort"},
                   {{"instructions_over_floor", 12.0, "1"}, "effort"},
                   {{"table_bytes", 280.0, "B"}, "bytes"}};
    return row;
}

ReportData data_with_effort() {
    ReportData data;
    data.effort = {made_up(store::CellStatus::judged, "slow", 9000),
                   made_up(store::CellStatus::verified, "vclip", 700),
                   made_up(store::CellStatus::failed, "gjk", 10),
                   made_up(store::CellStatus::judged, "uncounted", std::nullopt)};
    return data;
}

const GridCell& cell_of(const TextGrid& grid, std::size_t row, const std::string& title) {
    for (std::size_t i = 0; i < grid.columns.size(); ++i)
        if (grid.columns[i].title == title) return grid.rows.at(row).at(i);
    throw std::invalid_argument("no column " + title);
}

TEST(EffortTables, StandFewestInstructionsFirstWithReasons) {
    const TextGrid grid = effort_grid(data_with_effort());
    ASSERT_EQ(grid.rows.size(), 3U) << "what failed was not measured";
    const char* const names[] = {"vclip", "slow", "uncounted"};
    for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_EQ(grid.rows[i].size(), grid.columns.size());
        EXPECT_EQ(cell_of(grid, i, "algorithm or library").text, names[i]);
    }
    EXPECT_EQ(cell_of(grid, 0, "table type or precision").text, "lean_f64");
    EXPECT_EQ(cell_of(grid, 1, "table type or precision").text, "f64");
    EXPECT_EQ(cell_of(grid, 0, "instructions").text, "700");
    EXPECT_EQ(cell_of(grid, 0, "D1 misses, zen5").text, "2.50");
    EXPECT_EQ(cell_of(grid, 0, "bytes of a table").text, "280");
    EXPECT_THAT(cell_of(grid, 2, "instructions").why, testing::HasSubstr("no valgrind"));
    EXPECT_THAT(cell_of(grid, 0, "steps").why, testing::HasSubstr("not told"));
    EXPECT_EQ(cell_of(effort_floor_grid(data_with_effort()), 0, "instructions per flop of it").text, "12");
}

TEST(EffortTables, StandInTheChapterOfPeers) {
    const auto chapter_of = [](const ReportData& data) {
        std::optional<Chapter> found;
        for (Chapter& chapter : report_chapters(answer_of(data), data, {}))
            if (chapter.id == "peers") found = std::move(chapter);
        return found;
    };
    EXPECT_FALSE(chapter_of({}));
    const auto chapter = chapter_of(data_with_effort());
    ASSERT_TRUE(chapter);
    EXPECT_EQ(chapter->blocks.back().title, "What a query takes");
    EXPECT_THAT(chapter->blocks.back().paragraph, testing::HasSubstr("Callgrind"));
    EXPECT_TRUE(data_with_effort().any_failed());
}

}  // namespace
}  // namespace edgewise::reports
