// SPDX-License-Identifier: MIT
//
// Synthetic report data gives every possible verdict of every claim. A missing figure is never shown as a
// number, and no claim has a verdict without a rule. A comparison of the claims of two stores lists only
// claims with different verdicts as changed, with the figures of both stores.
#include "edgewise/reports/paper/claims/claims.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <set>

#include "claim_cases.hpp"
#include "edgewise/measure/record/comparison.hpp"
#include "edgewise/reports/paper/claims/claim_rules.hpp"

namespace edgewise::reports {
namespace {

using testing::HasSubstr;

std::vector<ClaimCase> all_cases() {
    std::vector<ClaimCase> all = speed_cases();
    for (const auto& more : {count_cases(), memory_cases()}) all.insert(all.end(), more.begin(), more.end());
    return all;
}

ClaimCase case_of(const std::string& id) {
    for (const ClaimCase& one : all_cases())
        if (one.id == id) return one;
    ADD_FAILURE() << "no case " << id;
    return {};
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

TEST(EveryClaim, IsReproducedOrNotAsItsRuleSaysAndNotMeasuredForTheStoredReason) {
    for (const ClaimCase& one : all_cases()) {
        SCOPED_TRACE(one.id);
        const Claim met = claim_of(one.make(one.reproduced), one.id);
        EXPECT_EQ(met.verdict, one.identifiable ? "reproduced" : "consistent, not identifiable")
            << met.reason;
        EXPECT_EQ(met.reason == "", one.identifiable);
        EXPECT_NE(met.ours, "");
        const Claim missed = claim_of(one.make(one.not_reproduced), one.id);
        EXPECT_EQ(missed.verdict, "not reproduced") << missed.ours;
        EXPECT_THAT(missed.reason, HasSubstr("because "));
        EXPECT_NE(missed.ours, "");
        ReportData data = one.make(one.reproduced);
        change_cells(data, [](ReportCell& cell) {
            for (store::FigureRow& figure : cell.figures)
                figure.value.reset(), figure.reason = "made to be missing";
        });
        const Claim missing = claim_of(data, one.id);
        EXPECT_EQ(missing.verdict, "not measured") << missing.ours;
        EXPECT_THAT(missing.reason, HasSubstr("made to be missing"));
    }
}

TEST(Claims, AreInconclusiveWhereTheIntervalStraddlesTheRule) {
    // Times without a stored interval; page faults.
    std::set<std::string> without_interval = {"step_linear_in_bodies", "swapping_spares_gjk",
                                              "swapping_explains_figure_8"};
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
        change_cells(data, [](ReportCell& cell) {
            cell.status = store::CellStatus::failed, cell.reason = "wrong verdicts";
        });
        if (!data.stability.empty() || one.id == "zero_failures_control") continue;
        EXPECT_NE(claim_of(data, one.id).verdict, "reproduced") << one.id;
    }
}

TEST(Claims, HaveCasesAndSayWhatTheyAreWhateverTheStore) {
    std::set<std::string> with_cases, ids;
    for (const ClaimCase& one : all_cases()) with_cases.insert(one.id);
    for (const Claim& claim : judge_claims({})) {
        EXPECT_TRUE(ids.insert(claim.id).second) << claim.id;
        for (const std::string& text :
             {claim.section, claim.claim, claim.paper, claim.unit, claim.rule, claim.reason})
            EXPECT_NE(text, "") << claim.id;
        EXPECT_THAT(claim.rule, HasSubstr("Wanted: ")) << claim.id;
        EXPECT_THAT(claim.rule, testing::Not(HasSubstr("Wanted: ."))) << claim.id;
        EXPECT_EQ(claim.verdict, "not measured") << claim.id << ": " << claim.ours;
    }
    EXPECT_EQ(ids, with_cases);
    EXPECT_GE(ids.size(), 40u);
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
TEST(Claims, ThatDependOnTheTimeStepSaySo) {
    ReportData data;
    add_angular_time(data, 38, "vclip", 1);
    add_angular(data, 38, "gjk", [](int number) { return made_time(number < 4 ? 0.5 : 2); });
    const Claim claim = claim_of(data, "angular_vclip_faster_38");
    EXPECT_EQ(claim.verdict, "depends on: time step");
    EXPECT_THAT(claim.reason, HasSubstr("the paper does not name its time step"));
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
    ReportData data = case_of("angular_vclip_faster_8").make(1.3);
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
    data.cells.back().status = store::CellStatus::failed;
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
    ReportData data = case_of("static_gjk_faster").make(1.2);
    for (ReportCell& cell : data.from_files)
        if (cell.algorithm == "gjk")
            for (int i = 0; i < 9; ++i) cell.rounds.push_back({i, {1, 0, 0.8 + 0.001 * i, 0}, {1, 0, 1, 0}});
    const Claim claim = claim_of(data, "static_gjk_faster");
    EXPECT_EQ(claim.verdict, "reproduced") << claim.reason;
    EXPECT_THAT(claim.ours, HasSubstr("tetra4: V-Clip over GJK 1.24 [1.24, 1.25]"));
}

/// GJK faster on three bodies, slower on the smallest.
TEST(Claims, OfOneAverageAreJudgedBodyByBody) {
    ReportData data;
    for (const int vertices : {4, 8, 38, 386}) {
        add_cell(data, {"paper_static", made_shape(vertices), "vclip"}, made_time(1));
        add_cell(data, {"paper_static", made_shape(vertices), "gjk"}, made_time(vertices == 4 ? 2 : 0.5));
    }
    const Claim claim = claim_of(data, "static_gjk_faster");
    EXPECT_EQ(claim.verdict, "depends on: body");
    EXPECT_THAT(claim.reason, HasSubstr("tetra4 not reproduced"));
    EXPECT_THAT(claim.reason, HasSubstr("sphere386 reproduced"));
}

/// An undecided part decides, whatever the others say.
TEST(Claims, OfVariantsAreAsUndecidedAsTheLeastDecided) {
    const auto judged = [](const Evidence& first, const Evidence& second) {
        const WantedBand wanted{std::nextafter(1.0, 2.0), 1e9, "more than 1"};
        return judge_variants({}, "body",
                              {{"one", {{"ratio", first, wanted}}}, {"two", {{"ratio", second, wanted}}}})
            .verdict;
    };
    const Evidence met = exact_evidence(2), missed = exact_evidence(0.5),
                   straddling = interval_evidence(1, 0.9, 1.1), none = no_evidence("none");
    EXPECT_EQ(judged(met, met), "reproduced");
    EXPECT_EQ(judged(missed, missed), "not reproduced");
    EXPECT_EQ(judged(met, missed), "depends on: body");
    EXPECT_EQ(judged(straddling, missed), "inconclusive");
    EXPECT_EQ(judged(straddling, none), "not measured");
    EXPECT_EQ(judged(none, missed), "not measured");
}

TEST(Claims, ComeByKindAndSayWhereTheyHold) {
    ReportData data = case_of("static_gjk_faster").make(1.2);
    data.build.machine_json = R"({"cpu":{"name":"A processor"},"caches":[{"level":1,"bytes":32768},)"
                              R"({"level":2,"bytes":524288},{"level":3,"bytes":33554432}]})";
    data.build.compiler = "cc 1";
    for (ReportCell& cell : data.from_files) cell.seed = 7;
    std::vector<std::string> kinds;
    for (const Claim& claim : judge_claims(data)) {
        if (kinds.empty() || kinds.back() != claim.kind) kinds.push_back(claim.kind);
        EXPECT_EQ(claim.conditions,
                  claim.deterministic
                      ? "for seed 7, on any machine"
                      : "for seed 7, on this machine: A processor, L2 512 KiB, L3 32 MiB; cc 1");
    }
    EXPECT_EQ(kinds, (std::vector<std::string>{"primary", "mechanism", "background"}));
    data.build.machine_json = R"({"caches": [7, {"level": "2", "bytes": 1}, {"level": 3, "bytes": "x"},)"
                              R"({"level": 2, "bytes": 0}, {"level": -2, "bytes": 1}]})";
    for (const Claim& claim : judge_claims(data)) EXPECT_THAT(claim.conditions, Not(HasSubstr(", L")));
}

/// Queries that two table types and two algorithms share count as one sample.
TEST(Claims, CountIndependentQueriesOnce) {
    ReportData data;
    for (const std::string table : {"aos_f64", "lean_f64"})
        for (const std::string& algorithm : both_algorithms)
            data.cells.push_back(make_cell({"static", "cube8", algorithm, "", 0, table},
                                           {{"error.wrong_verdicts", 0}, {"error.checked", 1e5}}));
    data.cells.push_back(
        make_cell({"static", "tetra4", "gjk"}, {{"error.wrong_verdicts", 0}, {"error.checked", 1e5}}));
    const Claim claim = claim_of(data, "zero_failures_exact");
    EXPECT_THAT(claim.ours, HasSubstr("answers checked 500000"));
    EXPECT_THAT(claim.ours, HasSubstr("independent queries 200000"));
    EXPECT_THAT(claim.ours, HasSubstr("[0, 1.5e-05]"));
}

TEST(Claims, SummaryNamesPrimaryFindingsByVerdict) {
    const std::vector<Claim> claims = judge_claims({});
    const std::string summary = claims_summary(claims);
    EXPECT_THAT(summary, testing::StartsWith("Primary findings not measured: "));
    for (const Claim& claim : claims)
        EXPECT_EQ(summary.find(claim.id) != summary.npos, claim.kind == "primary") << claim.id;
}

TEST(Claims, GridHasARowForEachAndItsReason) {
    const ReportData data = case_of("static_gjk_faster").make(1.2);
    const std::vector<Claim> claims = judge_claims(data);
    const TextGrid grid = claims_grid(data);
    ASSERT_EQ(grid.rows.size(), claims.size());
    for (std::size_t i = 0; i < claims.size(); ++i) {
        ASSERT_EQ(grid.rows[i].size(), grid.columns.size());
        EXPECT_EQ(grid.rows[i][5].text, claims[i].verdict);
        EXPECT_EQ(grid.rows[i][5].why, claims[i].verdict == "not measured" ? claims[i].reason : "");
    }
    EXPECT_EQ(grid.caption, claims_summary(claims));
}

using measure::ComparedRow;
using measure::Outcome;
using Verdicts = std::map<std::string, std::pair<std::string, std::string>>;

Verdicts differing_verdicts(const ReportData& first, const ReportData& second) {
    const std::vector<Claim> before = judge_claims(first), after = judge_claims(second);
    Verdicts differing;
    for (std::size_t i = 0; i < before.size(); ++i)
        if (before[i].verdict != after[i].verdict)
            differing[before[i].id] = {before[i].verdict, after[i].verdict};
    return differing;
}

Verdicts changed_rows(const measure::RecordComparison& found) {
    Verdicts changed;
    for (const ComparedRow& row : found.rows)
        if (row.outcome != Outcome::equal) changed[row.is.cell] = {row.was.text, row.is.text};
    return changed;
}

/// Compares, for every claim with a case, the data that meet its rule with the data that miss it.
TEST(ClaimsRecord, DiffersInTheClaimsWhoseVerdictDiffersAndNoOthers) {
    for (const auto& cases : {speed_cases(), count_cases(), memory_cases()}) {
        for (const ClaimCase& one : cases) {
            const ReportData met = one.make(one.reproduced), missed = one.make(one.not_reproduced);
            const auto found = compare(claims_record(met), claims_record(missed));
            EXPECT_EQ(changed_rows(found), differing_verdicts(met, missed)) << one.id;
            EXPECT_TRUE(changed_rows(found).contains(one.id)) << one.id;
            EXPECT_EQ(found.exit_code(), 1) << one.id;
        }
    }
}

TEST(ClaimsRecord, ShowsBothSidesFigures) {
    const ClaimCase one = speed_cases().front();
    const ReportData met = one.make(one.reproduced), missed = one.make(one.not_reproduced);
    EXPECT_EQ(compare(claims_record(met), claims_record(met)).exit_code(), 0);
    const std::string text = to_text(compare(claims_record(met), claims_record(missed)), "mine.db");
    for (const ReportData* data : {&met, &missed})
        for (const Claim& claim : judge_claims(*data))
            EXPECT_TRUE(claim.id != one.id || text.find(claim.ours) != text.npos) << claim.ours;
}

}  // namespace

}  // namespace edgewise::reports
