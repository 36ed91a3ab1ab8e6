// SPDX-License-Identifier: MIT
//
// The break-even map of synthetic stores: the places of scenes, what is a tie, and what the map says. That
// winners and ties are those of the stored cells is tested in one_ranker_test.cpp, with every other output.
#include "edgewise/reports/answer/break_even_map.hpp"

#include <gmock/gmock.h>

#include "answer_cells.hpp"
#include "edgewise/reports/pictures/ranking_pictures.hpp"
#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct MapScene {
    const char *scene, *parameters, *coherence, *tables;
};
constexpr MapScene map_scenes[] = {
    {"cold", R"({"distance":1})", "cold, every pair new", "one shared table"},
    {"tumble", R"({"rotation_step":0.001,"bodies":12})", "tumble, 0.001 rad", "one shared table"},
    {"tumble", R"({"rotation_step":0.3,"bodies":12})", "tumble, 0.3 rad", "one shared table"},
    {"tumble", R"({"rotation_step":0.01,"random_orientation":1})", "tumble, random turns",
     "one shared table"},
    {"pressure", R"({"bodies":600,"rotation_step":0.1})", "pressure, 0.1 rad", "100 to 999 tables"},
    {"tumble", R"({"bodies":12,"own_tables":1,"rotation_step":0})", "tumble, no turn", "10 to 99 tables"}};

struct MapShape {
    const char* name;
    int vertices;
};
constexpr MapShape map_shapes[] = {{"cube8", 8}, {"sphere38", 38}, {"sphere386", 386}};

ReportCell map_cell(const MapScene& scene, const MapShape& shape, const TimedCell& made) {
    ReportCell cell = answer_cell(made, scene.parameters, shape.name);
    cell.scene = scene.scene;
    cell.scene_label = std::string(scene.scene) + scene.parameters;
    cell.vertices = shape.vertices;
    return cell;
}

const MapRow* row_at(const BreakEvenMap& map, const std::string& tables, const std::string& coherence) {
    for (const MapPanel& panel : map.panels)
        for (const MapRow& row : panel.rows)
            if (panel.tables == tables && row.coherence == coherence) return &row;
    return nullptr;
}

const TimedCell map_paper{"vclip", "aos", "f64", {0.99, 1, 1.01}},
    map_lean{"vclip", "lean", "f64", {0.49, 0.5, 0.51}, 1e-15, 12.8},
    map_lean_single{"vclip", "lean", "f32", {0.5, 0.51, 0.52}, 1e-8, 8.8},
    map_gjk{"gjk", "points_soa", "f64", {0.3, 0.31, 0.32}, 1e-15, 8.1};

TEST(BreakEvenMap, EverySceneAndBodyHasItsPlace) {
    ReportData data;
    for (const MapScene& scene : map_scenes)
        for (const MapShape& shape : map_shapes) data.cells.push_back(map_cell(scene, shape, map_paper));
    const BreakEvenMap map = break_even_map(data, 1e-6);
    ASSERT_EQ(map.columns.size(), std::size(map_shapes));
    EXPECT_EQ(map.measured(), data.cells.size());
    for (const MapScene& scene : map_scenes) {
        const MapRow* row = row_at(map, scene.tables, scene.coherence);
        ASSERT_TRUE(row) << scene.coherence;
        for (std::size_t i = 0; i < map.columns.size(); ++i) {
            EXPECT_EQ(map.columns[i].shape, map_shapes[i].name);
            ASSERT_TRUE(row->cells[i].winner());
            EXPECT_EQ(row->cells[i].winner()->cell->scene_parameters, scene.parameters);
            EXPECT_EQ(row->cells[i].winner()->cell->shape, map_shapes[i].name);
        }
    }
}

TEST(BreakEvenMap, AnotherPrecisionIsNoTie) {
    ReportData data;
    for (const TimedCell& made : {map_paper, map_lean, map_lean_single})
        data.cells.push_back(map_cell(map_scenes[0], map_shapes[2], made));
    const BreakEvenMap map = break_even_map(data, 1e-6);
    ASSERT_EQ(map.panels.size(), 1U);
    const MapCell& cell = map.panels[0].rows.at(0).cells.at(0);
    EXPECT_TRUE(cell.is_won());
    EXPECT_EQ(cell.best_of_others(), nullptr);
    EXPECT_EQ(map.panels[0].only_algorithm(), "V-Clip");
}

/// Where two that are one can differ by a half, a third is no difference; in another scene it is one.
TEST(BreakEvenMap, ADifferenceWithinWhatTheBaselineDiffersFromItselfIsATie) {
    ReportData data;
    const TimedCell slow_paper{"vclip", "aos", "f64", {1.49, 1.5, 1.51}},
        ahead{"vclip", "lean", "f64", {0.59, 0.6, 0.61}}, behind{"vclip", "soa", "f64", {0.79, 0.8, 0.81}};
    for (const TimedCell& made : {map_paper, ahead, behind})
        data.cells.push_back(map_cell(map_scenes[0], map_shapes[2], made));
    for (const TimedCell& made : {slow_paper, ahead, behind})
        data.cells.push_back(map_cell(map_scenes[1], map_shapes[2], made));
    const BreakEvenMap map = break_even_map(data, 1e-6);
    EXPECT_TRUE(row_at(map, "one shared table", "cold, every pair new")->cells[0].is_won());
    const MapCell& cell = row_at(map, "one shared table", "tumble, 0.001 rad")->cells[0];
    EXPECT_THAT(cell.tied_layouts(), ElementsAre("V-Clip on soa"));
}

