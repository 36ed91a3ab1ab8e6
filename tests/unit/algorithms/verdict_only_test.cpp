// SPDX-License-Identifier: MIT
//
// A verdict alone is the verdict of the whole answer, whatever the scene, and so is the side of a cutoff; GJK
// takes fewer steps to either. Distances up to the cutoff are those of the whole answer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/layouts/aos.hpp"
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

/// The queries of a scene, each pair with its cache.
std::vector<Distance> ask_all(const scene::Workload& workload, const QueryOptions& options) {
    using Table = aos<f64>;
    const Table table(workload.bodies[0], Parts::support);
    std::vector<SimplexPair<Table, Table>> pairs(workload.pair_count, {table, table});
    std::vector<Distance> answers;
    for (const scene::Query& query : workload.queries)
        answers.push_back(
            Gjk::query(table, table, relative_pose(query.pose_a, query.pose_b), pairs[query.pair], options));
    return answers;
}

TEST(Cutoff, EndsBeyondItAndNowhereElse) {
    for (const char* shape : {"cube8", "sphere38", "sphere386"}) {
        const studies::SingleCell cell({"aos_f64", "gjk", "tumble", shape, {}, queries, 1});
        const auto whole = ask_all(cell.workload(), {}), answers = ask_all(cell.workload(), {.cutoff = 0.5});
        int beyond = 0, within = 0, steps = 0, whole_steps = 0;
        double worst = 0;
        for (std::size_t i = 0; i < whole.size(); ++i) {
            const bool is_beyond = whole[i].distance > 0.5;
            ++(is_beyond ? beyond : within);
            ASSERT_EQ(answers[i].distance > 0.5, is_beyond) << i;
            ASSERT_EQ(answers[i].status, whole[i].status) << i;
            steps += answers[i].steps;
            whole_steps += whole[i].steps;
            if (!is_beyond) worst = std::max(worst, std::abs(answers[i].distance - whole[i].distance));
        }
        std::printf("%s: %d beyond, %d within, off by %.2g; %d steps for %d\n", shape, beyond, within, worst,
                    steps, whole_steps);
        EXPECT_GT(std::min(beyond, within), 500);
        EXPECT_LT(worst, 1e-14);
        EXPECT_LT(steps, whole_steps);
    }
}

}  // namespace
}  // namespace edgewise
