// SPDX-License-Identifier: MIT
//
// What a recommendation rests on: the errors of all its scenes, and cells that were measured.
#include <gmock/gmock.h>

#include <iterator>
#include <nlohmann/json.hpp>

#include "answer_cells.hpp"
#include "edgewise/reports/answer/answer.hpp"
#include "edgewise/reports/answer/answer_json.hpp"
#include "edgewise/reports/answer/answer_text.hpp"

namespace edgewise::reports {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const TimedCell contest_paper{"vclip", "aos", "f64", {0.98, 1.0, 1.02}},
    contest_lean{"vclip", "lean", "f32", {0.70, 0.72, 0.74}, 1e-7, 8.8},
    contest_gjk{"gjk", "lean", "f64", {1.4, 1.5, 1.6}, 1e-15, 12.8},
    contest_small{"vclip", "lean", "f64", {2.4, 2.5, 2.6}, 1e-16, 12.8};

/// Over every scene that the sentence speaks of, not that in which the layout does best.
TEST(Answer, TheWorstErrorIsTheLargestOfAllScenesOfTheSentence) {
    ReportData data;
    const double errors[] = {9.6e-8, 1.46e-7, 1.2e-7};
    for (std::size_t i = 0; i < std::size(errors); ++i) {
        TimedCell lean = contest_lean;
        lean.error = errors[i];
        lean.ratios = i == 1 ? std::vector<double>{1.7, 1.8, 1.9} : contest_lean.ratios;
        for (const TimedCell& made : {contest_paper, lean, contest_gjk})
            data.cells.push_back(answer_cell(made, R"({"bodies":)" + std::to_string(10 + i) + "}"));
    }
    const Answer answer = answer_of(data);
    const auto take = recommendation_of(answer.shared);
    ASSERT_TRUE(take && take->worst_error);
    EXPECT_EQ(take->table, "lean_f32");
    EXPECT_EQ(*take->worst_error, 1.46e-7);
    EXPECT_THAT(answer_paragraph(answer, data), HasSubstr("worst error 1.5e-07"));
    const nlohmann::json json = answer_json(answer);
    EXPECT_EQ(json["take"]["error"], 1.46e-7);
    EXPECT_THAT(
        json["changes_it"].get<std::vector<std::string>>(),
        testing::Contains(HasSubstr("an error below 1.5e-07 asked for: V-Clip on lean_f32 is dropped")));
}

/// V-Clip and GJK, each on a small and on a fast layout; without one of them nothing is recommended, and the
/// sentence says which and how to measure it.
TEST(Answer, NothingIsRecommendedWithoutSmallAndFastCells) {
    const TimedCell big_gjk{"gjk", "aos", "f64", {0.8, 0.81, 0.82}, 1e-15, 90},
        small_gjk{"gjk", "points_soa", "f32", {1.8, 1.9, 2}, 1e-7, 4.1}, big_vclip = contest_paper,
                                                                         small_vclip = contest_small;
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
        const std::string text = answer_paragraph(answer, data);
        const bool complete = left_out == needed.size();
        EXPECT_EQ(recommendation_of(answer.own).has_value(), complete) << left_out;
        EXPECT_TRUE(recommendation_of(answer.shared)) << left_out;
        if (complete) {
            EXPECT_THAT(text, Not(HasSubstr("nothing is recommended")));
            continue;
        }
        EXPECT_THAT(answer.own.front().not_measured, ElementsAre(needed[left_out].second));
        EXPECT_THAT(text, HasSubstr("If every body has a table of its own, nothing is recommended."));
        EXPECT_THAT(text, HasSubstr(needed[left_out].second));
        EXPECT_THAT(text, HasSubstr("edgewise advise --vertices 386 --own-tables --error 1e-6"));
        EXPECT_TRUE(answer_json(answer_of(data, {.own_tables = true}))["take"].is_null());
    }
}

}  // namespace
}  // namespace edgewise::reports
