// SPDX-License-Identifier: MIT
//
// Scene files that would go by one name are refused before anything is measured, both named.
#include "edgewise/sweep/scene_names.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "edgewise/scene/scene_file.hpp"
#include "edgewise/scene/scenes.hpp"

namespace edgewise::sweep {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string complaint(const std::vector<std::string>& scenes) {
    Plan plan;
    for (const std::string& name : scenes) plan.scenes.push_back({name});
    try {
        check_scene_names(plan);
    } catch (const std::invalid_argument& problem) {
        return problem.what();
    }
    return "";
}

TEST(SceneNames, ThatMeetAreRefusedNamingBoth) {
    EXPECT_THAT(complaint({"c1/s.json", "c2/s.json"}),
                AllOf(HasSubstr("c1/s.json and c2/s.json"), HasSubstr("'s'")));
    EXPECT_THAT(complaint({"my scene.json", "cold", "my_scene.json"}),
                AllOf(HasSubstr("my scene.json and my_scene.json"), HasSubstr("'my_scene'")));
    EXPECT_EQ(complaint({"a.json", "b.json", "tumble", "tumble", "cold"}), "");
}

TEST(SceneNames, OfWhatComesAlongAreTaken) {
    for (const scene::SceneInfo& kind : scene::list_scenes())
        EXPECT_THAT(complaint({"mine/" + kind.name + ".json"}),
                    HasSubstr("kind of scene '" + kind.name + "'"));
    for (const scene::SceneText& text : scene::scene_texts()) {
        const std::string name(text.name);
        EXPECT_THAT(complaint({name + ".json"}), HasSubstr("'" + name + "' that comes along"));
        EXPECT_EQ(complaint({name}), "");
    }
    for (const char* study : {"stability", "paging", "thrash", "thrash_realised", "effort", "fields",
                              "effort tumble", "fields of mine"})
        EXPECT_THAT(complaint({std::string("x/") + study + ".json"}), HasSubstr("of a store"));
}

/// The same file twice is one scene, asked of other layouts, say.
TEST(SceneNames, OfOneFileDoNotMeet) {
    const auto folder = std::filesystem::temp_directory_path() / "edgewise-scene-names";
    std::filesystem::create_directories(folder);
    const std::string path = (folder / "s.json").string(), again = (folder / "." / "s.json").string();
    std::ofstream(path) << "{}";
    EXPECT_EQ(complaint({path, again, path}), "");
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace edgewise::sweep