TEST(BreakEvenMap, SaysFromHowManyVerticesOnWhoWins) {
    ReportData data;
    for (const MapShape& shape : map_shapes) {
        data.cells.push_back(map_cell(map_scenes[0], shape, map_paper));
        data.cells.push_back(map_cell(map_scenes[0], shape, map_lean));
        if (shape.vertices < 100) data.cells.push_back(map_cell(map_scenes[0], shape, map_gjk));
    }
    const BreakEvenMap map = break_even_map(data, 1e-6);
    EXPECT_THAT(break_even_lines(map),
                ElementsAre("cold, every pair new, one shared table: 8 to 38 vertices GJK on points_soa; "
                            "386 vertices V-Clip on lean."));
    EXPECT_EQ(break_even_sentence(map),
              "Of 3 places that were measured, one algorithm and layout wins in 3 (GJK on points_soa 2, "
              "V-Clip on lean 1); several tie in 0, and 0 are too noisy to rank.");
    const MapCell& small = map.panels[0].rows[0].cells[0];
    ASSERT_TRUE(small.best_of_others());
    EXPECT_THAT(cell_text(small), HasSubstr("V-Clip on lean_f64 takes 1.61 times as long"));
}

TEST(BreakEvenMap, APlaceWithoutAnswerSaysWhy) {
    ReportData data;
    TimedCell failed = map_lean;
    failed.status = store::CellStatus::failed;
    data.cells.push_back(map_cell(map_scenes[0], map_shapes[0], map_paper));
    data.cells.push_back(map_cell(map_scenes[0], map_shapes[1], failed));
    data.cells.back().reason = "3 wrong verdicts";
    TimedCell rough = map_lean;
    rough.error = 1e-3;
    data.cells.push_back(map_cell(map_scenes[0], map_shapes[2], rough));
    data.cells.push_back(map_cell(map_scenes[1], map_shapes[1], map_paper));
    data.cells.push_back(map_cell(map_scenes[1], map_shapes[2], map_paper));
    data.cells.push_back(map_cell(map_scenes[1], {"never_timed", 20}, failed));
    const BreakEvenMap map = break_even_map(data, 1e-6);
    EXPECT_EQ(map.columns.size(), 3U) << "of one body nothing was timed";
    EXPECT_EQ(map.bodies_not_timed, 1U);
    const MapRow *cold = row_at(map, "one shared table", "cold, every pair new"),
                 *slow = row_at(map, "one shared table", "tumble, 0.001 rad");
    ASSERT_TRUE(cold && slow);
    EXPECT_TRUE(cold->cells[0].winner());
    EXPECT_EQ(cold->cells[1].why, "failed: 3 wrong verdicts");
    EXPECT_EQ(cold->cells[2].why, "no table type is known to be within an error of 1e-6");
    EXPECT_EQ(slow->cells[0].why, "no scene of this store is of such bodies there");
    const std::string picture = break_even_svg(map);
    for (const char* words : {"not measured", "none within error", "failed: 3 wrong verdicts"})
        EXPECT_THAT(picture, HasSubstr(words));
    const TextGrid grid = break_even_grid(map, 2);
    EXPECT_EQ(grid.columns.size(), 4U);
    EXPECT_THAT(grid.caption, HasSubstr("2 of 3 bodies"));
}

/// If several scenes share a place, the map shows the one nearest to its turn and counts the other scenes.
TEST(BreakEvenMap, OneSceneAPlace) {
    ReportData data;
    const MapScene near{"tumble", R"({"rotation_step":0.11})", "", ""},
        nearer{"tumble", R"({"rotation_step":0.1,"bodies":100})", "", ""};
    data.cells.push_back(map_cell(near, map_shapes[2], map_lean));
    data.cells.push_back(map_cell(nearer, map_shapes[2], map_paper));
    const BreakEvenMap map = break_even_map(data, 1e-6);
    const MapRow* row = row_at(map, "one shared table", "tumble, 0.1 rad");
    ASSERT_TRUE(row);
    EXPECT_EQ(row->cells[0].winner()->table, "aos_f64");
    EXPECT_EQ(row->cells[0].further_scenes, 1U);
}

TEST(BreakEvenMap, NothingToShow) {
    const ReportData none;
    const BreakEvenMap map = break_even_map(none, 1e-6);
    EXPECT_EQ(map.measured(), 0U);
    EXPECT_EQ(break_even_svg(map), "");
    EXPECT_EQ(break_even_sentence(map), "");
}

}  // namespace
}  // namespace edgewise::reports
