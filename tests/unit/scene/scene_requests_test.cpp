// SPDX-License-Identifier: MIT
//
// What is asked of scenes: defaults complete it, and what is wrong is said in one line.
#include <gtest/gtest.h>

#include <cmath>

#include "brute_force.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise::scene {
namespace {

TEST(Scenes, DefaultsCompleteTheIdentity) {
    const Result<SceneParameters> p = complete_parameters("tumble", {{"rotation_step", 0.5}});
    ASSERT_TRUE(p) << p.error;
    EXPECT_EQ(p->size(), 15U);
    EXPECT_TRUE(p->at("rotation_step") == 0.5 && p->at("occupancy") == 0.1);
}

void expect_refusal(const char* name, const SceneParameters& given, std::size_t count,
                    std::initializer_list<const char*> parts) {
    const Result<Workload> w =
        make_scene(name, *make_shape("cube8"), given, 1, count, truth::brute_force_distance);
    ASSERT_FALSE(w) << name;
    for (const char* part : parts) EXPECT_NE(w.error.find(part), std::string::npos) << w.error;
    EXPECT_EQ(w.error.find('\n'), std::string::npos);
}

TEST(Scenes, BadRequestsSayWhatIsRight) {
    expect_refusal("boil", {}, 1, {"'boil'", "static", "cold", "tumble"});
    expect_refusal("tumble", {{"speed", 1}}, 1, {"'speed'", "rotation_step", "translation_step"});
    expect_refusal("tumble", {{"rotation_step", -1}}, 1, {"rotation_step", "-1", "rad"});
    expect_refusal("tumble", {{"rotation_step", std::nan("")}}, 1, {"rotation_step", "nan"});
    expect_refusal("tumble", {{"bodies", 2.5}}, 1, {"bodies", "2.5", "whole"});
    expect_refusal("static", {{"occupancy", 0}}, 1, {"occupancy", "out of bounds"});
    expect_refusal("cold", {}, 0, {"queries"});
    const Result<Workload> w = make_scene("cold", *make_shape("cube8"), {}, 1, 1, {});
    ASSERT_FALSE(w);
    EXPECT_NE(w.error.find("distance function"), std::string::npos);
}

TEST(Scenes, ABarrenSceneEndsWithAReason) {
    expect_refusal(
        "tumble",
        {{"bodies", 2}, {"occupancy", 0.001}, {"margin", 0}, {"translation_step", 0}, {"steps", 1e6}}, 1,
        {"raise occupancy"});
}

}  // namespace
}  // namespace edgewise::scene
