// SPDX-License-Identifier: MIT
//
// The answer of made stores: the winner, ties, dropped cells, what is said where nothing beats the baseline;
// and what a recommendation rests on: the errors of all its scenes, and cells that were measured.
#include "edgewise/reports/answer/answer.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "answer_cells.hpp"
#include "edgewise/reports/answer/answer_text.hpp"
#include "edgewise/reports/answer/ranking.hpp"
#include "edgewise/store/schema.hpp"

namespace edgewise::reports {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const TimedCell made_paper{"vclip", "aos", "f64", {0.98, 1.0, 1.02}},
    made_lean{"vclip", "lean", "f32", {0.70, 0.72, 0.74}, 1e-7, 8.8},
    made_lean_double{"vclip", "lean", "f64", {0.73, 0.75, 0.77}, 1e-16, 12.8},
    made_slow{"vclip", "soa", "f64", {1.2, 1.3, 1.4}, 1e-15, 233.5},
    made_gjk{"gjk", "lean", "f64", {1.4, 1.5, 1.6}, 1e-15, 12.8},
    made_rough{"vclip", "quantised", "f64", {0.5, 0.5, 0.51}, 2e-5, 6.8},
    made_small{"vclip", "lean", "f64", {2.4, 2.5, 2.6}, 1e-16, 12.8};

ReportData answer_data(const std::vector<TimedCell>& cells, const std::string& parameters = shared_tables) {
    ReportData data;
    for (const TimedCell& cell : cells) data.cells.push_back(answer_cell(cell, parameters));
    return data;
}

std::vector<std::string> tie_set(const SceneRanking& scene) {
    std::vector<std::string> names;
    for (const std::size_t i : scene.ties) names.push_back(scene.cells[i].name());
    return names;
}

TEST(Answer, TheFastestWithinTheErrorWinsAndTiesReachItsInterval) {
    const ReportData data =
        answer_data({made_paper, made_slow, made_lean_double, made_lean, made_rough, made_gjk});
    const Answer answer = answer_of(data);
    ASSERT_EQ(answer.shared.size(), 1u);
    EXPECT_TRUE(answer.own.empty());
    const SceneRanking& scene = answer.shared.front();
    ASSERT_TRUE(scene.winner());
    EXPECT_EQ(scene.winner()->name(), "V-Clip on lean_f32");
    EXPECT_EQ(scene.winner()->low(), 0.70);
    EXPECT_EQ(scene.winner()->high(), 0.74);
    EXPECT_THAT(tie_set(scene), ElementsAre("V-Clip on lean_f32", "V-Clip on lean_f64"));
    EXPECT_EQ(scene.cells.front().name(), "V-Clip on quantised_f64");
    EXPECT_EQ(scene.cells.front().dropped, "error 2.0e-05 is over 1e-6");
    EXPECT_TRUE(scene.beats_baseline);
    EXPECT_EQ(scene.best("gjk")->name(), "GJK on lean_f64");
    EXPECT_EQ(scene.choice(), scene.winner());
    EXPECT_EQ(answer.vertices, 386);
}

/// A second sweep of fewer queries into one store is no second process.
TEST(Answer, IsOfOneNumberOfQueriesAndSeed) {
    ReportData data = answer_data({made_paper, made_lean, made_gjk});
    ReportCell fewer = answer_cell({"vclip", "lean", "f32", {0.4, 0.4, 0.4}, 1e-7, 8.8}, shared_tables);
    fewer.queries -= 1;
    data.cells.push_back(fewer);
    const SceneRanking scene = answer_of(data).shared.front();
    EXPECT_EQ(scene.winner()->ratio, 0.72);
    EXPECT_EQ(scene.winner()->processes, 1);
}

TEST(Answer, WhereTheBaselineTiesNothingBeatsItAndTheSmallestIsNamed) {
    const TimedCell single{"vclip", "aos", "f32", {0.95, 0.96, 1.03}, 1e-7, 138.8};
    const ReportData data = answer_data({made_paper, single, made_slow, made_small, made_gjk});
    const Answer answer = answer_of(data);
    const SceneRanking& scene = answer.shared.front();
    EXPECT_EQ(scene.winner()->name(), "V-Clip on aos_f32");
    EXPECT_FALSE(scene.beats_baseline);
    EXPECT_EQ(scene.choice()->name(), "V-Clip on aos_f32");
    const std::string text = terminal_text(answer, data);
    EXPECT_THAT(text, HasSubstr("nothing beats the paper's layout"));
    EXPECT_THAT(text, HasSubstr("take V-Clip on aos_f32"));
    EXPECT_THAT(text, HasSubstr("138.8 bytes per edge"));
}

/// The winner's interval lies below 1. Where the baseline against itself differs by as much, in either
/// direction, it is no difference; a noisy scene says nothing of a quiet one.
TEST(Answer, ARatioWithinTheNoiseOfItsSceneIsNone) {
    const TimedCell ahead{"vclip", "lean", "f32", {0.93, 0.94, 0.95}, 1e-7, 8.8};
    const auto at = [](double ratio) { return std::vector<double>{ratio - 0.01, ratio, ratio + 0.01}; };
    const std::vector<std::pair<double, bool>> cases = {
        {1.2, false}, {1 / 1.2, false}, {1.01, true}, {0.99, true}};
    ReportData data;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const std::string scene = R"({"bodies":)" + std::to_string(10 + i) + "}";
        for (const TimedCell& made :
             {TimedCell{"vclip", "aos", "f64", at(cases[i].first)}, ahead, made_gjk}) {
            data.cells.push_back(answer_cell(made, scene));
            data.cells.back().scene_label = "scene " + std::to_string(i);
        }
    }
    const Answer answer = answer_of(data);
    ASSERT_EQ(answer.shared.size(), cases.size());
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const SceneRanking& scene = answer.shared[i];
        EXPECT_NEAR(scene.own_variation.high() * scene.own_variation.low(), 1, 1e-15)
            << "the same factor in both directions";
        EXPECT_NEAR(scene.own_variation.high(), std::max(cases[i].first, 1 / cases[i].first), 1e-15);
        EXPECT_EQ(scene.beats_baseline, cases[i].second) << "scene " << i;
    }
    EXPECT_THAT(terminal_text(answer, data), HasSubstr("differs by 1.0 % (scene 2) to 20 % (scene 0)"));
}

