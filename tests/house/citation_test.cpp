// SPDX-License-Identifier: MIT
//
// CITATION.cff as a reader of Citation File Format 1.2 has it: parsed as YAML by another program's parser,
// with the keys that the format requires, and true of this project.
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include "house_paths.hpp"

namespace edgewise::house {
namespace {

YAML::Node citation() { return YAML::LoadFile(std::string(project_root) + "/CITATION.cff"); }

std::string text_of(const YAML::Node& node, const char* key) {
    return node[key] && node[key].IsScalar() ? node[key].as<std::string>() : "(none)";
}

/// Persons have names or a family name; entities have a name.
bool is_named(const YAML::Node& author) {
    return author["name"] || author["family-names"] || author["alias"];
}

TEST(Citation, HasWhatTheFormatRequires) {
    const YAML::Node cff = citation();
    EXPECT_EQ(text_of(cff, "cff-version"), "1.2.0");
    EXPECT_GT(text_of(cff, "message").size(), 10u);
    EXPECT_EQ(text_of(cff, "type"), "software");
    ASSERT_TRUE(cff["authors"].IsSequence());
    ASSERT_EQ(cff["authors"].size(), 1u);
    EXPECT_EQ(text_of(cff["authors"][0], "name"), "The Edgewise developers");
    ASSERT_TRUE(cff["references"].IsSequence());
    for (const YAML::Node& reference : cff["references"]) {
        EXPECT_NE(text_of(reference, "type"), "(none)");
        EXPECT_NE(text_of(reference, "title"), "(none)");
        ASSERT_TRUE(reference["authors"].IsSequence());
        for (const YAML::Node& author : reference["authors"]) EXPECT_TRUE(is_named(author));
    }
}

/// Of the format's top level, version 1.2.0; it allows no others.
TEST(Citation, HasNoKeysThatTheFormatDoesNotKnow) {
    const std::set<std::string> known = {"abstract",
                                         "authors",
                                         "cff-version",
                                         "commit",
                                         "contact",
                                         "date-released",
                                         "doi",
                                         "identifiers",
                                         "keywords",
                                         "license",
                                         "license-url",
                                         "message",
                                         "preferred-citation",
                                         "references",
                                         "repository",
                                         "repository-artifact",
                                         "repository-code",
                                         "title",
                                         "type",
                                         "url",
                                         "version"};
    for (const auto& entry : citation()) EXPECT_TRUE(known.contains(entry.first.as<std::string>()));
}

TEST(Citation, IsTrueOfThisProject) {
    const YAML::Node cff = citation();
    EXPECT_EQ(text_of(cff, "version"), project_version) << "the version of CMakeLists.txt";
    EXPECT_EQ(text_of(cff, "license"), "MIT");
    EXPECT_TRUE(std::filesystem::exists(std::string(project_root) + "/LICENSE"));
    EXPECT_TRUE(std::regex_search(text_of(cff, "title"), std::regex("replication")));
}

TEST(Citation, NamesThePaperThatIsReplicated) {
    const YAML::Node paper = citation()["references"][0];
    EXPECT_EQ(text_of(paper, "title"), "New Metrics for Evaluation of Collision Detection Techniques");
    EXPECT_EQ(text_of(paper, "year"), "2001");
    ASSERT_EQ(paper["authors"].size(), 3u);
    const char* const families[] = {"Levey", "Peters", "O'Sullivan"};
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(text_of(paper["authors"][i], "family-names"), families[i]);
}

}  // namespace
}  // namespace edgewise::house
