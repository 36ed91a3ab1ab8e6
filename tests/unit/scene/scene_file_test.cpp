// SPDX-License-Identifier: MIT
//
// Scene files: every one that comes along makes its scenes; units, varied values and random turns come out as
// the file says; and each kind of mistake is answered with its place and what is allowed there.
#include "edgewise/scene/scene_file.hpp"

#include <gmock/gmock.h>

#include <set>

#include "brute_force.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise::scene {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

SceneFile parsed(const std::string& text) {
    auto file = parse_scene_file("mine", text);
    EXPECT_TRUE(file) << file.error;
    return file ? std::move(*file) : SceneFile{};
}

TEST(SceneFile, ThatComesAlongMakesItsScenes) {
    ASSERT_GE(scene_texts().size(), 15U);
    for (const SceneText& text : scene_texts()) {
        const auto file = find_scene_file(std::string(text.name));
        ASSERT_TRUE(file && *file) << text.name << ": " << (file ? file->error : "not found");
        EXPECT_FALSE((*file)->note.empty()) << text.name;
        const ScenePoint& point = (*file)->points.front();
        const auto made = make_scene((*file)->kind, *make_shape(point.shape), point.parameters, 1, 40,
                                     truth::brute_force_distance);
        EXPECT_TRUE(made) << text.name << ": " << made.error;
    }
}

/// The paper's sweeps over velocity have at least twelve points, from none or little to the most there is.
TEST(SceneFile, OfThePaperVariesFarEnough) {
    const auto linear = **find_scene_file("paper_linear_8");
    EXPECT_GE(linear.points.size(), 12U);
    EXPECT_EQ(linear.points.back().parameters.at("step_in_dimensions"), 0.5);
    for (const char* name : {"paper_angular_8", "paper_angular_38", "paper_angular_386"}) {
        const auto angular = **find_scene_file(name);
        EXPECT_GE(angular.points.size(), 12U) << name;
        EXPECT_EQ(angular.points.back().parameters.at("random_orientation"), 1) << name;
        const double fastest = angular.points[angular.points.size() - 2].parameters.at("rotation_step");
        EXPECT_NEAR(fastest, 2 * M_PI, 0.1) << "a whole turn itself is none";
        EXPECT_GT(angular.points.front().parameters.at("precession"), 0) << "axes turn";
        EXPECT_EQ(angular.points.front().parameters.at("own_tables"), 1) << "the paper's way";
    }
    EXPECT_EQ((**find_scene_file("paper_bodies")).points.back().parameters.at("bodies"), 10000);
}

/// Every scene of the paper with a broad phase states its margin: none, but where that is what it varies.
/// Every one that moves pairs in and out takes fifty steps.
TEST(SceneFile, OfThePaperStatesItsMarginAndItsSteps) {
    std::size_t with_margin = 0;
    for (const SceneText& text : scene_texts()) {
        const SceneFile file = **find_scene_file(std::string(text.name));
        for (const ScenePoint& point : file.points) {
            if (point.parameters.contains("least_steps")) {
                EXPECT_GE(point.parameters.at("least_steps"), 50) << text.name;
            }
            if (!point.parameters.contains("margin")) continue;
            EXPECT_NE(text.json.find("\"margin\""), std::string_view::npos) << text.name;
            const bool varied = text.name.find("margin") != std::string_view::npos;
            EXPECT_TRUE(varied || point.parameters.at("margin") == 0) << text.name;
            ++with_margin;
        }
    }
    EXPECT_GT(with_margin, 60U);
    for (const char* name : {"paper_margin", "paper_static_margin"}) {
        const SceneFile file = **find_scene_file(name);
        EXPECT_EQ(file.points.front().parameters.at("margin"), 0) << name;
        EXPECT_EQ(file.points.back().parameters.at("margin"), 0.2) << name;
    }
}

