// SPDX-License-Identifier: MIT
//
// A verdict alone is the verdict of the whole answer, whatever the scene, and GJK takes fewer steps to it.
#include <gtest/gtest.h>

#include <cstdio>

#include "edgewise/studies/single_cell.hpp"

namespace edgewise {
namespace {

struct Steps {
    std::uint64_t whole = 0, verdict = 0;
};

Steps compare(const char* algorithm, const char* scene, const scene::SceneParameters& parameters) {
    const studies::SingleCell cell({"aos_f64", algorithm, scene, "sphere38", parameters, 5000, 1});
    const auto quick = cell.type().make_runner(algorithm);
    quick->configure({.needs = Needs::verdict});
    EXPECT_EQ(quick->load(cell.workload()), "");
    const auto whole = cell.runner().answer(), verdicts = quick->answer();
    Steps steps;
    std::size_t wrong = 0, apart = 0;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        const bool separated = whole[i].status == Status::separated;
        wrong += separated != (verdicts[i].status == Status::separated);
        apart += separated;
        if (separated) {
            EXPECT_GE(verdicts[i].distance, whole[i].distance * (1 - 1e-12)) << "an upper bound";
        }
        steps.whole += static_cast<std::uint64_t>(whole[i].steps);
        steps.verdict += static_cast<std::uint64_t>(verdicts[i].steps);
    }
    EXPECT_EQ(wrong, 0U) << algorithm << " " << scene;
    EXPECT_GT(apart, whole.size() / 4);
    EXPECT_LT(apart, whole.size());
    return steps;
}

TEST(VerdictOnly, IsTheVerdictOfTheWholeAnswer) {
    for (const char* scene : {"cold", "static", "tumble"}) {
        const Steps gjk = compare("gjk", scene, {}), vclip = compare("vclip", scene, {});
        std::printf("%s: gjk %lu steps for answers, %lu for verdicts\n", scene,
                    static_cast<unsigned long>(gjk.whole), static_cast<unsigned long>(gjk.verdict));
        EXPECT_LT(gjk.verdict, gjk.whole);
        EXPECT_EQ(vclip.verdict, vclip.whole) << "V-Clip knows its verdict last";
    }
}

/// A direction that separates the bodies by less than what counts as contact ends nothing.
TEST(VerdictOnly, IsBeyondTheContactTolerance) {
    const studies::SingleCell cell({"aos_f64", "gjk", "cold", "sphere38", {}, 3000, 1});
    for (const double tolerance : {0.05, 0.3, 1.0}) {
        const auto quick = cell.type().make_runner("gjk"), whole = cell.type().make_runner("gjk");
        whole->configure({.query = {.contact_tolerance = tolerance}});
        quick->configure({.query = {.contact_tolerance = tolerance}, .needs = Needs::verdict});
        EXPECT_EQ(quick->load(cell.workload()) + whole->load(cell.workload()), "");
        const auto expected = whole->answer(), verdicts = quick->answer();
        std::size_t wrong = 0, within = 0, sooner = 0;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            wrong += (expected[i].status == Status::separated) != (verdicts[i].status == Status::separated);
            within += expected[i].status != Status::separated && expected[i].distance > 0;
            sooner += verdicts[i].steps < expected[i].steps;
        }
        std::printf("tolerance %g: %zu of %zu within, %zu sooner\n", tolerance, within, expected.size(),
                    sooner);
        EXPECT_EQ(wrong, 0U) << tolerance;
        EXPECT_GT(within, 0U) << tolerance;
        EXPECT_GT(sooner, 0U) << tolerance;
    }
}

}  // namespace
}  // namespace edgewise
