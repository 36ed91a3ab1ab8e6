// SPDX-License-Identifier: MIT
//
// The look inside GJK: what must hold of its counts, in scenes where the answer is known.
#include "edgewise/sweep/watch_algorithm.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "edgewise/scene/shapes.hpp"
#include "edgewise/studies/single_cell.hpp"

namespace edgewise {
namespace {

measure::AlgorithmWork look(const char* scene, const char* shape, const scene::SceneParameters& parameters,
                            const char* algorithm = "gjk") {
    const studies::CellChoice choice{"aos_f64", algorithm, scene, shape, parameters, 2000, 1};
    const studies::SingleCell cell(choice);
    sweep::Plan plan;
    plan.queries = 2000;
    plan.checked = 300;
    const scene::NamedShape body{shape, "built-in", *scene::make_shape(shape), {}};
    const sweep::SharedQueries shared(plan, sweep::SceneChoice{scene, parameters}, body);
    return sweep::algorithm_work(algorithm, cell.type(), shared);
}

void expect_sound(const measure::AlgorithmWork& work) {
    EXPECT_GT(work.queries, 0U);
    EXPECT_LE(work.kept, work.near);
    EXPECT_LE(work.near, work.kept_of);
    EXPECT_EQ(work.accepted[0] + work.accepted[1] + work.accepted[2] + work.accepted[3], work.sub_distances);
    EXPECT_GE(work.subsets_tried, work.sub_distances);
    EXPECT_LE(work.subsets_tried, 15 * work.sub_distances);
    EXPECT_LE(work.same_features, work.compared);
}

TEST(WatchAlgorithm, NothingMovesInAStillScene) {
    const measure::AlgorithmWork work =
        look("tumble", "sphere386", {{"rotation_step", 0}, {"translation_step", 0}, {"steps", 1000}});
    expect_sound(work);
    EXPECT_GT(work.kept_of, 0U);
    EXPECT_EQ(work.kept, work.kept_of) << "the same simplex every time";
}

TEST(WatchAlgorithm, ClimbsFartherFromAnywhere) {
    const measure::AlgorithmWork coherent = look("tumble", "sphere386", {{"rotation_step", 0.01}});
    const measure::AlgorithmWork cold = look("cold", "sphere386", {});
    const measure::AlgorithmWork cold_large = look("cold", "sphere6146", {});
    expect_sound(coherent);
    expect_sound(cold);
    const auto hops = [](const measure::AlgorithmWork& w) {
        return static_cast<double>(w.hops) / static_cast<double>(w.supports);
    };
    std::printf("hops of a climb: coherent %.2f, cold %.2f, cold at 16 times the vertices %.2f\n",
                hops(coherent), hops(cold), hops(cold_large));
    EXPECT_LT(hops(coherent), hops(cold));
    EXPECT_LT(hops(cold), hops(cold_large));
    EXPECT_EQ(cold.kept_of, 0U) << "nothing is kept between cold queries";
    EXPECT_GT(cold.compared, 0U);
}

TEST(WatchAlgorithm, SaysWhyItDoesNotLook) {
    EXPECT_EQ(look("cold", "cube8", {}, "vclip").queries, 0U);
    EXPECT_FALSE(look("cold", "cube8", {}, "vclip").reason.empty());
}

}  // namespace
}  // namespace edgewise