TEST(SceneFile, TurnsVelocitiesIntoSteps) {
    const SceneFile file = parsed(
        R"({"scene": "tumble", "shapes": ["cube8", "sphere38"], "time_step": 0.5, "needs": "depth",
            "sharing": "per_instance", "queries": 77, "parameters": {"linear_velocity": 1.5},
            "vary": {"angular_velocity": [2, 4, "random"]}})");
    ASSERT_EQ(file.points.size(), 6U) << "shapes x values";
    EXPECT_EQ(file.name, "mine");
    EXPECT_EQ(file.needs, Needs::depth);
    EXPECT_EQ(file.queries, 77U);
    const SceneParameters& first = file.points[0].parameters;
    EXPECT_EQ(first.at("rotation_step"), 1);
    EXPECT_EQ(first.at("own_tables"), 1);
    EXPECT_DOUBLE_EQ(first.at("translation_step"), 0.75 / extent(make_shape("cube8")->vertices));
    EXPECT_EQ(file.points[2].parameters.at("random_orientation"), 1);
    EXPECT_EQ(file.points[2].parameters.at("rotation_step"), 0);
    EXPECT_EQ(file.points[3].shape, "sphere38");
    EXPECT_EQ(parsed(file.text).points.size(), 6U) << "its text reads back";
}

TEST(SceneFile, HasAMarginWhereNearnessIsAsked) {
    const SceneFile file =
        parsed(R"({"scene": "tumble", "shapes": ["cube8"], "needs": "nearer", "margin": 2})");
    EXPECT_EQ(file.needs, Needs::nearer);
    EXPECT_EQ(file.margin, 2);
    EXPECT_EQ(parsed(R"({"scene": "tumble", "shapes": ["cube8"], "needs": "nearer"})").margin, 0);
}

struct BadFile {
    const char *text, *place, *allowed;
};

/// A file, or what makes one of a good file with a tumble of cubes.
const BadFile bad_files[] = {
    {"{", "not JSON", "column"},
    {"[1]", "the file must be one object", "shapes"},
    {R"({"shapes": ["cube8"]})", "scene is missing", ""},
    {R"({"scene": "tumble"})", "shapes is missing", ""},
    {R"({"scene": "tumble", "shapes": []})", "shapes", "at least one"},
    {R"({"scene": "tumble", "shapes": "cube8"})", "shapes", "a list"},
    {R"({"scene": "tumbel", "shapes": ["cube8"]})", "'tumbel'", "tumble"},
    {R"({"scene": "tumble", "shapes": ["cube9"]})", "shapes", "cube8"},
    {R"("gravity": 9.81)", "gravity", "time_step"},
    {R"("time_step": 0)", "time_step", "above 0"},
    {R"("needs": "all")", "'all'", "certificate"},
    {R"("margin": 1)", "margin", "nearer"},
    {R"("needs": "nearer", "margin": 0)", "margin", "above 0"},
    {R"("sharing": "no")", "'no'", "per_instance"},
    {R"({"scene": "static", "shapes": ["cube8"], "sharing": "per_instance"})", "own_tables", "occupancy"},
    {R"("queries": 1.5)", "queries", "whole"},
    {R"("queries": -1)", "queries = '-1'", "0 to 100000000"},
    {R"("queries": 1e308)", "queries", "0 to 100000000"},
    {R"("queries": 9223372036854775808)", "queries", "0 to 100000000"},
    {R"("parameters": {"angular_velocity": 1, "rotation_step": 0.1})",
     "parameters.angular_velocity and parameters.rotation_step", "leave one of them out"},
    {R"("parameters": {"linear_velocity": 1, "translation_step": 0.1})",
     "parameters.linear_velocity and parameters.translation_step", "leave one of them out"},
    {R"("parameters": {"bodies": 10}, "vary": {"bodies": [10, 20]})", "parameters.bodies and vary.bodies",
     "leave one of them out"},
    {R"("parameters": {"rotation_step": 1}, "vary": {"angular_velocity": [2, "random"]})",
     "parameters.rotation_step and vary.angular_velocity", "leave one of them out"},
    {R"("parameters": {"random_orientation": 0, "angular_velocity": "random"})",
     "parameters.angular_velocity", "random_orientation"},
    {R"("sharing": "per_instance", "parameters": {"own_tables": 0})", "sharing and parameters.own_tables",
     "leave one of them out"},
    {R"("parameters": {"bodies": 1})", "bodies = 1", "2 to 10000"},
    {R"("parameters": {"speed": 1})", "'speed'", "rotation_step"},
    {R"("parameters": {"bodies": "ten"})", "bodies", "a number"},
    {R"("vary": {"bodies": []})", "vary.bodies", "a list"},
    {R"("vary": {"bodies": [2], "margin": [1]})", "vary", "one parameter"}};

