// SPDX-License-Identifier: MIT
//
// Pasted texts: every form gives the pair that stands in it, and what cannot be judged is refused with its
// reason.
#include "edgewise/scene/dumps/dump.hpp"

#include <gmock/gmock.h>

namespace edgewise::scene {
namespace {

using testing::HasSubstr;

PastedPair pasted(const std::string& text) {
    auto result = read_pasted(text, "here");
    EXPECT_TRUE(result) << result.error;
    return result ? *result : PastedPair{};
}

std::string refusal(const std::string& text) {
    const auto result = read_pasted(text, "here");
    EXPECT_FALSE(result) << text;
    EXPECT_THAT(result.error, testing::StartsWith("here: "));
    return result.error;
}

constexpr const char* commas =
    "Error with configuration\n  Original error message: a/b.h:(7): f(): it broke\n  Shape 1:\nConvex<double>(\n"
    "  std::make_shared<std::vector<Vector3<double>>>(\n    std::initializer_list<Vector3<double>>{\n"
    "      Vector3<double>(0, 0, 0),\n      Vector3<double>(1, 0, -0.5),\n      Vector3<double>(0, 1e-3, 0),\n"
    "      Vector3<double>(0, 0, 1),}),\n    4,\n  X_FS1\n1, 0, 0, 5,\n0, 0, -1, 6,\n0, 1, 0, 7,\n0, 0, 0, 1;\n"
    "  Shape 2:\nBox<double>(1, 2, 3);\n  X_FS2\n1, 0, 0, 0,\n0, 1, 0, 0,\n0, 0, 1, 0,\n0, 0, 0, 1;\n  Solver: x";

TEST(Dump, OfFclWithCommas) {
    const PastedPair found = pasted(commas);
    EXPECT_EQ(found.format, "FCL dump");
    ASSERT_EQ(found.pair.a.vertices.size(), 4U);
    EXPECT_EQ(found.pair.a.vertices[1], Vec3d(1, 0, -0.5));
    EXPECT_EQ(found.pair.a.vertices[2], Vec3d(0, 1e-3, 0));
    ASSERT_EQ(found.pair.b.vertices.size(), 8U);
    EXPECT_EQ(found.pair.b.vertices[7], Vec3d(0.5, 1, 1.5));
    EXPECT_EQ(found.pair.pose_a.translation, Vec3d(5, 6, 7));
    EXPECT_EQ(found.pair.pose_a.rotation(1, 2), -1);
    EXPECT_TRUE(found.pair.pose_b.rotation.isIdentity(0));
    ASSERT_TRUE(found.reported);
    EXPECT_EQ(found.reported->what, "threw: f(): it broke");
}

TEST(Dump, OfFclInColumnsAndQuoted) {
    const PastedPair found = pasted(
        "> Shape 1: Box0.5 0.25 4\n> X_FS1\n> 1 0 0 1.5\n> 0 1 0 -2\n> 0 0 1 3e-2\n> 0 0 0 1\n> Shape 2: Box 1 1 1\n"
        "> X_FS2\n> 0 -1 0 0\n> 1 0 0 0\n> 0 0 1 0\n");
    EXPECT_EQ(found.pair.a.vertices[7], Vec3d(0.25, 0.125, 2));
    EXPECT_EQ(found.pair.pose_a.translation, Vec3d(1.5, -2, 3e-2));
    EXPECT_EQ(found.pair.pose_b.rotation(0, 1), -1) << "twelve numbers do";
}

TEST(Dump, OfFclThatHasNoPolyhedron) {
    EXPECT_THAT(refusal("Shape 1: Sphere(0.1)\nX_FS1\n1 0 0 0\nShape 2: Box1 1 1\nX_FS2\n"),
                HasSubstr("Sphere"));
    EXPECT_THAT(refusal("Shape 1: Convex(v count: 16, f count: 28)\nX_FS1\nShape 2: Box1 1 1\nX_FS2\n"),
                HasSubstr("counts alone"));
    EXPECT_THAT(refusal("Shape 1: Box1 1 1\nX_FS1\n1 0 0\nShape 2: Box1 1 1\nX_FS2\n"),
                HasSubstr("X_FS1 has 3 numbers"));
    EXPECT_THAT(refusal("Shape 1: Box1 1 1\nX_FS1\n"), HasSubstr("there is no 'Shape 2'"));
}

TEST(Dump, OfPython) {
    const PastedPair found = pasted(
        "s1 = hppfcl.Box(2, 4, 6)\nv = np.array([[0, 0, 0], [1.5, 0, 0],\n  [0, 1, 0], [0, 0, 1]])\n"
        "# o1.setTranslation(np.array([9, 9, 9]))\no2.setTranslation(np.array([1.9999, 0, -1]))\n");
    EXPECT_EQ(found.pair.a.vertices[7], Vec3d(1, 2, 3));
    ASSERT_EQ(found.pair.b.vertices.size(), 4U);
    EXPECT_EQ(found.pair.b.vertices[1], Vec3d(1.5, 0, 0));
    EXPECT_TRUE(found.pair.pose_a.translation.isZero(0)) << "a comment";
    EXPECT_EQ(found.pair.pose_b.translation, Vec3d(1.9999, 0, -1));
}

TEST(Dump, OfBullet) {
    const PastedPair found = pasted(
        "btConvexHullShape hullA;\nhullA.addPoint(btVector3(0, 0, 0));\nhullA.addPoint(btVector3(1.0f, 0, 0));\n"
        "hullA.addPoint(btVector3(0, 1, 0));\nhullA.addPoint(btVector3(0, 0, 1));\n"
        "btBoxShape boxB(btVector3(0.5f, 1, 2));\nbtTransform trB;\n"
        "trB.setBasis(btMatrix3x3(0, -1, 0, 1, 0, 0, 0, 0, 1));\ntrB.setOrigin(btVector3(3, 2, 1));\n");
    ASSERT_EQ(found.pair.a.vertices.size(), 4U);
    EXPECT_EQ(found.pair.a.vertices[1], Vec3d(1, 0, 0));
    EXPECT_EQ(found.pair.b.vertices[7], Vec3d(0.5, 1, 2)) << "halves of the sides";
    EXPECT_EQ(found.pair.pose_b.translation, Vec3d(3, 2, 1));
    EXPECT_EQ(found.pair.pose_b.rotation(0, 1), -1);
}

/// A quarter turn about z.
TEST(Dump, OfAQuaternion) {
    const PastedPair found = pasted(
        "Box a(1, 1, 1); Box b(1, 1, 1);\nt2.setRotation(btQuaternion(0, 0, 1, 1));\nt2.setOrigin(btVector3(0, 3, 0));");
    Mat3d turn;
    turn << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    EXPECT_EQ(found.pair.pose_b.rotation, turn);
}

TEST(Dump, OfCodeThatDoesNotSayAll) {
    EXPECT_THAT(refusal("Box a(1, 1, 1);"), HasSubstr("1 shapes are in it, wants two"));
    EXPECT_THAT(refusal("Box a(1, 1, 1); Sphere b(1);"), HasSubstr("Sphere"));
    EXPECT_THAT(refusal("Box a(1, 1, 1); Box b(1, 1, 1);\npose.setTranslation(Vec3f(0, 0, 1));"),
                HasSubstr("call it pose1 or pose2"));
    EXPECT_THAT(refusal(" \n"), HasSubstr("nothing in it"));
}

TEST(Dump, OfACaseOverSeveralLines) {
    const PastedPair found =
        pasted("{\"id\": 7, \"a\": {\"vertices\": [[0,0,0]]},\n \"b\": {\"vertices\": [[1,2,2]]}}");
    EXPECT_EQ(found.pair.id, "7");
    EXPECT_EQ(found.format, "case line");
}

}  // namespace
}  // namespace edgewise::scene
