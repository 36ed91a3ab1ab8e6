// SPDX-License-Identifier: MIT
//
// Pasted texts: every form gives its pair, and a text that is not understood to its end is refused
// with its reason.
#include "edgewise/scene/dumps/dump.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <numbers>

#include "edgewise/scene/case_text.hpp"
#include "edgewise/scene/motion.hpp"

namespace edgewise::scene {
namespace {

using testing::HasSubstr;

PastedPair pasted(const std::string& text) {
    auto result = read_pasted(text, "here");
    EXPECT_TRUE(result) << result.error << " in " << text;
    return result ? *result : PastedPair{};
}

std::string refusal(const std::string& text) {
    const auto result = read_pasted(text, "here");
    EXPECT_FALSE(result) << text;
    EXPECT_THAT(result.error, testing::StartsWith("here: "));
    EXPECT_THAT(result.error, testing::Not(HasSubstr("\n")));
    return result.error;
}

const std::string dump_vertices =
    "Convex<double>(\n  std::make_shared<std::vector<Vector3<double>>>(\n"
    "    std::initializer_list<Vector3<double>>{\n      Vector3<double>(0, 0, 0),\n"
    "      Vector3<double>(1, 0, -0.5),\n      Vector3<double>(0, 1e-3, 0),\n      Vector3<double>(0, 0, 1),}),\n";
const std::string faces =
    "    4,\n    std::make_shared<std::vector<int>>(\n        std::initializer_list<int>{\n"
    "             3, 0, 2, 1, 3, 0, 1, 3, 3, 1, 2, 3, 3, 0, 3, 2,}),\n    false);\n";
const std::string convex = dump_vertices + faces;
const std::string x_1 = "1, 0, 0, 5,\n0, 0, -1, 6,\n0, 1, 0, 7,\n0, 0, 0, 1;\n",
                  identity = "1, 0, 0, 0,\n0, 1, 0, 0,\n0, 0, 1, 0,\n0, 0, 0, 1;\n";

/// A message in the form that FCL prints.
std::string message_of(const std::string& shape_1, const std::string& pose_1,
                       const std::string& shape_2 = "Box<double>(1, 2, 3);",
                       const std::string& pose_2 = identity) {
    return "Error with configuration\n  Original error message: a/b.h:(7): f(): it broke\n  Shape 1:\n" +
           shape_1 + "\n  X_FS1\n" + pose_1 + "  Shape 2:\n" + shape_2 + "\n  X_FS2\n" + pose_2 +
           "  Solver: x";
}

TEST(Dump, OfFclWithCommas) {
    for (const std::string& shape : {convex, dump_vertices + "    4,\n"}) {
        const PastedPair found = pasted(message_of(shape, x_1));
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
}

TEST(Dump, OfFclInColumnsAndQuoted) {
    const PastedPair found = pasted(
        "> Shape 1: Box0.5 0.25 4\n> X_FS1\n> 1 0 0 1.5\n> 0 1 0 -2\n> 0 0 1 3e-2\n> 0 0 0 1\n> Shape 2: Box 1 1 1\n"
        "> X_FS2\n> 0 -1 0 0\n> 1 0 0 0\n> 0 0 1 0\n");
    EXPECT_EQ(found.pair.a.vertices[7], Vec3d(0.25, 0.125, 2));
    EXPECT_EQ(found.pair.pose_a.translation, Vec3d(1.5, -2, 3e-2));
    EXPECT_EQ(found.pair.pose_b.rotation(0, 1), -1) << "twelve numbers do";
}

/// Prose before and behind the message, line ends of Windows, vertices added to a message that counts them.
TEST(Dump, OfFclAsPeopleQuoteIt) {
    const std::string row = "1 0 0 2\r\n0 1 0 3\r\n0 0 1 4\r\n0 0 0 1\r\n";
    const PastedPair found = pasted(
        "It threw:\r\n\r\nShape 1: Convex(v count: 2, f count: 28)\r\nVector3<double>(1, 2, 3),\r\n"
        "Vector3<double>(4, 5, 6)\r\nX_FS1:\r\n" +
        row + "Shape 2: Box1 1 1\r\nX_FS2\r\n" + row + "\r\nAny idea why?\r\n");
    EXPECT_EQ(found.pair.a.vertices, (std::vector<Vec3d>{{1, 2, 3}, {4, 5, 6}}));
    EXPECT_EQ(found.pair.pose_a.translation, Vec3d(2, 3, 4));
    EXPECT_EQ(found.pair.pose_b.translation, Vec3d(2, 3, 4));
}

TEST(Dump, OfFclThatHasNoPolyhedron) {
    for (const char* curved : {"Sphere", "Ellipsoid", "Capsule", "Cone", "Cylinder"}) {
        EXPECT_THAT(refusal(message_of(std::string(curved) + "(0.1, 2)", x_1)), HasSubstr(curved));
        EXPECT_THAT(refusal(message_of(convex, x_1, std::string(curved) + "<double>(0.1, 2);")),
                    HasSubstr("no polyhedron"));
    }
    for (const char* other : {"Halfspace<double>(1, 0, 0, 1);", "TriangleP", "", "???"})
        EXPECT_THAT(refusal(message_of(other, x_1)), HasSubstr("neither a Box nor a Convex"));
    EXPECT_THAT(refusal("Shape 1: Convex(v count: 16, f count: 28)\nX_FS1\nShape 2: Box1 1 1\nX_FS2\n"),
                HasSubstr("counts alone"));
}

/// A matrix that has not all its numbers, or more, or is no rigid motion.
TEST(Dump, OfFclWithAPoseThatIsNone) {
    const std::vector<std::array<std::string, 2>> refused = {
        {"1 0 0\n", "has 3 numbers and needs 12 or 16"},
        {"", "has 0 numbers"},
        {"1 0 0 0\n0 1 0 0\n0 0 1 0\n0\n", "has 13 numbers"},
        {"1 0 0 0\n0 1 0 0\n0 0 1\n", "has 11 numbers"},
        {identity + "0 0 0 1\n", "has 20 numbers"},
        {identity + "7\n", "has 17 numbers"},
        {"1 0 0\n0 0 1 0 0\n0 0 1 0\n", "row 1 of"},
        {"1 0 0 0 0\n1 0 0\n0 0 1 0\n0 0 0 1\n", "row 1 of"},
        {"1 0 0 0\n0 1 0 nan\n0 0 1 0\n0 0 0 1\n", "'nan' is no number"},
        {"1 0 0 0\n0 1 0 0\n0 0 1 0\nnan nan nan nan\n", "is no number"},
        {"1 0 0 0\n0 1 0 inf\n0 0 1 0\n0 0 0 1\n", "'inf' is no number"},
        {"1 0 0 0\n0 1 0 0x10\n0 0 1 0\n0 0 0 1\n", "x10"},
        {"1 0 0 0\n0 1 0 1e999\n0 0 1 0\n0 0 0 1\n", "1e999"},
        {"1 0 0 0\n0 1 0 2 // was 3\n0 0 1 0\n0 0 0 1\n", "// was 3"},
        {"1,, 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n", "no number where one is wanted"},
        {"1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 2\n", "the fourth row of"},
        {"1 0 0 0\n0 1 0 0\n0 0 1 0\n1 2 3 1\n", "the fourth row of"},
        {"0.001 0 0 0\n0 0.001 0 0\n0 0 0.001 0\n0 0 0 1\n", "0.001 times a rotation"},
        {"0 0 0 0\n0 0 0 0\n0 0 0 0\n0 0 0 1\n", "is zero"},
        {"1 0 0 0\n0 1 0 0\n0 0 -1 0\n0 0 0 1\n", "mirror image"},
        {"1 0 0 0\n0 1 0 0\n0 1 0 0\n0 0 0 1\n", "flattens"}};
    for (const auto& [pose, why] : refused) {
        EXPECT_THAT(refusal(message_of(convex, pose)), testing::AllOf(HasSubstr(why), HasSubstr("X_FS1")))
            << pose;
        EXPECT_THAT(refusal(message_of(convex, x_1, "Box1 1 1", pose)),
                    testing::AllOf(HasSubstr(why), HasSubstr("X_FS2")))
            << pose;
    }
    EXPECT_THAT(refusal(message_of(convex, identity + "and then\n")), HasSubstr("'and then' is no number"));
}

/// Half a shape.
TEST(Dump, OfFclWithAShapeThatIsNotUnderstood) {
    const auto without = [](std::string text, const std::string& part) {
        return text.replace(text.find(part), part.size(), "");
    };
    const std::vector<std::array<std::string, 2>> refused = {
        {"Box1 1", "the box"},
        {"Box 1 1 1 1", "from '1' on"},
        {"Box<double>(1, 2);", "the box"},
        {"Box<double>(1, 2, 3, 4);", "the box"},
        {"Box 1 -1 1", "a side of -1"},
        {"Box 1 0 1", "a side of 0"},
        {"Box 1 1 nan", "'nan'"},
        {"Box a b c", "'a b c'"},
        {"Box 1 1 1 moved by hand", "'moved by hand'"},
        {"Convex(v count: 3, f count: 4) Vector3<double>(0, 0, 0), Vector3<double>(1, 0, 0)",
         "says that it has 3 vertices, and 2 are given"},
        {"Convex(v count: 1, f count: 4) Vector3<double>(0, 0, 0), Vector3<double>(1, 0, 0)",
         "says that it has 1 vertices, and 2 are given"},
        {"Convex(v count: 2.5, f count: 4) Vector3<double>(0, 0, 0)", "no whole number"},
        {"Convex(v count: 1)", "the Convex"},
        {without(convex, "      Vector3<double>(0, 0, 1),"), "has vertex 3, counted from 0, but 3 are given"},
        {without(convex, "1e-3, "), "a vertex of the Convex"},
        {without(convex, "3, 1, 2, 3, "), "says that it has 4 faces, and 3 are given"},
        {without(convex, " 3, 0, 3, 2,"), "says that it has 4 faces, and 3 are given"},
        {without(convex, " 3, 0, 2, 1,"), "says that it has 4 faces, and 3 are given"},
        {without(convex, "false);"), "the Convex"},
        {without(convex, "std::initializer_list<int>{"), "the Convex"},
        {without(dump_vertices, "}),"), "is cut off"},
        {dump_vertices, "is cut off"},
        {convex + "Convex<double>(", "from 'Convex<double>(' on"},
        {"Convex<double>(points, 4, faces)", "the Convex"}};
    for (const auto& [shape, why] : refused) {
        EXPECT_THAT(refusal(message_of(shape, x_1)), HasSubstr(why)) << shape;
        EXPECT_THAT(refusal(message_of("Box1 1 1", x_1, shape)), HasSubstr(why)) << shape;
    }
}

TEST(Dump, OfFclThatIsNotOneWholeMessage) {
    EXPECT_THAT(refusal("Shape 1: Box1 1 1\nX_FS1\n" + x_1), HasSubstr("there is no 'Shape 2'"));
    EXPECT_THAT(refusal("Shape 1: Box1 1 1\nX_FS1\n" + x_1 + "Shape 2: Box1 1 1\n"),
                HasSubstr("there is no 'X_FS2'"));
    EXPECT_THAT(refusal("Shape 1: Box1 1 1\nShape 2: Box1 1 1\nX_FS2\n" + x_1),
                HasSubstr("there is no 'X_FS1'"));
    EXPECT_THAT(refusal("X_FS1\n" + x_1 + "X_FS2\n" + x_1), HasSubstr("there is no 'Shape 1'"));
    const std::string one = message_of(convex, x_1);
    EXPECT_THAT(refusal(one + "\n" + one), HasSubstr("is in it twice"));
    EXPECT_THAT(refusal(one + "\nX_FS2\n" + x_1), HasSubstr("'X_FS2' is in it twice"));
}

/// No part of them is understood, whatever it is.
TEST(Dump, OfProgramCodeIsRefused) {
    for (const char* code :
         {"s1 = hppfcl.Box(2, 4, 6)\no2.setTranslation(np.array([1.9999, 0, -1]))\n",
          "btBoxShape boxB(btVector3(0.5f, 1, 2));\ntrB.setOrigin(btVector3(3, 2, 1));",
          "auto a = std::make_shared<fcl::Boxd>(1, 1, 1);", "va = [[0,0,0],[1,0,0]]\nvb = [[0,0,0],[1,0,0]]",
          "tf1.translation() = Vector3<double>(0, 4, 0);", "T = pin.SE3(rot, np.array([1.5, 0, 0]))",
          "v 0 0 0\nv 1 0 0\n", "solid x\n", "# a comment", "nobody is wrong", "exact: separated, distance 2",
          "\xff\xfe{"}) {
        EXPECT_THAT(refusal(code),
                    testing::AllOf(HasSubstr("judge reads a case line of JSON"), HasSubstr("--template")))
            << code;
    }
    EXPECT_THAT(refusal(" \n"), testing::AllOf(HasSubstr("nothing in it"), HasSubstr("--template")));
}

TEST(Dump, OfACaseOverSeveralLines) {
    for (const char* mark : {"", "\xef\xbb\xbf", "\n  "}) {
        const PastedPair found = pasted(
            mark +
            std::string("{\"id\": 7, \"a\": {\"vertices\": [[0,0,0]]},\n \"b\": {\"vertices\": [[1,2,2]]}}"));
        EXPECT_EQ(found.pair.id, "7");
        EXPECT_EQ(found.format, "case line");
    }
}

TEST(Dump, OfMoreThanOneCaseIsRefused) {
    const std::string one = R"({"id": 7, "a": {"vertices": [[0,0,0]]}, "b": {"vertices": [[1,2,2]]}})";
    EXPECT_THAT(refusal(one + "\n" + one), HasSubstr("judge takes one case"));
    EXPECT_THAT(refusal("[" + one + "," + one + "]"), HasSubstr("a list of 2 cases"));
    EXPECT_THAT(refusal(one + " read"), HasSubstr("not JSON"));
}

TEST(Dump, ReadsItsOwnTemplate) {
    const PastedPair found = pasted(case_template);
    EXPECT_EQ(found.pair.a.vertices.size(), 4U);
    EXPECT_EQ(found.pair.pose_b.translation, Vec3d(3, 0, 0));
    EXPECT_EQ(found.pair.pose_b.rotation(0, 1), -1);
}

/// For every turn about every kind of axis: the intended axis and angle.
TEST(CaseText, SaysTurnsByAxisAndAngle) {
    for (const double degrees : {0.001, 1.0, 45.0, 90.0, 179.0, 179.99999, 180.0}) {
        for (const Vec3d& axis : {Vec3d(1, 0, 0), Vec3d(0, 0, -1), Vec3d(0.6, 0, 0.8), Vec3d(-0.6, 0.8, 0),
                                  Vec3d(2 / 3.0, -2 / 3.0, 1 / 3.0)}) {
            const Turn turn =
                turn_of(rotation_matrix(rotation_about(axis, degrees / 180 * std::numbers::pi)));
            EXPECT_NEAR(turn.degrees, degrees, 1e-9);
            const double sign = degrees == 180 && dot(turn.axis, axis) < 0 ? -1 : 1;
            EXPECT_LT(max_abs(Vec3d(sign * turn.axis - axis)), 1e-9) << degrees << " about " << axis;
        }
    }
}

/// Time goes with the length of what strangers send, not with its square.
TEST(Dump, OfBracketsEndsSoon) {
    const std::string many(200'000, '[');
    const auto start = std::chrono::steady_clock::now();
    for (const std::string& text : {"vertices = " + many, many, "{\"a\": " + many, "Shape 1: " + many,
                                    "X_FS1" + many, std::string(200'000, '{'), message_of(convex, many),
                                    message_of(many, x_1), message_of("Convex<double>(" + many, x_1),
                                    std::string(400'000, '>'), "Shape 1" + std::string(400'000, '<')})
        EXPECT_LT(refusal(text).size(), 400U);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST(DumpText, ReadsNumbersToTheEnd) {
    EXPECT_EQ(*numbers_in("1, -2.5;\n[3e2] +4"), (std::vector<double>{1, -2.5, 300, 4}));
    EXPECT_EQ(numbers_in("[[1, 0], [0, 1]]")->size(), 4U);
    EXPECT_TRUE(numbers_in("")->empty());
    for (const char* text : {"1,2,3abc", "x", "1,,2", ",1", "1-2", "0x10", "nan", "inf", "-inf", "1e999",
                             "1 2 (3)", "--1", "+-1", "1.2.3", "2.0f", "1;;"})
        EXPECT_FALSE(numbers_in(text)) << text;
}

}  // namespace
}  // namespace edgewise::scene
