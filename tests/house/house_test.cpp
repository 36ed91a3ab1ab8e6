// SPDX-License-Identifier: MIT
//
// The rules of the house, over the real files.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>

#include "house.hpp"

namespace edgewise::house {
namespace {

const Files& tree() {
    static const Files files = read_tree(PROJECT_ROOT);
    return files;
}

/// A check of no files passes, so every other test needs this one.
TEST(Tree, IsTheProject) {
    const auto has = [](const char* path) {
        return std::any_of(tree().begin(), tree().end(), [&](const SourceFile& f) { return f.path == path; });
    };
    for (const char* path : {"CMakeLists.txt", "src/edgewise/table/contract.hpp", "src/edgewise/cli/main.cpp",
                             "layouts/CMakeLists.txt", "tests/run", "layouts/sweep", ".ci/run"}) {
        EXPECT_TRUE(has(path)) << path;
    }
    EXPECT_GT(std::count_if(tree().begin(), tree().end(), is_cpp), 100);
    EXPECT_GT(functions_beyond(1, tree()).size(), 500U);
}

TEST(Dependencies, FollowTheRule) { EXPECT_EQ(to_text(forbidden_includes(tree())), ""); }

TEST(Dependencies, HaveNoCycles) { EXPECT_EQ(to_text(include_cycles(tree())), ""); }

TEST(Files, BearTheLicence) { EXPECT_EQ(to_text(missing_licences(tree())), ""); }

TEST(Files, AreShort) { EXPECT_EQ(to_text(long_files(tree())), ""); }

TEST(Types, AreNamedOnce) { EXPECT_EQ(to_text(types_named_twice(tree())), ""); }

TEST(Functions, AreShort) { EXPECT_EQ(to_text(long_functions(tree())), ""); }

TEST(Files, HoldNothingForeign) { EXPECT_EQ(to_text(foreign_matter(tree())), ""); }

TEST(ExportedHeaders, IncludeWhatTheyUse) { EXPECT_EQ(to_text(missing_std_headers(tree())), ""); }

TEST(FlattenedFunctions, AreSoByOneMacro) { EXPECT_EQ(to_text(own_flattening(tree())), ""); }

TEST(Comments, NameFilesThatAreThere) { EXPECT_EQ(to_text(dead_mentions(tree())), ""); }

TEST(Readme, IsShort) { EXPECT_EQ(to_text(long_readme(tree())), ""); }

/// A layout or a probe is a file and a line of its manifest. A file without its line would never be compiled.
TEST(Manifests, NameEveryFile) {
    for (const char* room : {"layouts", "probes"}) {
        std::set<std::string> named, there;
        const std::regex entry(R"(^edgewise_(layout|probe)\((\w+).*)");
        for (const SourceFile& file : tree()) {
            const std::filesystem::path path = file.path;
            if (path.parent_path() != room) continue;
            if (path.extension() == ".hpp") there.insert(path.stem().string());
            if (path.filename() != "CMakeLists.txt") continue;
            std::smatch match;
            for (const std::string& line : file.lines) {
                if (std::regex_match(line, match, entry)) named.insert(match[2]);
            }
        }
        EXPECT_FALSE(there.empty()) << room;
        EXPECT_EQ(named, there) << room;
    }
}

}  // namespace
}  // namespace edgewise::house
