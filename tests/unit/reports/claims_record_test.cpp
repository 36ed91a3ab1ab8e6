// SPDX-License-Identifier: MIT
//
// Claims of two stores compared: only claims whose verdict differs are rows that changed, with both sides'
// figures.
#include <gmock/gmock.h>

#include <map>

#include "claim_cases.hpp"
#include "edgewise/measure/record/comparison.hpp"
#include "edgewise/reports/paper/claims/claims.hpp"

namespace edgewise::reports {
namespace {

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

/// Of every claim with a case, the data that meet its rule beside those that miss it.
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
