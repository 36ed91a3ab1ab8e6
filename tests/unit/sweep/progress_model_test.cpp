// SPDX-License-Identifier: MIT
//
// The model of a sweep's progress beside what groups took: plan quick on a machine of two cores (AMD EPYC,
// nothing else running), in the order in which they ran, and the stability run after them.
#include <gtest/gtest.h>

#include <cmath>

#include "edgewise/studies/parts/expected_seconds.hpp"
#include "edgewise/sweep/expected_work.hpp"
#include "edgewise/sweep/progress_pieces.hpp"

namespace edgewise::sweep {
namespace {

struct RecordedGroup {
    const char* scene;
    scene::SceneParameters parameters;
    const char* shape;
    std::size_t queries, cells;
    bool caches;  ///< whether four machines' were modelled
    double seconds;
};

const std::vector<RecordedGroup> recorded = {
    {"static", {}, "tetra4", 3000, 31, false, 1.4},
    {"static", {}, "cube8", 3000, 31, false, 1.634},
    {"static", {}, "sphere38", 3000, 31, false, 2.918},
    {"static", {}, "sphere386", 3000, 31, false, 8.014},
    {"cold", {}, "tetra4", 3000, 31, false, 1.161},
    {"cold", {}, "cube8", 3000, 31, false, 1.241},
    {"cold", {}, "sphere38", 3000, 31, false, 1.956},
    {"cold", {}, "sphere386", 3000, 31, false, 5.424},
    {"tumble", {{"rotation_step", 0.01}}, "tetra4", 3000, 31, false, 0.51},
    {"tumble", {{"rotation_step", 0.01}}, "cube8", 3000, 31, false, 0.556},
    {"tumble", {{"rotation_step", 0.01}}, "sphere38", 3000, 31, false, 0.708},
    {"tumble", {{"rotation_step", 0.01}}, "sphere386", 3000, 31, false, 1.072},
    {"tumble", {{"rotation_step", 0.1}}, "tetra4", 3000, 31, false, 0.595},
    {"tumble", {{"rotation_step", 0.1}}, "cube8", 3000, 31, false, 0.722},
    {"tumble", {{"rotation_step", 0.1}}, "sphere38", 3000, 31, false, 0.915},
    {"tumble", {{"rotation_step", 0.1}}, "sphere386", 3000, 31, false, 2.391},
    {"tumble", {{"rotation_step", 1}}, "tetra4", 3000, 31, false, 1.066},
    {"tumble", {{"rotation_step", 1}}, "cube8", 3000, 31, false, 1.582},
    {"tumble", {{"rotation_step", 1}}, "sphere38", 3000, 31, false, 2.014},
    {"tumble", {{"rotation_step", 1}}, "sphere386", 3000, 31, true, 27.657},
    {"tumble",
     {{"rotation_step", 0.1}, {"bodies", 100}, {"in_time_order", 1}},
     "sphere386",
     3000,
     31,
     true,
     20.224},
    {"pressure", {{"bodies", 600}}, "sphere386", 1198, 8, true, 9.148},
    {"pressure", {{"bodies", 6000}}, "sphere386", 11998, 2, false, 10.31}};

constexpr double stability_rows = 899, stability_cases = 20, stability_took = 7.852;

SweepWork recorded_work() {
    Plan plan;
    plan.queries = 3000;
    plan.checked = 200;
    plan.rounds = 17;
    plan.traced = 1000;
    plan.machines = {"pentium3_coppermine", "skylake_sp", "zen5", "pentium3_katmai"};
    plan.shapes = {"tetra4", "cube8", "sphere38", "sphere386"};
    plan.layouts = {"aos_f64"};
    plan.algorithms = {"vclip"};
    for (const RecordedGroup& group : recorded) {
        SceneChoice& scene = plan.scenes.emplace_back();
        scene.name = group.scene;
        scene.parameters = group.parameters;
        scene.shapes = {group.shape};
        scene.queries = group.queries;
        if (group.caches) scene.caches = {group.shape};
    }
    return prepare_sweep(plan, [](const std::string&) {});
}

std::vector<ProgressPiece> modelled_pieces() {
    const SweepWork work = recorded_work();
    std::vector<ProgressPiece> pieces;
    for (std::size_t i = 0; i < recorded.size(); ++i) {
        const SceneWork& scene = work.scenes[i];
        const double expected =
            modelled_work(work.plan, scene, *scene.shapes.front(), recorded[i].cells, 2).all();
        std::printf("%-8s %-9s expected %6.2f, took %6.2f\n", recorded[i].scene, recorded[i].shape, expected,
                    recorded[i].seconds);
        pieces.push_back({recorded[i].scene, expected, recorded[i].seconds});
    }
    pieces.push_back(
        {"stability", stability_rows * stability_cases * studies::stability_case_seconds, stability_took});
    return pieces;
}

TEST(ProgressModel, IsWithinAFifthOfTheTruthFromATenthOfTheTimeOn) {
    const ProgressDeviation worst = worst_deviation(modelled_pieces(), 0.1);
    std::printf("off by %+.1f %% at %.0f %% of the time\n", 100 * worst.relative, 100 * worst.at);
    EXPECT_LE(std::abs(worst.relative), 0.2);
}

/// What the model is for: by cells, as many would be done after a third of the time as are after all of it.
TEST(ProgressModel, IsNotWhatCountingCellsWouldSay) {
    std::vector<ProgressPiece> pieces = modelled_pieces();
    for (std::size_t i = 0; i < recorded.size(); ++i)
        pieces[i].expected = static_cast<double>(recorded[i].cells);
    pieces.back().expected = stability_rows;
    EXPECT_GT(std::abs(worst_deviation(pieces, 0.1).relative), 0.5);
}

/// Groups one by one: what takes long is known to a third.
TEST(ProgressModel, KnowsTheLongGroups) {
    const std::vector<ProgressPiece> pieces = modelled_pieces();
    for (const ProgressPiece& piece : pieces) {
        if (piece.took < 2.5) continue;
        EXPECT_NEAR(piece.expected / piece.took, 1, 0.34) << piece.what;
    }
}

/// Twice the processors halve what is beside others, and nothing else.
TEST(ProgressModel, SharesTracesAmongProcessors) {
    const SweepWork work = recorded_work();
    const SceneWork& scene = work.scenes[19];
    const GroupWork two = modelled_work(work.plan, scene, *scene.shapes.front(), 31, 2),
                    four = modelled_work(work.plan, scene, *scene.shapes.front(), 31, 4);
    EXPECT_DOUBLE_EQ(two.beside, 2 * four.beside);
    EXPECT_EQ(two.rounds, four.rounds);
    EXPECT_EQ(two.verify, four.verify);
    EXPECT_GT(two.beside, two.rounds) << "caches of four machines";
}

}  // namespace
}  // namespace edgewise::sweep
