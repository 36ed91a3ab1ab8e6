// SPDX-License-Identifier: MIT
//
// What groups are expected to take: what a store remembers as it is, the others by the model in the same
// measure.
#include "edgewise/sweep/expected_work.hpp"

#include <gtest/gtest.h>

namespace edgewise::sweep {
namespace {

SweepWork two_scenes() {
    Plan plan = make_plan("quick");
    plan.scenes = {{"cold"}, {"tumble"}};
    plan.shapes = {"tetra4", "sphere386"};
    plan.meshes.clear();
    return prepare_sweep(plan, [](const std::string&) {});
}

TEST(ExpectedWork, IsModelledWhereNothingIsRemembered) {
    const SweepWork work = two_scenes();
    const auto groups = expected_work(work, [](const std::string&) { return std::nullopt; });
    ASSERT_EQ(groups.size(), 4U);
    for (const GroupWork& group : groups) {
        EXPECT_GT(group.verify, 0);
        EXPECT_GT(group.alone, 0);
        EXPECT_GT(group.rounds, 0);
    }
    EXPECT_GT(groups[1].all(), 2 * groups[0].all()) << "386 vertices against 4";
}

TEST(ExpectedWork, IsNoneOfABodyThatThereIsNot) {
    SweepWork work = two_scenes();
    const scene::NamedShape missing{"foot", "foot.stl", {}, "foot.stl: no such file"};
    EXPECT_EQ(modelled_work(work.plan, work.scenes[0], missing, 100).all(), 0);
    work.scenes[0].shapes.push_back(&missing);
    const auto groups = expected_work(work, [](const std::string&) { return std::optional(3.0); });
    ASSERT_EQ(groups.size(), 5U);
    EXPECT_EQ(groups[2].all(), 0) << "whatever is remembered";
    EXPECT_NEAR(groups[1].all(), 3, 1e-9);
}

TEST(ExpectedWork, IsWhatIsRemembered) {
    const SweepWork work = two_scenes();
    const auto modelled = expected_work(work, [](const std::string&) { return std::nullopt; });
    std::vector<std::string> keys;
    static_cast<void>(expected_work(work, [&](const std::string& key) -> std::optional<double> {
        keys.push_back(key);
        return std::nullopt;
    }));
    ASSERT_EQ(keys.size(), 4U);
    const auto mixed = expected_work(work, [&](const std::string& key) -> std::optional<double> {
        if (key != keys[1]) return std::nullopt;
        return 100.0;
    });
    EXPECT_NEAR(mixed[1].all(), 100, 1e-9);
    const double factor = 100 / modelled[1].all();
    EXPECT_NEAR(mixed[0].all(), factor * modelled[0].all(), 1e-9)
        << "a slower machine is slower in all of it";
    EXPECT_NEAR(mixed[3].all(), factor * modelled[3].all(), 1e-9);
}

}  // namespace
}  // namespace edgewise::sweep
