// SPDX-License-Identifier: MIT
//
// Expected work of groups: what a store remembers as it is, the others by rules of thumb.
#include "edgewise/sweep/expected_work.hpp"

#include <gtest/gtest.h>

#include "edgewise/sweep/time_left.hpp"

namespace edgewise::sweep {
namespace {

SweepWork two_scenes() {
    Plan plan = make_plan("quick");
    plan.scenes = {{"cold"}, {"tumble"}};
    plan.scenes[1].caches = {"sphere386"};
    plan.shapes = {"tetra4", "sphere386"};
    plan.meshes.clear();
    return prepare_sweep(plan, [](const std::string&) {});
}

TEST(ExpectedWork, GrowsWithVerticesAndRounds) {
    SweepWork work = two_scenes();
    const auto groups = expected_work(work, [](const std::string&) { return std::nullopt; });
    ASSERT_EQ(groups.size(), 4U);
    for (const GroupWork& group : groups)
        for (const Step step : {Step::verify, Step::rounds, Step::alone}) EXPECT_GT(group.of(step), 0);
    EXPECT_GT(groups[1].all(), 2 * groups[0].all()) << "386 vertices against 4";
    EXPECT_EQ(groups[1].of(Step::trace), 0);
    EXPECT_GT(groups[3].of(Step::trace), groups[3].of(Step::rounds)) << "caches of four machines";
    work.plan.rounds *= 2;
    const auto longer = expected_work(work, [](const std::string&) { return std::nullopt; });
    EXPECT_DOUBLE_EQ(longer[0].of(Step::rounds), 2 * groups[0].of(Step::rounds));
    EXPECT_EQ(longer[0].of(Step::alone), groups[0].of(Step::alone));
}

TEST(ExpectedWork, IsNoneOfABodyThatThereIsNot) {
    SweepWork work = two_scenes();
    const scene::NamedShape missing{"foot", "foot.stl", {}, "foot.stl: no such file"};
    work.scenes[0].shapes.push_back(&missing);
    const auto groups = expected_work(work, [](const std::string&) { return std::optional(3.0); });
    ASSERT_EQ(groups.size(), 5U);
    EXPECT_EQ(groups[2].all(), 0) << "whatever is remembered";
    EXPECT_NEAR(groups[1].all(), 3, 1e-9);
}

TEST(ExpectedWork, IsWhatTheLastRunTook) {
    const SweepWork work = two_scenes();
    std::vector<std::string> keys;
    const auto estimated = expected_work(work, [&](const std::string& key) -> std::optional<double> {
        keys.push_back(key);
        return std::nullopt;
    });
    ASSERT_EQ(keys.size(), 4U);
    const auto mixed = expected_work(work, [&](const std::string& key) -> std::optional<double> {
        if (key != keys[1]) return std::nullopt;
        return 100.0;
    });
    EXPECT_NEAR(mixed[1].all(), 100, 1e-9);
    EXPECT_EQ(mixed[1].kind(Step::rounds), TimeLeft::last_run);
    EXPECT_EQ(mixed[0].kind(Step::rounds), "rounds");
    EXPECT_EQ(mixed[0].all(), estimated[0].all());
}

/// Twice the processors halve what runs beside others, and nothing else.
TEST(ExpectedWork, SharesTracesAmongProcessors) {
    const SweepWork work = two_scenes();
    const SceneWork& scene = work.scenes[1];
    const GroupWork two = estimated_work(work.plan, scene, *scene.shapes.back(), {31, 3}, 2),
                    four = estimated_work(work.plan, scene, *scene.shapes.back(), {31, 3}, 4);
    EXPECT_DOUBLE_EQ(two.of(Step::trace), 2 * four.of(Step::trace));
    EXPECT_EQ(two.of(Step::rounds), four.of(Step::rounds));
    EXPECT_EQ(two.of(Step::verify), four.of(Step::verify));
}

}  // namespace
}  // namespace edgewise::sweep