/// The winner's interval is so wide that everything ties: nothing small and slow is recommended for that.
TEST(Answer, WhatIsTooNoisyIsNotChosenBy) {
    const TimedCell noisy{"vclip", "aos", "f32", {0.5, 0.9, 1.9}, 1e-7, 138.8},
        tiny{"gjk", "points_soa", "f32", {1.7, 1.8, 1.9}, 1e-7, 4.1};
    const ReportData data = answer_data({made_paper, noisy, tiny, made_small});
    const Answer answer = answer_of(data);
    const SceneRanking& scene = answer.shared.front();
    EXPECT_EQ(scene.ties.size(), 3u);
    EXPECT_EQ(scene.choice(), scene.baseline());
    EXPECT_EQ(scene.smallest_of_ties()->name(), "V-Clip on aos_f32") << "points_soa is twice as slow";
    EXPECT_THAT(terminal_text(answer, data),
                HasSubstr("shared table: nothing is recommended: too noisy to choose by"));
    EXPECT_TRUE(scene.too_noisy() && answer_json(answer)["take"]["too_noisy"] == scene.noise);
    ReportData more = data;
    for (const TimedCell& made : {made_paper, made_lean, made_gjk, tiny})
        more.cells.push_back(answer_cell(made, R"({"bodies":12})"));
    const Answer quiet = answer_of(more);
    const auto take = recommendation_of(quiet.shared);
    ASSERT_TRUE(take);
    EXPECT_EQ(take->table, "lean_f32") << "the quiet scene alone decides";
}

