// SPDX-License-Identifier: MIT
//
// Plans: the named ones are what they are said to be, and can be run; a file overrides what it names; a bad
// one is one clear line.
#include "edgewise/sweep/plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "edgewise/bench/registry.hpp"
#include "edgewise/scene/scene_texts.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise::sweep {
namespace {

using ::testing::HasSubstr;

class PlanFile : public ::testing::Test {
  protected:
    void SetUp() override {
        std::string name = (std::filesystem::temp_directory_path() / "edgewise-plan-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder_ = name;
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    [[nodiscard]] std::string write(const std::string& text) const {
        const std::string path = (folder_ / "mine.json").string();
        std::ofstream(path) << text;
        return path;
    }

    [[nodiscard]] static std::string error_of(const std::string& name) {
        try {
            static_cast<void>(make_plan(name));
        } catch (const std::invalid_argument& problem) {
            return problem.what();
        }
        return "no error";
    }

    std::filesystem::path folder_;
};

std::size_t cells(const Plan& plan) {
    std::size_t served = 0;
    const auto chosen = bench::select_algorithms(plan.algorithms);
    for (const bench::TableType* type : bench::select_table_types(plan.layouts)) {
        for (const std::string& algorithm : type->algorithms) {
            served += static_cast<std::size_t>(std::count(chosen.begin(), chosen.end(), algorithm));
        }
    }
    return plan.scenes.size() * (plan.shapes.size() + plan.meshes.size()) * served;
}

TEST(Plan, EveryNamedPlanAsksForWhatThereIs) {
    for (const std::string& name : plan_names()) {
        const Plan plan = make_plan(name);
        EXPECT_EQ(plan.name, name);
        EXPECT_FALSE(bench::select_table_types(plan.layouts).empty());
        EXPECT_FALSE(bench::select_algorithms(plan.algorithms).empty());
        for (const SceneChoice& scene : plan.scenes) {
            if (const auto file = scene::find_scene_file(scene.name)) {
                EXPECT_TRUE(*file) << name << ": " << file->error;
                continue;
            }
            const auto complete = scene::complete_parameters(scene.name, scene.parameters);
            EXPECT_TRUE(complete) << name << ": " << complete.error;
        }
        for (const std::string& shape : plan.shapes) {
            const auto body = scene::make_shape(shape);
            EXPECT_TRUE(body) << name << ": " << body.error;
        }
        EXPECT_GE(plan.meshes.size(), 3U) << "real objects are part of every plan";
        EXPECT_LE(plan.checked, plan.queries);
        EXPECT_GE(plan.rounds, 6) << "fewer give no interval";
    }
}

TEST(Plan, QuickAndPaperKeepTheirPromises) {
    const Plan quick = make_plan("quick"), paper = make_plan("paper");
    EXPECT_GE(cells(quick), 100U);
    EXPECT_GE(quick.checked, 200U);
    EXPECT_GE(paper.checked, 2000U);
    EXPECT_EQ(paper.queries, 30000U);
}

TEST_F(PlanFile, OverridesWhatItNamesAndKeepsTheRestOfQuick) {
    const Plan quick = make_plan("quick");
    const Plan plan = make_plan(write(R"({"scenes": [{"name": "cold", "parameters": {"distance": 2}}],
        "shapes": ["cube8"], "meshes": [], "seed": 7, "queries": 50, "checked": 5, "rounds": 9})"));
    EXPECT_EQ(plan.name, "mine");
    ASSERT_EQ(plan.scenes.size(), 1U);
    EXPECT_EQ(plan.scenes[0].name, "cold");
    EXPECT_EQ(plan.scenes[0].parameters, (scene::SceneParameters{{"distance", 2}}));
    EXPECT_EQ(plan.shapes, std::vector<std::string>{"cube8"});
    EXPECT_TRUE(plan.meshes.empty());
    EXPECT_EQ(plan.layouts, quick.layouts);
    EXPECT_EQ(plan.algorithms, quick.algorithms);
    EXPECT_EQ(plan.seed, 7U);
    EXPECT_EQ(plan.queries, 50U);
    EXPECT_EQ(plan.checked, 5U);
    EXPECT_EQ(plan.rounds, 9);
}

TEST_F(PlanFile, BadOnesAreOneClearLine) {
    EXPECT_THAT(error_of("nonesuch"),
                ::testing::AllOf(HasSubstr("nonesuch"), HasSubstr("quick, paper, full")));
    const std::string missing = (folder_ / "gone.json").string();
    EXPECT_THAT(error_of(missing), HasSubstr(missing));
    for (const char* text : {"", "{", "{\"queries\": \"many\"}", "{\"scenes\": [{}]}", "{\"shapes\": 3}"}) {
        const std::string path = write(text);
        EXPECT_THAT(error_of(path), HasSubstr(path)) << text;
        EXPECT_THAT(error_of(path), Not(HasSubstr("\n"))) << text;
    }
}

}  // namespace
}  // namespace edgewise::sweep
