// SPDX-License-Identifier: MIT
//
// The decision table of made stores: times over several scenes, what near contact and other limits change,
// the sentence above the table.
#include "edgewise/reports/answer/decision.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "answer_cells.hpp"
#include "edgewise/reports/page/chapters/chapters.hpp"

namespace edgewise::reports {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

const TimedCell decided_paper{"vclip", "aos", "f64", {0.98, 1.0, 1.02}},
    decided_lean{"vclip", "lean", "f32", {0.70, 0.72, 0.74}, 1e-7, 8.8},
    decided_double{"vclip", "lean", "f64", {0.8, 0.82, 0.84}, 1e-16, 12.8},
    decided_points{"gjk", "points_soa", "f32", {1.4, 1.5, 1.6}, 1e-7, 4.1},
    decided_points_double{"gjk", "points_soa", "f64", {1.6, 1.7, 1.8}, 1e-16, 8.1};

void add_decided(ReportData& data, const std::vector<TimedCell>& cells, const std::string& parameters,
                 const std::string& shape = "sphere386") {
    for (const TimedCell& one : cells) data.cells.push_back(answer_cell(one, parameters, shape));
}

/// A scene in which every pair is a thousandth of the bodies' size apart.
void add_decided_near(ReportData& data, const std::vector<TimedCell>& cells) {
    for (const TimedCell& one : cells) {
        data.cells.push_back(answer_cell(one, R"({"gap":0.001,"span":0})"));
        data.cells.back().scene = "gap";
    }
}

ReportData decided_store(const std::vector<TimedCell>& cells) {
    ReportData data;
    add_decided(data, cells, shared_tables);
    return data;
}

const std::vector<TimedCell> decided_contest = {decided_paper, decided_lean, decided_double, decided_points,
                                                decided_points_double};

Decision shared_decision(const ReportData& data) { return decision_of(answer_of_scenes(data, {}), false); }
/// The last but one: default flags follow.
std::string near_fact(const ReportData& data) { return shared_decision(data).facts.end()[-2]; }

/// Each of two layouts wins one scene and loses much in the other: the paper's, which wins none, is taken. If
/// it is over the error limit, it is not.
TEST(Decision, TakesNothingThatWinsASceneAndIsSlowerOnAverage) {
    const auto at = [](TimedCell cell, double ratio) {
        cell.ratios = {ratio - 0.01, ratio, ratio + 0.01};
        return cell;
    };
    for (const double error : {1e-15, 1e-5}) {
        ReportData data;
        TimedCell paper = decided_paper;
        paper.error = error;
        add_decided(data, {paper, at(decided_lean, 0.8), at(decided_points, 1.5)}, R"({"bodies":10})");
        add_decided(data, {paper, at(decided_lean, 1.5), at(decided_points, 0.8)}, R"({"bodies":11})");
        const Decision decision = shared_decision(data);
        ASSERT_FALSE(decision.facts.empty());
        EXPECT_EQ(decision.take == "V-Clip on aos_f64", error < 1e-6) << decision.take;
        EXPECT_EQ(decision.facts.front().find("what wins a scene is slower on average") != std::string::npos,
                  error < 1e-6);
    }
}

/// A layout that wins one scene may be over the limit in another, which counts for its mean and its error.
TEST(Decision, TakesNothingThatIsOverTheLimitInAScene) {
    ReportData data;
    TimedCell lean = decided_lean;
    add_decided(data, {decided_paper, lean, decided_double, decided_points_double}, R"({"bodies":10})");
    lean.error = 2e-6;
    add_decided(data, {decided_paper, lean, decided_double, decided_points_double}, R"({"bodies":11})");
    EXPECT_EQ(shared_decision(data).take, "V-Clip on lean_f64");
}

/// Two layouts win a scene each and exceed the limit in the other: the paper's, which wins none, is taken.
TEST(Decision, TakesThePapersLayoutIfAllWinnersAreOverTheLimitElsewhere) {
    ReportData data;
    for (const bool first : {true, false}) {
        TimedCell lean = decided_lean, points = decided_points;
        points.ratios = lean.ratios;
        (first ? points : lean).error = 2e-6;
        add_decided(data, {decided_paper, lean, points, decided_points_double},
                    first ? R"({"bodies":10})" : R"({"bodies":11})");
    }
    const Decision decision = shared_decision(data);
    EXPECT_EQ(decision.take, "V-Clip on aos_f64");
    EXPECT_THAT(decision.facts.front(), HasSubstr("or over the limit elsewhere"));
}

/// Two processes give no interval, and then the mean has none.
TEST(Decision, HasAnIntervalOnlyIfEveryCellHasOne) {
    ReportData data = decided_store(decided_contest);
    EXPECT_THAT(shared_decision(data).facts.front(), HasSubstr("0.72 [0.70, 0.74] of"));
    for (ReportCell& cell : data.cells) cell.rounds.resize(1);
    EXPECT_THAT(
        shared_decision(data).facts.front(),
        testing::AllOf(HasSubstr(" of the time of the paper's layout"), testing::Not(HasSubstr("["))));
}

TEST(Decision, SaysTimeBytesErrorAndNearContact) {
    const Decision decision = shared_decision(decided_store(decided_contest));
    EXPECT_EQ(decision.take, "V-Clip on lean_f32");
    EXPECT_THAT(decision.facts, ElementsAre("0.72 [0.70, 0.74] of the time of the paper's layout",
                                            "9.90 KiB per table, 8.8 bytes per edge", "worst error 1.0e-07",
                                            "near contact: not measured", "default flags: not measured"));
    EXPECT_FALSE(decision.near_contact_changes_it);
}

/// Ratios with default flags are to the paper's layout with default flags.
TEST(Decision, DefaultFlagsChangeItWhereAnotherCellWinsWithThem) {
    const auto add = [](ReportData& data, TimedCell cell, std::vector<double> ratios) {
        cell.axes = "build=default", cell.ratios = std::move(ratios);
        add_decided(data, {cell}, shared_tables);
    };
    ReportData same = decided_store(decided_contest), other = same;
    add(same, decided_paper, {1.9, 2, 2.1});
    add(same, decided_points, {3, 3.1, 3.2});
    add(same, decided_lean, {1.5, 1.6, 1.7});
    EXPECT_EQ(shared_decision(same).facts.back(), "default flags: the same");
    EXPECT_FALSE(shared_decision(same).default_flags_change_it);
    EXPECT_EQ(shared_decision(same).take, shared_decision(other).take) << "they have no vote";
    add(other, decided_paper, {1.9, 2, 2.1});
    add(other, decided_points, {1.4, 1.5, 1.6});
    add(other, decided_lean, {1.7, 1.8, 1.9});
    EXPECT_EQ(shared_decision(other).facts.back(),
              "default flags: GJK on points_soa_f32 takes 0.75, this 0.90");
    EXPECT_TRUE(shared_decision(other).default_flags_change_it);
}

/// Intervals do not show what all rounds have in common.
TEST(Decision, NothingIsTakenFromATimingOnABusyMachine) {
    ReportData data = decided_store(decided_contest);
    for (ReportCell& cell : data.cells) cell.others = 0.45;
    EXPECT_EQ(shared_decision(data).take, "");
    EXPECT_THAT(shared_decision(data).text(),
                HasSubstr("others took 45 % of the processor while it was timed"));
    for (ReportCell& cell : data.cells) cell.others = 0.1;
    EXPECT_EQ(shared_decision(data).take, "V-Clip on lean_f32");
}

/// sqrt(0.72 * 0.5) and so on: one slow scene does not outweigh all others, as in a mean of ratios.
TEST(Decision, TheTimeIsTheGeometricMeanOverTheScenes) {
    ReportData data = decided_store(decided_contest);
    TimedCell fast = decided_lean;
    fast.ratios = {0.4, 0.5, 0.6};
    add_decided(data, {decided_paper, fast, decided_double, decided_points}, R"({"bodies":12})");
    EXPECT_EQ(shared_decision(data).facts.front(),
              "0.60 [0.53, 0.67] of the time of the paper's layout, 0.50 to 0.72 by scene");
}

/// A wide interval ties in both scenes; its median is twice as slow.
TEST(Decision, WhatIsMuchSlowerIsNotTakenBecauseItTies) {
    TimedCell uncertain = decided_points, slow = decided_lean;
    uncertain.ratios = {0.7, 1.4, 1.5}, slow.ratios = {1.2, 1.3, 1.4};
    ReportData data =
        decided_store({decided_paper, decided_lean, decided_double, uncertain, decided_points_double});
    add_decided(data, {decided_paper, slow, decided_double, uncertain, decided_points_double},
                R"({"bodies":12})");
    EXPECT_EQ(shared_decision(data).take, "V-Clip on lean_f64");
}

/// It wins two of three scenes, at 0.9, and loses the third, at 1.4: 1.04 on average.
TEST(Decision, WhatIsSlowerThanThePapersLayoutOnAverageIsNotTaken) {
    TimedCell slow = decided_lean, slow_double = decided_double, slow_points = decided_points;
    for (TimedCell* one : {&slow, &slow_double, &slow_points}) one->ratios = {1.9, 2.0, 2.1};
    TimedCell often = decided_points_double, seldom = decided_points_double;
    often.ratios = {0.89, 0.9, 0.91}, seldom.ratios = {1.39, 1.4, 1.41};
    ReportData data = decided_store({decided_paper, slow, slow_double, slow_points, often});
    add_decided(data, {decided_paper, slow, slow_double, slow_points, often}, R"({"bodies":12})");
    EXPECT_EQ(shared_decision(data).take, "GJK on points_soa_f64");
    add_decided(data, {decided_paper, slow, slow_double, slow_points, seldom}, R"({"bodies":13})");
    EXPECT_EQ(shared_decision(data).take, "V-Clip on aos_f64");
}

/// Each ties in one of two scenes; 0.97 and 0.82 on average. The smaller tables do not decide.
TEST(Decision, OfEquallyManyTiesTheFasterOnAverageIsTaken) {
    TimedCell slow = decided_lean;
    slow.ratios = {1.2, 1.3, 1.4};
    ReportData data = decided_store(decided_contest);
    add_decided(data, {decided_paper, slow, decided_double, decided_points}, R"({"bodies":12})");
    EXPECT_EQ(shared_decision(data).take, "V-Clip on lean_f64");
    slow.ratios = {0.84, 0.92, 1.0};
    ReportData near = decided_store(decided_contest);
    add_decided(near, {decided_paper, slow, decided_double, decided_points}, R"({"bodies":12})");
    EXPECT_EQ(shared_decision(near).take, "V-Clip on lean_f32") << "0.81 on average: as fast, and smaller";
}

TEST(Decision, NearContactChangesItWhereAnotherCellWinsThere) {
    ReportData same = decided_store(decided_contest), other = same, inexact = same;
    add_decided_near(same, decided_contest);
    EXPECT_EQ(near_fact(same), "near contact: the same");
    EXPECT_FALSE(shared_decision(same).near_contact_changes_it);
    TimedCell slow = decided_lean, fast = decided_points, wrong = decided_lean;
    slow.ratios = {1.9, 2, 2.1}, fast.ratios = {0.5, 0.5, 0.5}, wrong.error = 2e-6;
    add_decided_near(other, {decided_paper, slow, decided_double, fast});
    EXPECT_EQ(near_fact(other), "near contact: GJK on points_soa_f32 takes 0.50, this 2.00");
    EXPECT_TRUE(shared_decision(other).near_contact_changes_it);
    add_decided_near(inexact, {decided_paper, wrong, decided_double, decided_points});
    EXPECT_EQ(near_fact(inexact), "near contact: error 2.0e-06 is over 1e-6");
    EXPECT_TRUE(shared_decision(inexact).near_contact_changes_it);
    EXPECT_EQ(answer_of_scenes(other, {}).shared.size(), 1U) << "near contact has no vote of its own";
}

TEST(Decision, SaysHowToMeasureMoreOfARecording) {
    ReportData data;
    add_decided(data, {decided_paper, decided_points}, R"({"rate":60})", "heap");
    for (ReportCell& cell : data.cells)
        cell.scene = "heap", cell.scene_kind = "recorded", cell.shape_source = "9 bodies, recorded (0a)";
    data.scene_files = {{"heap", R"({"recording":"heap.jsonl.gz","scene":"recorded"})"}};
    EXPECT_THAT(shared_decision(data).text(),
                HasSubstr("measure more with: edgewise advise --scene heap.jsonl.gz --shared-tables"));
    EXPECT_THAT(
        decision_of(answer_of_scenes(data, {}), true).text(),
        HasSubstr("not measured; measure it with: edgewise advise --scene heap.jsonl.gz --own-tables"));
}

/// The page's bar and statements: another number of bodies is another scene, and none of the measured ones is
/// not measured.
TEST(Decision, IsOfTheNumberOfBodiesAskedFor) {
    ReportData data;
    TimedCell slow = decided_lean;
    slow.ratios = {1.2, 1.3, 1.4};
    add_decided(data, {decided_paper, slow, decided_double, decided_points}, own_tables_scene);
    add_decided(data, decided_contest, R"({"bodies":9000,"rotation_step":0.1,"own_tables":1})");
    const auto own = [&](double bodies) {
        return decision_of(answer_of_scenes(data, {.own_tables = true, .bodies = bodies}), true);
    };
    EXPECT_EQ(own(600).take, "V-Clip on lean_f64");
    EXPECT_EQ(own(9000).take, "V-Clip on lean_f32");
    EXPECT_THAT(own(0).text(),
                HasSubstr("not measured; measure it with: edgewise advise --shape sphere386 --own-tables"));
}

/// What the chapters state of one body and one kind of tables; never interpolated between numbers of bodies.
TEST(Statements, AreOfTheChosenPartOrSayWhatMeasuresIt) {
    ReportData data = decided_store(decided_contest);
    TimedCell slow = decided_lean, slow_double = decided_double;
    slow.ratios = {1.2, 1.3, 1.4}, slow_double.ratios = {1.16, 1.18, 1.2};
    add_decided(data, decided_contest, shared_tables, "cube8");
    add_decided(data, {decided_paper, slow, slow_double, decided_points}, own_tables_scene);
    const std::string many_tables = R"({"bodies":9000,"rotation_step":0.1,"own_tables":1})";
    add_decided(data, decided_contest, many_tables);
    TimedCell lean = decided_lean, points = decided_points;  // each wins a scene and is slower on average
    lean.ratios = {0.79, 0.8, 0.81}, points.ratios = {1.49, 1.5, 1.51};
    add_decided(data, {decided_paper, lean, points}, own_tables_scene, "sphere38");
    std::swap(lean.ratios, points.ratios);
    add_decided(data, {decided_paper, lean, points}, many_tables, "sphere38");
    const auto statements = nlohmann::json::parse(statements_data(data));
    EXPECT_EQ(
        statements["sphere386 own"]["caches"],
        "With a table each, V-Clip on lean_f32 for sphere386 becomes faster than the paper's layout between numbers measured: "
        "1.30 [1.20, 1.40] of its time with 600 bodies, 0.72 [0.70, 0.74] of its time with 9000 bodies.");
    EXPECT_EQ(statements["sphere38 own"]["caches"],
              "With a table each, the paper's layout is the one to take.");
    EXPECT_EQ(statements["cube8 own"]["caches"],
              "Not measured. This measures it: edgewise sweep --shape cube8 --scenes pressure --caches all");
    EXPECT_EQ(statements["cube8 shared"]["body"],
              "Not measured. This measures it: edgewise sweep --shape cube8 --caches all");
    EXPECT_THAT(statements["sphere386 shared"]["times"].get<std::string>(), HasSubstr("with 386 vertices."));
    EXPECT_FALSE(statements.contains(" both")) << "as the page comes";
}

/// Every number of the sentence is one that a reader has to hold in mind.
TEST(Decisions, TheSentenceHasAtMostThreeNumbers) {
    ReportData data;
    TimedCell slow = decided_lean;
    slow.ratios = {1.2, 1.3, 1.4};
    for (const char* scene : {shared_tables.c_str(), own_tables_scene.c_str()})
        for (const char* shape : {"cube8", "sphere38", "sphere386"})
            add_decided(data,
                        shape == std::string("cube8") ? std::vector{decided_paper, slow, decided_points}
                                                      : decided_contest,
                        scene, shape);
    add_decided_near(data, {decided_paper, slow, decided_double, decided_points});
    const DecisionTable table = Decisions(data).table(1e-6);
    ASSERT_EQ(table.rows.size(), 3U);
    EXPECT_EQ(
        table.sentence,
        "If your bodies share a table, take V-Clip on lean_f32 for most bodies. If every body has a "
        "table of its own, take V-Clip on lean_f32 for most bodies. Of 6 answers, near contact changes 2 and default "
        "compiler flags 0.");
    const std::string plain = std::regex_replace(table.sentence, std::regex("[a-z_]+_f[0-9]+"), "");
    const std::regex number("[0-9.]*[0-9]");
    EXPECT_LE(std::distance(std::sregex_iterator(plain.begin(), plain.end(), number), std::sregex_iterator()),
              3);
}

TEST(Decisions, SayWhatOtherLimitsChange) {
    ReportData data = decided_store(decided_contest);
    const DecisionTable table = Decisions(data).table(1e-6);
    EXPECT_THAT(
        table.changes,
        Contains(
            "An error of at most 1e-8 changes 1 of 1 answer (sphere386, shared table: V-Clip on lean_f64)"));
    EXPECT_THAT(table.rows.front().shared.facts, Contains("default flags: not measured"));
}

TEST(Decisions, AQuestionAboutOneBodyOrOneKindOfTablesHasThatAlone) {
    ReportData data = decided_store(decided_contest);
    add_decided(data, decided_contest, own_tables_scene);
    add_decided(data, decided_contest, shared_tables, "cube8");
    const Question own{.shape = "sphere386", .own_tables = true};
    const std::string text = Decisions(data, own).table(1e-6).text(own);
    EXPECT_THAT(text, HasSubstr("sphere386 (386 vertices), a table each: take V-Clip on lean_f32"));
    EXPECT_THAT(text, testing::Not(testing::AnyOf(HasSubstr("shared table: "), HasSubstr("cube8"))));
}

}  // namespace
}  // namespace edgewise::reports