TEST(Answer, SharedAndOwnTablesAreAnsweredApart) {
    ReportData data = answer_data({made_paper, made_slow, made_small, made_gjk});
    for (const TimedCell& made : {made_paper, made_lean, made_gjk})
        data.cells.push_back(answer_cell(made, own_tables_scene));
    const Answer both = answer_of(data);
    EXPECT_EQ(both.shared.size(), 1u);
    ASSERT_EQ(both.own.size(), 1u);
    EXPECT_EQ(both.own.front().winner()->name(), "V-Clip on lean_f32");
    EXPECT_EQ(both.shared.front().choice()->name(), "V-Clip on aos_f64");
    const std::string text = terminal_text(both, data);
    EXPECT_THAT(text, HasSubstr("If your bodies share a table, take V-Clip on aos_f64."));
    EXPECT_THAT(text, HasSubstr("If every body has a table of its own, take V-Clip on lean_f32."));
    EXPECT_THAT(text, HasSubstr("shared table: take V-Clip on aos_f64: 1.00 [0.98, 1.02]"));
    EXPECT_THAT(text, HasSubstr("a table each: take V-Clip on lean_f32: 0.72 [0.70, 0.74]"));
    const Answer shared = answer_of(data, {.own_tables = false});
    EXPECT_TRUE(shared.own.empty());
    EXPECT_EQ(shared.shared.size(), 1u);
}

TEST(Answer, OneShapeAtATime) {
    ReportData data = answer_data({made_paper, made_lean});
    data.cells.push_back(answer_cell(made_slow, shared_tables, "cube8"));
    EXPECT_EQ(answer_of(data).shared.front().shape, "sphere386");
    const Answer cubes = answer_of(data, {.shape = "cube8"});
    ASSERT_EQ(cubes.shared.size(), 1u);
    EXPECT_EQ(cubes.vertices, 8);
    EXPECT_EQ(cubes.shared.front().cells.size(), 1u);
    EXPECT_TRUE(answer_of(data, {.shape = "none"}).scenes().empty());
    EXPECT_THAT(terminal_text(answer_of(data, {.shape = "none"}), data),
                HasSubstr("No cell of this store answers the question."));
}

TEST(Answer, OthersNeverWin) {
    TimedCell peer{"bullet", "bullet", "f64", {0.1, 0.1, 0.1}},
        raw{"vclip", "aos", "f64", {0.1, 0.1, 0.1}, 1e-15, 234, "hardening=off", store::CellStatus::judged},
        axis{"vclip", "lean", "f64", {0.1, 0.1, 0.1}, 1e-15, 12.8, "order=bfs"},
        failed{"vclip", "lean", "f64", {0.1, 0.1, 0.1}, 1e-15, 12.8, "", store::CellStatus::failed};
    peer.status = store::CellStatus::judged;
    ReportData data = answer_data({made_paper, made_lean, raw, axis, failed});
    data.peers = {answer_cell(peer)};
    const Answer answer = answer_of(data);
    const SceneRanking& scene = answer.shared.front();
    EXPECT_EQ(scene.cells.size(), 2u);
    EXPECT_EQ(scene.winner()->name(), "V-Clip on lean_f32");
    ASSERT_TRUE(scene.best_peer());
    EXPECT_EQ(scene.best_peer()->name(), "bullet");
}

/// A scene of a file counts like a built-in one, and its needs are an axis of all its cells.
TEST(Answer, ScenesOfFilesCount) {
    ReportData data;
    for (TimedCell made : {made_paper, made_lean}) {
        made.axes = "needs=distance";
        data.from_files.push_back(answer_cell(made, own_tables_scene));
        data.from_files.back().scene = "mine", data.from_files.back().scene_kind = "tumble";
    }
    const Answer answer = answer_of(data);
    ASSERT_EQ(answer.own.size(), 1u);
    EXPECT_EQ(answer.own.front().winner()->table, "lean_f32");
    EXPECT_EQ(answer.own.front().sentence,
              "600 bodies drift and turn by 0.1 rad per step, pairs followed from step to step; a table for "
              "each body");
}