TEST(SceneFile, ThatIsWrongSaysWhereAndWhatIsAllowed) {
    for (const auto& [text, place, allowed] : bad_files) {
        const std::string whole =
            *text == '{' || *text == '['
                ? text
                : R"({"scene": "tumble", "shapes": ["cube8"], )" + std::string(text) + "}";
        const auto file = parse_scene_file("mine", whole);
        ASSERT_FALSE(file) << whole;
        EXPECT_THAT(file.error, HasSubstr("scene file mine: "));
        EXPECT_THAT(file.error, HasSubstr(place));
        EXPECT_THAT(file.error, HasSubstr(allowed));
        EXPECT_EQ(file.error.find('\n'), std::string::npos);
    }
}

/// Repeated or far too many values are mistakes, which would be measured without a warning.
TEST(SceneFile, HasNothingTwiceAndNotTooMuch) {
    std::string many = "2", most = "2";
    for (int i = 3; i <= 1002; ++i) many += "," + std::to_string(i);
    for (int i = 3; i <= 501; ++i) most += "," + std::to_string(i);
    std::string spheres;
    for (int k = 1; k <= 21; ++k)
        spheres += (k > 1 ? R"(", ")" : "") + std::string("sphere") + std::to_string(4 * k * k + 2);
    const auto error_of = [](const std::string& shapes, const std::string& values) {
        return parse_scene_file("mine", R"({"scene": "tumble", "shapes": [")" + shapes +
                                            R"("], "vary": {"bodies": [)" + values + "]}}")
            .error;
    };
    EXPECT_EQ(error_of("cube8", most), "");
    EXPECT_THAT(error_of(R"(cube8", "tetra4", "cube8)", "2"), HasSubstr("'cube8' (built-in) is given twice"));
    EXPECT_THAT(error_of("cube8", "2,3,2"), HasSubstr("vary.bodies has 2 twice"));
    EXPECT_THAT(error_of("cube8", many), HasSubstr("vary.bodies has 1001 values, more than the 1000"));
    EXPECT_THAT(error_of(spheres, most), HasSubstr("10500 scenes, more than the 10000"));
    EXPECT_THAT(
        parse_scene_file("mine", R"({"scene": "tumble", "shapes": ["cube8"], "scene": "cold"})").error,
        HasSubstr("scene is given twice"));
}

TEST(SceneFile, IsRefusedOnOneLineWhateverItsNamesHold) {
    // A parameter and a member with a line's end in them, both found by fuzzing.
    for (const char* text :
         {R"({"scene": "tumble", "shapes": ["cube8"], "parameters": {"bodies\n or not": [1, 2]}})",
          R"({"scene": "tumble", "shapes": ["cube8"], "vary\n": {}})"}) {
        const auto file = parse_scene_file("mine", text);
        ASSERT_FALSE(file);
        EXPECT_THAT(file.error, Not(HasSubstr("\n")));
        EXPECT_THAT(file.error, HasSubstr("?"));
    }
}

TEST(SceneFile, ThatIsNestedDeeplyIsRefused) {
    const std::string deep = std::string(100'000, '[') + std::string(100'000, ']');
    for (const char* member : {"note", "parameters", "vary", "shapes", "scene"}) {
        const auto file = parse_scene_file("mine", R"({"scene": "tumble", "shapes": ["cube8"], ")" +
                                                       std::string(member) + "\": " + deep + "}");
        ASSERT_FALSE(file) << member;
        EXPECT_EQ(file.error, "scene file mine: nested deeper than 64 levels");
    }
}

TEST(SceneFile, ThatCannotBeReadIsNamed) {
    const auto file = find_scene_file("no/such.json");
    ASSERT_TRUE(file);
    EXPECT_THAT(file->error, HasSubstr("no/such.json"));
    EXPECT_FALSE(find_scene_file("tumble")) << "a kind of scene is no file";
}

}  // namespace
}  // namespace edgewise::scene
