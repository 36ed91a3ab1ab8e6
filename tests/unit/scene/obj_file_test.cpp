// SPDX-License-Identifier: MIT
//
// OBJ texts as programs and people write them: the same tetrahedron from every form, and a line for every
// refusal.
#include "edgewise/scene/mesh/mesh_parts.hpp"

#include <gtest/gtest.h>

#include <regex>
#include <string>

namespace edgewise::scene {
namespace {

using Parts = Result<std::vector<MeshPart>>;

constexpr const char* four_corners = "v 0 0 0\nv 1.5 0 0\nv 0 1.5 0\nv 0 0 1.5\n";
constexpr const char* four_sides = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

std::string with_pattern(const std::string& text, const char* what, const char* by) {
    return std::regex_replace(text, std::regex(what), by);
}

void expect_tetrahedron(const std::string& text, const std::string& warning = "") {
    const Parts parts = obj_parts(text);
    ASSERT_TRUE(parts) << parts.error << "\n" << text;
    EXPECT_EQ(parts.warning, warning) << text;
    ASSERT_EQ(parts->size(), 1U) << text;
    const std::vector<Vec3d> wanted = {Vec3d(0, 0, 0), Vec3d(1.5, 0, 0), Vec3d(0, 1.5, 0), Vec3d(0, 0, 1.5)};
    EXPECT_EQ(parts->front().points, wanted) << text;
    const std::vector<std::array<Index, 3>> triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    EXPECT_EQ(parts->front().triangles, triangles) << text;
    EXPECT_FALSE(parts->front().in_single);
}

TEST(ObjFile, ReadsEveryFormOfABodyAlike) {
    const std::string plain = std::string(four_corners) + four_sides;
    expect_tetrahedron(plain);
    expect_tetrahedron("\xEF\xBB\xBF" + plain);
    for (const char* end : {"\r\n", "\r", "\n\n", " \t\n", " # a note\n", "#\n", " \\\n\n"})
        expect_tetrahedron(with_pattern(plain, "\n", end));
    for (const char* start : {" ", "\t", "  \t "})
        expect_tetrahedron(start + with_pattern(plain, "\n", (std::string("\n") + start).c_str()));
    for (const char* blank : {"  ", "\t", " \t", " \\\n", "\\\n ", " \\\r\n\t", " \\ # a note\n "})
        expect_tetrahedron(with_pattern(plain, " ", blank));
    for (const char* comment : {"# parts\\models\\\n", "#\\\n", "#!\\\r\n", "  # indented \\\n"})
        expect_tetrahedron(comment + plain + comment);
    expect_tetrahedron(plain.substr(0, plain.size() - 1));
    expect_tetrahedron(std::string(four_sides) + four_corners);  // in OBJ a face may come before its vertices
}

TEST(ObjFile, ReadsEveryFormOfANumberAndACorner) {
    const std::string plain = std::string(four_corners) + four_sides;
    for (const char* number : {"+1.5", "1.50", "1.5e0", "15E-1", "0.15e+1", "1.5e+000", ".15e1", "0001.5"})
        expect_tetrahedron(with_pattern(plain, "1\\.5", number));
    for (const char* more : {" 1", " 1.0", " 0.5 0.25 1", " 255 0 7"})
        expect_tetrahedron(with_pattern(plain, "(v .*)\n", (std::string("$1") + more + "\n").c_str()));
    for (const char* corner : {"$1/1", "$1/1/1", "$1//3", "$1/-1/-2", "$1/"})
        expect_tetrahedron(std::string(four_corners) + with_pattern(four_sides, "([1-4])", corner));
    expect_tetrahedron(std::string(four_corners) + "f -4 -2 -3\nf -4 -3 -1\nf -4 -1 -2\nf -3 -2 -1\n");
    for (const char* line : {"vt 0 0\n", "vn 0 0 1\n", "s off\n", "mtllib x\\y\\\n", "usemtl steel\n",
                             "o a # b \\\n", "g a b\n", "vn 0 \\\n 0 1\n"})
        expect_tetrahedron(line + plain);
}

TEST(ObjFile, KeepsEveryDigit) {
    const Parts parts = obj_parts("v 345678.12300000002 5812345.6780000003 -1e-300\nv 0.1 0.2 0.3\n");
    ASSERT_TRUE(parts) << parts.error;
    EXPECT_EQ(parts->front().points[0], Vec3d(345678.12300000002, 5812345.6780000003, -1e-300));
    EXPECT_EQ(parts->front().points[1], Vec3d(0.1, 0.2, 0.3));
}

TEST(ObjFile, LeavesOutVerticesThatNoFaceNames) {
    const std::string far = "v 100 100 100\n";
    expect_tetrahedron(four_corners + far + four_sides, "1 of 5 vertices is named by no face and left out");
    expect_tetrahedron(four_corners + far + far + four_sides + far,
                       "3 of 7 vertices are named by no face and left out");
    expect_tetrahedron(far + four_corners + "f 2 4 3\nf 2 3 5\nf 2 5 4\nf 3 4 5\n",
                       "1 of 5 vertices is named by no face and left out");
}

std::vector<std::size_t> part_sizes(const std::string& text) {
    const Parts parts = obj_parts(text);
    EXPECT_TRUE(parts) << parts.error;
    std::vector<std::size_t> result;
    if (parts)
        for (const MeshPart& part : *parts) result.push_back(part.points.size());
    return result;
}

/// The parts are the meshes that Assimp makes of an OBJ file.
TEST(ObjFile, BeginsAPartWithAnObjectAGroupAndAMaterial) {
    using Sizes = std::vector<std::size_t>;
    const std::string points = std::string(four_corners) + "v 5 5 5\n", three = "f 1 2 3\n",
                      four = "f 1 2 3 4\n";
    for (const char* keyword : {"o", "g", "usemtl"}) {
        const std::string a = std::string(keyword) + " a\n", b = std::string(keyword) + " b\n";
        EXPECT_EQ(part_sizes(points + a + three + b + four), (Sizes{3, 4})) << keyword;
        EXPECT_EQ(part_sizes(points + a + three + a + four), Sizes{4}) << keyword << " of the same name";
        EXPECT_EQ(part_sizes(points + a + three + b + four + a + three), (Sizes{3, 4, 3})) << keyword;
        EXPECT_EQ(part_sizes(a + points + b + three), Sizes{3}) << keyword << " without faces";
    }
    EXPECT_EQ(part_sizes(points + three + "usemtl a\n" + four), Sizes{4})
        << "the first material begins nothing";
    EXPECT_EQ(part_sizes(points + "o a\ng b\nusemtl c\n" + three + "usemtl d\n" + four), (Sizes{3, 4}));
    EXPECT_EQ(part_sizes(points + "o a#1\n" + three + "o a#2\n" + four), (Sizes{3, 4})) << "no comment";
    EXPECT_EQ(part_sizes(points + "l 1 2\nl 3 4 5\n"), Sizes{5});
    EXPECT_EQ(part_sizes(points + "p 1 2 3 4\n"), Sizes{4});
    EXPECT_EQ(obj_parts(points + "g left  foot\n" + three)->front().name, "left foot");
}

TEST(ObjFile, TakesAllPointsWhereThereIsNoFace) {
    using Sizes = std::vector<std::size_t>;
    for (const char* name :
         {"", "o cloud\n", "g Object001\n", "g a\no b\n", "usemtl a\n", "o a\nusemtl b\nusemtl c\n"})
        EXPECT_EQ(part_sizes(name + std::string(four_corners)), Sizes{4}) << name;
    EXPECT_EQ(part_sizes("v 0 0 0\no a\nv 1 1 1\nv 2 2 2\no b\nv 3 3 3\n"), (Sizes{1, 2, 1}));
    EXPECT_EQ(part_sizes("o a\nv 1 1 1\nusemtl x\nv 2 2 2\nusemtl y\nv 3 3 3\n"), Sizes{3});
}

/// Each is put into the fifth line.
constexpr std::pair<const char*, const char*> refused_lines[] = {
    {"v 0,5 0 0", "'0,5' has a decimal comma; write a point"},
    {"v -1,5e3 0 0", "decimal comma"},
    {"v 0 0 ,5", "decimal comma"},
    {"v 1, 2, 3", "'1,' has a decimal comma"},
    {"v nan 0 0", "'nan': every coordinate must be a finite number"},
    {"v 0 -NaN 0", "finite"},
    {"v 0 inf 0", "finite"},
    {"v 0 0 -Infinity", "finite"},
    {"v 1e999 0 0", "finite"},
    {"v 1e61 0 0", "beyond 1e+60"},
    {"v -1.IND 0 0", "no number"},
    {"v x 0 0", "'x' is no number"},
    {"v 0x10 0 0", "no number"},
    {"v 1.5f 0 0", "no number"},
    {"v 1-2 0 0", "no number"},
    {"v", "0 numbers"},
    {"v 1", "1 number;"},
    {"v 1 2", "2 numbers"},
    {"v 1 2 3 4 5", "5 numbers"},
    {"v 1 2 3 4 5 6 7", "7 numbers"},
    {"v 1 2 3 2", "a weight of 2"},
    {"v 1 2 3 0", "a weight of 0"},
    {"v 1 2 3 0.5 0,5 0.5", "decimal comma"},
    {"v0 0 0", "'v0' is not a statement"},
    {"V 0 0 0", "'V' is not a statement"},
    {"F 1 2 3", "'F' is not a statement"},
    {"solid cube", "'solid'"},
    {"surf 0 1 0 1 1 2 3", "'surf'"},
    {"cstype bezier", "points, lines and polygons are"},
    {"f 0 1 2", "vertex 0: OBJ counts vertices from 1"},
    {"f 1 2 0/1", "counts vertices from 1"},
    {"f 1 2 9", "no vertex 9: the file has 4"},
    {"f 1 2 99999999999", "no vertex 99999999999"},
    {"f 1 2 -5", "no vertex -5: 4 vertices come before this line"},
    {"f 1 2 x", "'x' is no vertex of a face"},
    {"f 1 2 3.5", "'3.5' is no vertex"},
    {"f 1,2,3 2 3", "is no vertex"},
    {"f 1 2 3\\4", "is no vertex"},
    {"f", "'f' with 0 vertices"},
    {"f 1", "'f' with 1 vertices, and at least 3"},
    {"f 1 2", "'f' with 2 vertices"},
    {"l 1", "at least 2"},
    {"p 9", "no vertex 9"}};

TEST(ObjFile, RefusesALineWithItsNumber) {
    for (const auto& [line, said] : refused_lines) {
        for (const char* end : {"\n", "\r\n", "\r"}) {
            const std::string text =
                with_pattern(std::string(four_corners) + line + "\n" + four_sides, "\n", end);
            const Parts parts = obj_parts(text);
            EXPECT_FALSE(parts) << line;
            EXPECT_EQ(parts.error.substr(0, 4), ":5: ") << line << parts.error;
            EXPECT_NE(parts.error.find(said), std::string::npos) << line << parts.error;
            EXPECT_EQ(parts.error.find('\n'), std::string::npos);
        }
    }
    EXPECT_EQ(obj_parts(std::string("v 0 0 0\nv 1 0 \\\n 0\nv 1 \\\n 2\n")).error.substr(0, 3), ":4:")
        << "a statement of several lines has the number of its first";
    EXPECT_NE(obj_parts(std::string("v 0 0 0\nv 0\0 0 0\n", 17)).error.find(":2: a zero byte"),
              std::string::npos);
    for (const char* nothing : {"", "# nothing\n", "o a\ng b\n", "mtllib a.mtl\n"})
        EXPECT_EQ(obj_parts(nothing).error, ": has no mesh inside");
}

}  // namespace
}  // namespace edgewise::scene