TEST(Answer, CountsWhatWasNotMeasuredByReason) {
    const ReportData data = answer_data({made_paper, made_lean});
    const Answer answer = answer_of(data);
    EXPECT_EQ(answer.gaps.missing, 2u);
    EXPECT_EQ(answer.gaps.figures(), 18u);
    ASSERT_EQ(answer.gaps.gaps.size(), 1u);
    EXPECT_EQ(answer.gaps.gaps.front().reason, "no counters here");
    EXPECT_EQ(answer.gaps.gaps.front().remedy, "bare metal");
    EXPECT_THAT(answer.gaps.gaps.front().probes, ElementsAre("counters"));
    EXPECT_THAT(terminal_text(answer, data), HasSubstr("2 of 18 figures were not measured."));
}

TEST(Answer, AStoppedSweepSaysWhatIsMissing) {
    ReportData data = answer_data({made_paper, made_lean});
    data.build.id = "b";
    const std::string key = std::string(store::run_key) + "sweep --plan quick";
    data.meta = {
        {key, R"({"build":"b","cells":1281,"done":2,"started":"2026-01-01T00:00:00Z","ended":null})"}};
    const Answer stopped = answer_of(data);
    EXPECT_EQ(missing_cells(stopped.runs), 1279u);
    EXPECT_THAT(terminal_text(stopped, data),
                HasSubstr("A sweep did not finish: 1279 cells of its plan are missing"));
    data.meta = {{key, R"({"build":"b","cells":1281,"done":2,"started":"2026-01-01T00:00:00Z",)"
                       R"("ended":"2026-01-01T01:00:00Z"})"}};
    EXPECT_THAT(terminal_text(answer_of(data), data), Not(HasSubstr("did not finish")));
}

TEST(Answer, AsJson) {
    ReportData data = answer_data({made_paper, made_lean, made_lean_double, made_rough, made_gjk});
    const nlohmann::json json = answer_json(answer_of(data));
    for (const char* key : {"asked", "take", "next", "dropped", "changes_it", "held", "command"})
        EXPECT_TRUE(json.contains(key)) << key;
    EXPECT_EQ(json["take"]["table"], "lean_f32");
    EXPECT_EQ(json["take"]["too_noisy"], "");
    EXPECT_EQ(json["take"]["algorithm"], "vclip");
    EXPECT_EQ(json["take"]["time_ratio"], nlohmann::json({0.70, 0.72, 0.74}));
    EXPECT_EQ(json["take"]["bytes_per_edge"], 8.8);
    EXPECT_TRUE(json["take"]["lines_per_query"].is_null());
    EXPECT_EQ(json["next"][0]["table"], "lean_f64");
    EXPECT_EQ(json["next"][0]["ties"], true);
    EXPECT_EQ(json["dropped"][0]["table"], "quantised_f64");
    EXPECT_TRUE(json["held"].is_null());
    EXPECT_THAT(json["command"].get<std::string>(), HasSubstr("edgewise advise"));
}

TEST(Answer, LimitsAreWrittenShort) {
    EXPECT_EQ(limit_text(1e-6), "1e-6");
    EXPECT_EQ(limit_text(2.5e-12), "2.5e-12");
    EXPECT_EQ(size_text(5.8 * 1024 * 1024), "5.80 MiB");
    EXPECT_EQ(size_text(1.02 * 1024 * 1024) + " of " + size_text(1.04 * 1024 * 1024), "1.02 MiB of 1.04 MiB");
}

