// SPDX-License-Identifier: MIT
//
// Every claim comes out in every way that it can, over synthetic report data; what is missing is never a
// number, and none is judged without a rule.
#include "edgewise/reports/paper/claims/claims.hpp"

#include <gmock/gmock.h>

#include <set>

#include "claim_cases.hpp"
#include "edgewise/reports/paper/claims/claim_rules.hpp"

namespace edgewise::reports {
namespace {

using testing::HasSubstr;

/// Can never be measured here, and says so.
const std::set<std::string> beyond_us = {"share_of_simulation"};

std::vector<ClaimCase> all_cases() {
    std::vector<ClaimCase> all = speed_cases();
    for (const auto& more : {count_cases(), memory_cases()}) all.insert(all.end(), more.begin(), more.end());
    return all;
}

Claim claim_of(const ReportData& data, const std::string& id) {
    for (const Claim& claim : judge_claims(data))
        if (claim.id == id) return claim;
    ADD_FAILURE() << "no claim " << id;
    return {};
}

template <class Change>
void change_cells(ReportData& data, Change change) {
    for (auto* cells : {&data.cells, &data.from_files, &data.stability, &data.paging})
        for (ReportCell& cell : *cells) change(cell);
}

class EveryClaim : public testing::TestWithParam<ClaimCase> {
  protected:
    static Claim judged(double number) { return claim_of(GetParam().make(number), GetParam().id); }
};

TEST_P(EveryClaim, IsReproducedWhereTheRuleIsMet) {
    const Claim claim = judged(GetParam().reproduced);
    EXPECT_EQ(claim.verdict, "reproduced") << claim.reason;
    EXPECT_EQ(claim.reason, "");
    EXPECT_NE(claim.ours, "");
}

TEST_P(EveryClaim, IsNotReproducedWhereTheRuleIsMissed) {
    const Claim claim = judged(GetParam().not_reproduced);
    EXPECT_EQ(claim.verdict, "not reproduced") << claim.ours;
    EXPECT_THAT(claim.reason, HasSubstr("because "));
    EXPECT_NE(claim.ours, "");
}

TEST_P(EveryClaim, IsNotMeasuredForTheStoredReason) {
    ReportData data = GetParam().make(GetParam().reproduced);
    change_cells(data, [](ReportCell& cell) {
        for (store::FigureRow& figure : cell.figures)
            figure.value.reset(), figure.reason = "made to be missing";
    });
    const Claim claim = claim_of(data, GetParam().id);
    EXPECT_EQ(claim.verdict, "not measured") << claim.ours;
    EXPECT_THAT(claim.reason, HasSubstr("made to be missing"));
}

INSTANTIATE_TEST_SUITE_P(Claims, EveryClaim, testing::ValuesIn(all_cases()),
                         [](const auto& one) { return one.param.id; });

TEST(Claims, AreInconclusiveWhereTheIntervalStraddlesTheRule) {
    // Times without a stored interval; page faults.
    std::set<std::string> without_interval = {"equation_2_predicts_step", "updates_count",
                                              "step_linear_in_bodies",    "memory_too_small_swaps",
                                              "swapping_spares_gjk",      "swapping_explains_figure_8"};
    for (const ClaimCase& one : all_cases()) {
        const Claim claim = claim_of(one.make(one.straddling.value_or(one.reproduced)), one.id);
        if (!one.straddling) {
            EXPECT_TRUE(claim.deterministic || without_interval.erase(one.id)) << one.id;
            continue;
        }
        EXPECT_EQ(claim.verdict, "inconclusive") << one.id << ": " << claim.ours << claim.reason;
        EXPECT_THAT(claim.reason, HasSubstr("straddles")) << one.id;
        EXPECT_THAT(claim.ours, HasSubstr("[")) << one.id;
        EXPECT_FALSE(claim.deterministic) << one.id;
    }
    EXPECT_TRUE(without_interval.empty());
}

/// Failures are counted over failed cells too; all else takes verified ones alone.
TEST(Claims, AreNeverReproducedByCellsThatFailed) {
    for (const ClaimCase& one : all_cases()) {
        ReportData data = one.make(one.reproduced);
        change_cells(data, [](ReportCell& cell) { cell.status = "failed", cell.reason = "wrong verdicts"; });
        if (!data.stability.empty() || one.id == "zero_failures_control") continue;
        EXPECT_NE(claim_of(data, one.id).verdict, "reproduced") << one.id;
    }
}

TEST(Claims, AllHaveCases) {
    std::set<std::string> with_cases = beyond_us, ids;
    for (const ClaimCase& one : all_cases()) with_cases.insert(one.id);
    for (const Claim& claim : judge_claims({})) ids.insert(claim.id);
    EXPECT_EQ(ids, with_cases);
}

TEST(Claims, SayWhatTheyAreWhateverTheStore) {
    std::set<std::string> ids;
    for (const Claim& claim : judge_claims({})) {
        EXPECT_TRUE(ids.insert(claim.id).second) << claim.id;
        for (const std::string& text : {claim.section, claim.claim, claim.paper, claim.unit, claim.rule})
            EXPECT_NE(text, "") << claim.id;
        EXPECT_THAT(claim.rule, HasSubstr("Wanted: ")) << claim.id;
        EXPECT_THAT(claim.rule, testing::Not(HasSubstr("Wanted: ."))) << claim.id;
    }
    EXPECT_GE(ids.size(), 40u);
}

TEST(Claims, OfAnEmptyStoreAreNotMeasured) {
    for (const Claim& claim : judge_claims({})) {
        EXPECT_EQ(claim.verdict, "not measured") << claim.id << ": " << claim.ours;
        EXPECT_NE(claim.reason, "") << claim.id;
    }
}

TEST(Claims, WithoutTimesAreDeterministic) {
    for (const ClaimCase& one : all_cases()) {
        const ReportData data = one.make(one.reproduced);
        bool timed = false;
        for (const auto* cells : {&data.cells, &data.from_files, &data.stability, &data.paging})
            for (const ReportCell& cell : *cells)
                for (const store::FigureRow& figure : cell.figures)
                    timed = timed || figure.probe == "time" || figure.probe == "build" ||
                            figure.probe == "paging" || figure.name.ends_with("_ns");
        if (one.id == "caching_favours_vclip_in_steps") continue;  // shares its data with the one in times
        EXPECT_EQ(claim_of(data, one.id).deterministic, !timed) << one.id;
    }
}

/// GJK faster at speeds that are in the range at 1/60 s, slower at those of 1/2 s.
TEST(Claims, ThatDependOnTheTimeStepAreInconclusiveAndSaySo) {
    ReportData data;
    add_angular_time(data, 38, "vclip", 1);
    add_angular(data, 38, "gjk", [](int number) { return made_time(number < 4 ? 0.5 : 2); });
    const Claim claim = claim_of(data, "angular_vclip_faster_38");
    EXPECT_EQ(claim.verdict, "inconclusive");
    EXPECT_THAT(claim.reason, HasSubstr("depends on the time step"));
    EXPECT_THAT(claim.reason, HasSubstr("at steps of 1/60 s not reproduced (because "));
    EXPECT_THAT(claim.reason, HasSubstr("at steps of 1/2 s reproduced"));
    EXPECT_THAT(claim.ours, HasSubstr("0.500"));
}

TEST(Claims, OfTwoReadingsNeedBoth) {
    ReportData data;
    for (const std::string& algorithm : both_algorithms)
        add_cell(data, {"paper_angular_38", "sphere38", algorithm, "rotation_step", 0.05},
                 made_time(algorithm == "gjk" ? 2 : 1));
    EXPECT_EQ(claim_of(data, "angular_vclip_faster_38").verdict, "not measured");
}

/// Bodies in new random orientations each step are at no speed.
TEST(Claims, LeaveRandomOrientationsOut) {
    ReportData data = all_cases()[6].make(1.3);
    ASSERT_EQ(all_cases()[6].id, "angular_vclip_faster_8");
    for (const std::string& algorithm : both_algorithms) {
        add_cell(data, {"paper_angular_8", "cube8", algorithm}, made_time(algorithm == "gjk" ? 1e-6 : 1));
        data.from_files.back().scene_parameters = R"({"rotation_step":0.1,"random_orientation":1})";
    }
    EXPECT_EQ(claim_of(data, "angular_vclip_faster_8").verdict, "reproduced");
}

TEST(Claims, CountFailedCellsAsFailures) {
    ReportData data;
    data.cells.push_back(
        make_cell({"static", "cube8", "gjk"}, {{"error.wrong_verdicts", 0}, {"error.checked", 1e6}}));
    EXPECT_EQ(claim_of(data, "zero_failures_exact").verdict, "reproduced");
    data.cells.push_back(make_cell({"static", "cube8", "vclip"}, {}));
    data.cells.back().status = "failed";
    EXPECT_EQ(claim_of(data, "zero_failures_exact").verdict, "not reproduced");
}

/// No failure in few checks shows little: at most 3/n fail.
TEST(Claims, OfNoFailureNeedManyChecks) {
    ReportData data;
    data.cells.push_back(
        make_cell({"static", "cube8", "gjk"}, {{"error.wrong_verdicts", 0}, {"error.checked", 3000}}));
    const Claim claim = claim_of(data, "zero_failures_exact");
    EXPECT_EQ(claim.verdict, "inconclusive");
    EXPECT_THAT(claim.ours, HasSubstr("[0, 0.001]"));
}

TEST(Claims, CompareTimesWithinRoundsWhereTheyAreStored) {
    ReportData data = all_cases()[3].make(1.2);
    ASSERT_EQ(all_cases()[3].id, "static_gjk_faster");
    for (ReportCell& cell : data.from_files)
        if (cell.algorithm == "gjk")
            for (int i = 0; i < 9; ++i) cell.rounds.push_back({i, {1, 0, 0.8 + 0.001 * i, 0}, {1, 0, 1, 0}});
    const Claim claim = claim_of(data, "static_gjk_faster");
    EXPECT_EQ(claim.verdict, "reproduced") << claim.reason;
    EXPECT_THAT(claim.ours, HasSubstr("GJK over V-Clip 0.804 [0.801, 0.807]"));
}

TEST(Claims, SummaryCountsThem) {
    const std::vector<Claim> claims = judge_claims({});
    EXPECT_EQ(claims_summary(claims), std::to_string(claims.size()) +
                                          " claims: 0 reproduced, 0 not reproduced, 0 inconclusive, " +
                                          std::to_string(claims.size()) + " not measured");
}

TEST(Claims, GridHasARowForEachAndItsReason) {
    const ReportData data = all_cases()[3].make(1.2);
    const std::vector<Claim> claims = judge_claims(data);
    const TextGrid grid = claims_grid(data);
    ASSERT_EQ(grid.rows.size(), claims.size());
    for (std::size_t i = 0; i < claims.size(); ++i) {
        ASSERT_EQ(grid.rows[i].size(), grid.columns.size());
        EXPECT_EQ(grid.rows[i][4].text, claims[i].verdict);
        EXPECT_EQ(grid.rows[i][4].why, claims[i].verdict == "not measured" ? claims[i].reason : "");
    }
    EXPECT_EQ(grid.caption, claims_summary(claims));
}

}  // namespace
}  // namespace edgewise::reports
