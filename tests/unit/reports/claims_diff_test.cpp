// SPDX-License-Identifier: MIT
//
// Two stores beside each other: only claims whose verdict differs are named, with both sides' figures.
#include "edgewise/reports/paper/claims/claims_diff.hpp"

#include <gmock/gmock.h>

#include <map>
#include <nlohmann/json.hpp>

#include "claim_cases.hpp"

namespace edgewise::reports {
namespace {

using testing::HasSubstr;

std::map<std::string, std::string> verdicts_of(const ReportData& data) {
    std::map<std::string, std::string> verdicts;
    for (const Claim& claim : judge_claims(data)) verdicts[claim.id] = claim.verdict;
    return verdicts;
}

void expect_only_differing(const ClaimCase& one) {
    const ReportData met = one.make(one.reproduced), missed = one.make(one.not_reproduced);
    auto expected = verdicts_of(met);
    const auto other = verdicts_of(missed);
    std::erase_if(expected, [&](const auto& verdict) { return other.at(verdict.first) == verdict.second; });
    std::map<std::string, std::string> found;
    for (const auto& [a, b] : differing_claims(met, missed)) {
        EXPECT_EQ(a.id, b.id);
        EXPECT_EQ(b.verdict, other.at(b.id));
        found[a.id] = a.verdict;
    }
    EXPECT_EQ(found, expected) << one.id;
    EXPECT_TRUE(found.contains(one.id)) << one.id;
}

/// Of every claim with a case, the data that meet its rule beside those that miss it.
TEST(ClaimsDiff, NamesTheClaimsWhoseVerdictDiffersAndNoOthers) {
    for (const auto& cases : {speed_cases(), count_cases(), memory_cases()})
        for (const ClaimCase& one : cases) expect_only_differing(one);
}

TEST(ClaimsDiff, OfAStoreAndItselfIsEmpty) {
    const ClaimCase one = speed_cases().front();
    const ReportData data = one.make(one.reproduced);
    const StoreDifference none = claims_diff(data, data, false);
    EXPECT_FALSE(none.differs);
    EXPECT_THAT(none.text, testing::StartsWith("0 of "));
    EXPECT_TRUE(nlohmann::json::parse(claims_diff(data, data, true).text)["differing"].empty());
}

TEST(ClaimsDiff, ShowsBothSidesFiguresInWordsAndAsJson) {
    const ClaimCase one = speed_cases().front();
    const ReportData met = one.make(one.reproduced), missed = one.make(one.not_reproduced);
    const auto differing = differing_claims(met, missed);
    ASSERT_FALSE(differing.empty());
    const StoreDifference words = claims_diff(met, missed, false), json = claims_diff(met, missed, true);
    EXPECT_TRUE(words.differs && json.differs);
    const auto rows = nlohmann::json::parse(json.text)["differing"];
    ASSERT_EQ(rows.size(), differing.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto& [a, b] = differing[i];
        EXPECT_EQ(rows[i]["id"], a.id);
        EXPECT_EQ(rows[i]["first"]["verdict"], a.verdict);
        EXPECT_EQ(rows[i]["second"]["verdict"], b.verdict);
        EXPECT_EQ(rows[i]["first"]["ours"], a.ours);
        EXPECT_EQ(rows[i]["second"]["ours"], b.ours);
        EXPECT_THAT(words.text, HasSubstr("first: " + a.verdict + "; here: " + a.ours));
        EXPECT_THAT(words.text, HasSubstr("second: " + b.verdict));
    }
    EXPECT_EQ(words.text, claims_diff(met, missed, false).text);
}

}  // namespace
}  // namespace edgewise::reports
