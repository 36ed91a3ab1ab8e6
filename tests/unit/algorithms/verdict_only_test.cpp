// SPDX-License-Identifier: MIT
//
// A verdict alone is the verdict of the whole answer, whatever the scene, and GJK takes fewer steps to it.
#include <gtest/gtest.h>

#include <cstdio>

#include "edgewise/studies/single_cell.hpp"

namespace edgewise {
namespace {

constexpr std::size_t queries = 5000;

struct Steps {
    std::uint64_t whole = 0, verdict = 0;
    std::size_t apart = 0, within = 0;  ///< separated answers; answers at a distance that counts as contact
};

Steps compare(const char* algorithm, const char* scene, double tolerance) {
    const studies::SingleCell cell({"aos_f64", algorithm, scene, "sphere38", {}, queries, 1});
    const auto quick = cell.type().make_runner(algorithm), full = cell.type().make_runner(algorithm);
    full->configure({.query = {.contact_tolerance = tolerance}});
    quick->configure({.query = {.contact_tolerance = tolerance}, .needs = Needs::verdict});
    EXPECT_EQ(quick->load(cell.workload()) + full->load(cell.workload()), "");
    const auto whole = full->answer(), verdicts = quick->answer();
    Steps steps;
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        const bool separated = whole[i].status == Status::separated;
        wrong += separated != (verdicts[i].status == Status::separated);
        steps.apart += separated;
        steps.within += !separated && whole[i].distance > 0;
        // But for the rounding of coordinates, which are about 1.
        if (separated) {
            EXPECT_GE(verdicts[i].distance, whole[i].distance * (1 - 1e-12) - 2e-15) << "an upper bound";
        }
        steps.whole += static_cast<std::uint64_t>(whole[i].steps);
        steps.verdict += static_cast<std::uint64_t>(verdicts[i].steps);
    }
    EXPECT_EQ(wrong, 0U) << algorithm << " " << scene << ", tolerance " << tolerance;
    return steps;
}

TEST(VerdictOnly, IsTheVerdictOfTheWholeAnswer) {
    for (const char* scene : {"cold", "static", "tumble"}) {
        const Steps gjk = compare("gjk", scene, 0), vclip = compare("vclip", scene, 0);
        std::printf("%s: gjk %lu steps for answers, %lu for verdicts\n", scene,
                    static_cast<unsigned long>(gjk.whole), static_cast<unsigned long>(gjk.verdict));
        for (const Steps& steps : {gjk, vclip}) {
            EXPECT_GT(steps.apart, queries / 4);
            EXPECT_LT(steps.apart, queries);
        }
        EXPECT_LT(gjk.verdict, gjk.whole);
        EXPECT_EQ(vclip.verdict, vclip.whole) << "V-Clip knows its verdict last";
    }
}

/// A direction that separates the bodies by less than what counts as contact ends nothing.
TEST(VerdictOnly, IsBeyondTheContactTolerance) {
    for (const double tolerance : {0.05, 0.3, 1.0}) {
        const Steps steps = compare("gjk", "cold", tolerance);
        std::printf("tolerance %g: %zu within\n", tolerance, steps.within);
        EXPECT_GT(steps.within, 0U) << tolerance;
        EXPECT_LT(steps.verdict, steps.whole) << tolerance;
    }
}

}  // namespace
}  // namespace edgewise
