// SPDX-License-Identifier: MIT
//
// A folder for mesh files that a test writes, and what a refusal looks like.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "edgewise/scene/mesh/mesh_file.hpp"
#include "mesh_texts.hpp"

namespace edgewise::testing {

/// A folder of its own for each test, removed at its end.
class MeshFolder : public ::testing::Test {
  protected:
    void SetUp() override {
        const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
        const std::string name = "edgewise_mesh_" + std::to_string(getpid()) + "_" + info->name();
        folder_ = std::filesystem::temp_directory_path() / name;
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::string write(const std::string& name, const std::string& text) {
        const std::string path = (folder_ / name).string();
        std::ofstream(path, std::ios::binary) << text;
        return path;
    }
    [[nodiscard]] std::string folder() const { return folder_.string(); }

  private:
    std::filesystem::path folder_;
};

inline void expect_refused(const std::string& path, const std::string& expected) {
    for (const scene::MeshGrouping grouping :
         {scene::MeshGrouping::one_hull, scene::MeshGrouping::each_mesh}) {
        const auto bodies = scene::read_mesh_file(path, {grouping});
        EXPECT_FALSE(bodies) << path;
        EXPECT_EQ(bodies.error.rfind(path, 0), 0u) << bodies.error;
        EXPECT_NE(bodies.error.find(expected), std::string::npos) << bodies.error;
        EXPECT_EQ(bodies.error.find('\n'), std::string::npos) << bodies.error;
    }
}

}  // namespace edgewise::testing