/// Over every scene that the sentence speaks of, not that in which the layout does best.
TEST(Answer, TheWorstErrorIsTheLargestOfAllScenesOfTheSentence) {
    ReportData data;
    const double errors[] = {9.6e-8, 1.46e-7, 1.2e-7};
    for (std::size_t i = 0; i < std::size(errors); ++i) {
        TimedCell lean = made_lean;
        lean.error = errors[i];
        lean.ratios = i == 1 ? std::vector<double>{1.7, 1.8, 1.9} : made_lean.ratios;
        for (const TimedCell& made : {made_paper, lean, made_gjk})
            data.cells.push_back(answer_cell(made, R"({"bodies":)" + std::to_string(10 + i) + "}"));
    }
    const Answer answer = answer_of(data);
    const auto take = recommendation_of(answer.shared);
    ASSERT_TRUE(take && take->worst_error);
    EXPECT_EQ(take->table, "lean_f32");
    EXPECT_EQ(*take->worst_error, 1.46e-7);
    EXPECT_THAT(terminal_text(answer, data), HasSubstr("worst error 1.5e-07"));
    const nlohmann::json json = answer_json(answer);
    EXPECT_EQ(json["take"]["error"], 1.46e-7);
}

/// V-Clip and GJK, each on a small and on a fast layout; without one of them nothing is recommended, and the
/// sentence says which and how to measure it.
TEST(Answer, NothingIsRecommendedWithoutSmallAndFastCells) {
    const TimedCell big_gjk{"gjk", "aos", "f64", {0.8, 0.81, 0.82}, 1e-15, 90},
        small_gjk{"gjk", "points_soa", "f32", {1.8, 1.9, 2}, 1e-7, 4.1}, big_vclip = made_paper,
                                                                         small_vclip = made_small;
    const std::vector<std::pair<TimedCell, std::string>> needed = {{big_vclip, "V-Clip on a fast layout"},
                                                                   {small_vclip, "V-Clip on a small layout"},
                                                                   {big_gjk, "GJK on a fast layout"},
                                                                   {small_gjk, "GJK on a small layout"}};
    for (std::size_t left_out = 0; left_out <= needed.size(); ++left_out) {
        ReportData data;
        for (std::size_t i = 0; i < needed.size(); ++i) {
            data.cells.push_back(answer_cell(needed[i].first));  // where all are known
            if (i != left_out) data.cells.push_back(answer_cell(needed[i].first, own_tables_scene));
        }
        const Answer answer = answer_of(data);
        ASSERT_EQ(answer.own.size(), 1u);
        const std::string text = terminal_text(answer, data);
        const bool complete = left_out == needed.size();
        EXPECT_EQ(recommendation_of(answer.own).has_value(), complete) << left_out;
        EXPECT_TRUE(recommendation_of(answer.shared)) << left_out;
        if (complete) {
            EXPECT_THAT(text, Not(HasSubstr("nothing is recommended")));
            continue;
        }
        EXPECT_THAT(answer.own.front().not_measured, ElementsAre(needed[left_out].second));
        EXPECT_THAT(text,
                    HasSubstr("a table each: nothing is recommended: too few cells (own: not measured: "));
        EXPECT_THAT(text, HasSubstr(needed[left_out].second));
        EXPECT_THAT(text, HasSubstr("edgewise advise --shape sphere386 --own-tables --error 1e-6"));
        EXPECT_TRUE(answer_json(answer_of(data, {.own_tables = true}))["take"].is_null());
    }
}

/// All cells of GJK exceed the error limit. The text says so, and does not call GJK unmeasured.
TEST(Answer, AnAlgorithmOverTheLimitIsNotCalledUnmeasured) {
    ReportData data;
    TimedCell big_gjk{"gjk", "aos", "f64", {0.8, 0.81, 0.82}, 1e-5, 90},
        small_gjk{"gjk", "points_soa", "f32", {1.8, 1.9, 2}, 1e-4, 4.1};
    for (const TimedCell& made : {made_paper, made_small, big_gjk, small_gjk})
        data.cells.push_back(answer_cell(made));
    const Answer answer = answer_of(data);
    EXPECT_EQ(answer.shared.front().why_not(), "every cell of GJK exceeds the error limit");
    EXPECT_FALSE(recommendation_of(answer.shared));
    EXPECT_THAT(terminal_text(answer, data), AllOf(HasSubstr("every cell of GJK exceeds the error limit"),
                                                   Not(HasSubstr("not measured: GJK"))));
}

