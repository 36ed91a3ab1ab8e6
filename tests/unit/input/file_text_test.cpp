// SPDX-License-Identifier: MIT
//
// Files that users name: regular ones are read whole, all others are refused at once.
#include "edgewise/input/file_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace edgewise::input {
namespace {

using testing::HasSubstr;

class FileText : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (std::filesystem::temp_directory_path() / "edgewise-text-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder_ = name;
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    [[nodiscard]] std::string path(const char* name) const { return (folder_ / name).string(); }

    std::filesystem::path folder_;
};

TEST_F(FileText, IsReadWhole) {
    const std::string text("a\0b\r\n\xff", 6);
    std::ofstream(path("t"), std::ios::binary) << text;
    EXPECT_EQ(*read_file_text(path("t")), text);
    EXPECT_EQ(*read_file_text(path("t"), 6), text);
    EXPECT_THAT(read_file_text(path("t"), 5).error, HasSubstr("has 6 bytes, more than the 5"));
    std::filesystem::create_symlink("t", path("link"));
    EXPECT_EQ(*read_file_text(path("link")), text);
    std::ofstream(path("empty"));
    EXPECT_EQ(*read_file_text(path("empty")), "");
}

/// None of these is opened: a pipe without a writer would hang, a device never end.
TEST_F(FileText, RefusesWhatIsNoRegularFile) {
    ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
    for (const std::string& file : {path("pipe"), std::string("/dev/zero"), std::string("/dev/null")})
        EXPECT_EQ(read_file_text(file).error,
                  file + ": is no regular file but a pipe, a device or the like: write it to a file first");
    EXPECT_THAT(read_file_text(path(".")).error, HasSubstr("is a directory"));
    EXPECT_EQ(read_file_text(path("none")).error, path("none") + ": no such file");
    std::filesystem::create_symlink("nowhere", path("dangling"));
    EXPECT_THAT(read_file_text(path("dangling")).error, HasSubstr("no such file"));
    std::filesystem::create_symlink("circle", path("circle"));
    EXPECT_THAT(read_file_text(path("circle")).error, HasSubstr("cannot be looked at"));
}

}  // namespace
}  // namespace edgewise::input
