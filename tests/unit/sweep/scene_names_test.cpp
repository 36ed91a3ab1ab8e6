// SPDX-License-Identifier: MIT
//
// Scene files that would go by one name are refused before anything is measured, both named.
#include "edgewise/sweep/work.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "edgewise/scene/scene_file.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/store/schema.hpp"
#include "edgewise/sweep/study.hpp"

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
}

/// A scene file may be called like a study, or begin like a scene that comes along: its rows say what
/// measured them.
TEST(SceneNames, OfStudiesAndBeginningsAreFree) {
    std::vector<std::string> runs = {store::sweep_run, "thrash_realised"};
    for (const Study& study : registered_studies()) runs.emplace_back(study.name);
    for (const std::string& run : runs)
        for (const std::string end : {"", "2", "ing", " tumble", "_mine"})
            EXPECT_EQ(complaint({run + end + ".json"}), "") << run << end;
    for (const scene::SceneInfo& kind : scene::list_scenes()) {
        EXPECT_EQ(complaint({kind.name + "2.json"}), "");
        EXPECT_EQ(complaint({kind.name.substr(0, kind.name.size() - 1) + ".json"}), "");
    }
    EXPECT_EQ(complaint({"paper_mine.json", "paper_bodies_of_mine.json"}), "");
}

/// If two runs into one store use different files for a scene, the error names both files.
TEST(SceneNames, OfFilesThatDifferDoNotShareAStore) {
    const auto folder = std::filesystem::temp_directory_path() / "edgewise-scene-files";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    store::Store store((folder / "s.db").string());
    SweepWork work;
    work.scenes.emplace_back();
    SceneWork& scene = work.scenes.back();
    scene.choice.name = "s", scene.json = R"({"scene":"tumble"})", scene.path = "c1/s.json";
    EXPECT_NO_THROW(check_scene_files(work, store));
    store.set_meta(store::scene_file_key + scene.choice.name, scene.json);
    store.set_meta(store::scene_path_key + scene.choice.name, scene.path);
    EXPECT_NO_THROW(check_scene_files(work, store)) << "the same again";
    scene.json = R"({"scene":"cold"})", scene.path = "c2/s.json";
    try {
        check_scene_files(work, store);
        ADD_FAILURE() << "taken";
    } catch (const std::invalid_argument& problem) {
        EXPECT_THAT(problem.what(),
                    AllOf(HasSubstr("c1/s.json"), HasSubstr("c2/s.json"), HasSubstr("rename")));
    }
    std::filesystem::remove_all(folder);
}

/// A file that is named twice is one scene, for example for other layouts.
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