// A ranking of cells that several processes measured: intervals and the baseline's own variation are then
// between processes.

/// Adds one table type, measured in one process per ratio; rounds within a process spread by 1 %.
void add_processes(ReportData& data, const std::string& layout, const std::vector<double>& ratios,
                   double error = 1e-16) {
    for (const double ratio : ratios)
        data.cells.push_back(
            answer_cell({"vclip", layout, "f64", {0.99 * ratio, ratio, 1.01 * ratio}, error}));
}

SceneRanking ranking_of(const ReportData& data, double limit = 1e-6) {
    return rank_scene(data.swept(), limit, {});
}

TEST(Ranking, HasMedianAndIntervalBetweenProcesses) {
    ReportData data;
    add_processes(data, "lean", {0.5, 0.7, 0.6});
    const SceneRanking scene = ranking_of(data);
    ASSERT_EQ(scene.cells.size(), 1U);
    const RankedCell& one = scene.cells.front();
    EXPECT_EQ(one.processes, 3U);
    EXPECT_EQ(one.low(), 0.5);
    EXPECT_EQ(one.ratio, 0.6);
    EXPECT_EQ(one.high(), 0.7);
    EXPECT_DOUBLE_EQ(one.ns, 60);
    EXPECT_TRUE(one.holds_between_processes());
}

/// Two processes are too few for an interval, and one has that of its rounds.
TEST(Ranking, HasNoIntervalOfTwoProcesses) {
    ReportData one, two;
    add_processes(one, "lean", {0.6});
    add_processes(two, "lean", {0.5, 0.7});
    EXPECT_DOUBLE_EQ(ranking_of(one).cells.front().low(), 0.99 * 0.6);
    EXPECT_FALSE(ranking_of(two).cells.front().interval);
}

TEST(Ranking, TiesWhereIntervalsMeetOrTheBaselineDiffersAsMuchFromItself) {
    ReportData data;
    add_processes(data, "aos", {0.96, 1, 1.05});
    add_processes(data, "lean", {0.50, 0.51, 0.52});        // first
    add_processes(data, "soa", {0.515, 0.56, 0.6});         // its interval meets the first's
    add_processes(data, "hot_cold", {0.525, 0.53, 0.535});  // 0.53 / 0.51 = 1.04 < 1.05
    add_processes(data, "linked", {0.55, 0.56, 0.57});      // 0.56 / 0.51 = 1.10 > 1.05
    const SceneRanking scene = ranking_of(data);
    EXPECT_DOUBLE_EQ(scene.own_variation.high(), 1.05);
    for (const char* table : {"lean_f64", "soa_f64", "hot_cold_f64"})
        EXPECT_TRUE(scene.ties_with_winner(*scene.find("vclip", table))) << table;
    EXPECT_FALSE(scene.ties_with_winner(*scene.find("vclip", "linked_f64")));
    EXPECT_FALSE(scene.ties_with_winner(*scene.baseline()));
    EXPECT_TRUE(scene.beats_baseline);
}

TEST(Ranking, OwnVariationIsThatOfTheLargerSide) {
    ReportData data;
    add_processes(data, "aos", {0.9, 1, 1.01});
    EXPECT_DOUBLE_EQ(ranking_of(data).own_variation.high(), 1 / 0.9);
}

TEST(Ranking, DroppedCellsNeitherWinNorTieAndAreCompared) {
    ReportData data;
    add_processes(data, "quantised", {0.3, 0.3, 0.3}, 1e-5);
    add_processes(data, "lean", {0.6, 0.6, 0.6}, 1e-7);
    add_processes(data, "aos", {1, 1, 1}, 2e-7);
    const SceneRanking scene = ranking_of(data, 1e-7);
    EXPECT_EQ(scene.winner()->table, "lean_f64");
    EXPECT_EQ(scene.ties.size(), 1U);
    ASSERT_TRUE(scene.baseline());
    EXPECT_EQ(scene.baseline()->dropped, "error 2.0e-07 is over 1e-7");
}

}  // namespace
}  // namespace edgewise::reports
