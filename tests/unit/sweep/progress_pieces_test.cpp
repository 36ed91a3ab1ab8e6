// SPDX-License-Identifier: MIT
//
// Progress against the truth: deviations computed by hand, and against a walk in small steps.
#include "edgewise/sweep/progress_pieces.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "edgewise/scene/rng.hpp"

namespace edgewise::sweep {
namespace {

TEST(ProgressPieces, DoNotDeviateWhereOnlyTheMachineIsAnother) {
    const std::vector<ProgressPiece> pieces = {{"a", 1, 3}, {"b", 2, 6}, {"c", 0.5, 1.5}};
    EXPECT_NEAR(worst_deviation(pieces, 0.1).relative, 0, 1e-15);
    EXPECT_EQ(worst_deviation({}, 0.1).relative, 0);
}

TEST(ProgressPieces, DeviateWhereThePartsDo) {
    // Half of the work is shown as done after a quarter of the time, and at a tenth as much too soon.
    const std::vector<ProgressPiece> early = {{"a", 1, 1}, {"b", 1, 3}};
    EXPECT_NEAR(worst_deviation(early, 0.1).relative, 1, 1e-15);
    const std::vector<ProgressPiece> late = {{"a", 1, 3}, {"b", 1, 1}};
    EXPECT_NEAR(worst_deviation(late, 0.1).relative, 0.5 / 0.75 - 1, 1e-15);
    EXPECT_NEAR(worst_deviation(late, 0.9).relative, (0.5 + 0.5 * 0.6) / 0.9 - 1, 1e-15);
    EXPECT_NEAR(worst_deviation(late, 0.9).at, 0.9, 1e-15);
}

/// What is far off before the share that counts does not count.
TEST(ProgressPieces, LeaveTheBeginningOut) {
    const std::vector<ProgressPiece> pieces = {{"a", 9, 0.5}, {"b", 1, 9.5}, {"c", 90, 90}};
    EXPECT_NEAR(worst_deviation(pieces, 0.1).relative, 0, 1e-12);
    EXPECT_GT(worst_deviation(pieces, 0.001).relative, 10);
}

/// Any sequence against a walk in steps of a thousandth of the time.
TEST(ProgressPieces, AreAsWorstAsAWalkInSmallSteps) {
    scene::Rng rng(17);
    double worst_difference = 0;
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<ProgressPiece> pieces;
        double expected = 0, took = 0;
        for (int i = 0; i < 12; ++i) {
            pieces.push_back({"", rng.uniform(0, 2), rng.uniform(0.2, 2)});
            expected += pieces.back().expected;
            took += pieces.back().took;
        }
        double walked = 0;
        for (int step = 100; step <= 1000; ++step) {
            double shown = 0, left = step / 1000.0 * took;
            for (const ProgressPiece& piece : pieces) {
                const double part = std::min(1.0, std::max(0.0, left) / piece.took);
                shown += part * piece.expected;
                left -= piece.took;
            }
            walked = std::max(walked, std::abs(shown / expected / (step / 1000.0) - 1));
        }
        const double computed = std::abs(worst_deviation(pieces, 0.1).relative);
        EXPECT_LE(walked, computed + 1e-12);
        worst_difference = std::max(worst_difference, computed - walked);
    }
    EXPECT_LT(worst_difference, 0.05) << "the walk misses an end of a piece by less than a step";
}

TEST(ProgressPieces, ComeBackFromAStore) {
    const std::vector<ProgressPiece> first = {{"verify", 1.5, 3.25}, {"rounds", 2, 4}},
                                     second = {{"run", 7, 8}};
    const std::vector<std::pair<std::string, std::string>> meta = {
        {"build", "x"},
        {progress_key(2, "cold cube8"), progress_value(first)},
        {progress_key(10, "stability"), progress_value(second)},
        {progress_key(11, "damaged"), "no JSON"}};
    const auto pieces = progress_pieces(meta);
    ASSERT_EQ(pieces.size(), 3U);
    EXPECT_LT(meta[1].first, meta[2].first) << "keys in the order of places";
    EXPECT_EQ(pieces[0].what, "cold cube8: verify");
    EXPECT_EQ(pieces[0].expected, 1.5);
    EXPECT_EQ(pieces[1].took, 4);
    EXPECT_EQ(pieces[2].what, "stability: run");
}

}  // namespace
}  // namespace edgewise::sweep
