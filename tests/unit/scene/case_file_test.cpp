// SPDX-License-Identifier: MIT
//
// Case lines: what is read, and one clear line for everything that is wrong.
#include "edgewise/scene/case_file.hpp"

#include <gtest/gtest.h>

#include <array>
#include <sstream>

#include "edgewise/geometry/check_polyhedron.hpp"
#include "edgewise/geometry/message.hpp"

namespace edgewise::scene {
namespace {

const char* const tetra = R"({"vertices":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]]})";

std::string line_with(const std::string& a, const std::string& rest = "") {
    return R"({"id":"x","a":)" + a + R"(,"b":)" + tetra + rest + "}";
}

Result<Case> parse(const std::string& line) {
    std::string id;
    return parse_case(line, "cases.jsonl:12", id);
}

TEST(CaseFile, ReadsBodiesFacesAndPoses) {
    const Result<Case> c = parse(line_with(
        R"({"vertices":[[0,0,0],[1,0,0],[0,1,0],[0,0,1e-3]],"faces":[[0,2,1],[0,1,3],[1,2,3],[0,3,2]]})",
        R"(,"pose_b":{"R":[0,-1,0,1,0,0,0,0,1],"t":[0.1,-2,3e2]},"expect":{"distance":1},"note":null)"));
    ASSERT_TRUE(c) << c.error;
    EXPECT_EQ(c->id, "x");
    ASSERT_EQ(c->a.vertices.size(), 4U);
    EXPECT_EQ(c->a.vertices[3], Vec3d(0, 0, 1e-3));
    ASSERT_TRUE(c->a.faces);
    EXPECT_EQ(c->a.faces->at(2), (std::vector<Index>{1, 2, 3}));
    EXPECT_FALSE(c->b.faces);
    EXPECT_EQ(c->pose_a.rotation, Mat3d(Mat3d::Identity()));
    EXPECT_EQ(c->pose_b.rotation(0, 1), -1);
    EXPECT_EQ(c->pose_b.rotation(1, 0), 1);
    EXPECT_EQ(c->pose_b.translation, Vec3d(0.1, -2, 300));
}

TEST(CaseFile, BuildsTheHullOrTheGivenFaces) {
    const char* const box =
        R"({"vertices":[[0,0,0],[1,0,0],[0,1,0],[1,1,0],[0,0,1],[1,0,1],[0,1,1],[1,1,1],[0.5,0.5,0.5]]})";
    const Result<Case> c = parse(line_with(box));
    ASSERT_TRUE(c) << c.error;
    const Result<Polyhedron> hull = body_from_case(c->a);
    ASSERT_TRUE(hull) << hull.error;
    EXPECT_EQ(hull->vertex_count(), 8U);
    EXPECT_EQ(hull->edge_count(), 12U);

    // Each side as two coplanar triangles: 18 edges, because faces are taken as given.
    const Result<Case> split = parse(line_with(
        R"({"vertices":[[0,0,0],[1,0,0],[0,1,0],[1,1,0],[0,0,1],[1,0,1],[0,1,1],[1,1,1]],
            "faces":[[0,2,3],[0,3,1],[4,5,7],[4,7,6],[0,1,5],[0,5,4],[2,6,7],[2,7,3],[0,4,6],[0,6,2],[1,3,7],[1,7,5]]})"));
    ASSERT_TRUE(split) << split.error;
    const Result<Polyhedron> given = body_from_case(split->a);
    ASSERT_TRUE(given) << given.error;
    EXPECT_EQ(given->edge_count(), 18U);
    EXPECT_EQ(given->face_count(), 12U);
}

TEST(CaseFile, ABodyThatCannotBeBuiltSaysWhereItStands) {
    const Result<Case> c = parse(line_with(R"({"vertices":[[0,0,0],[1e200,0,0],[0,1,0],[1,1,0]]})"));
    ASSERT_TRUE(c) << c.error;
    const Result<Polyhedron> huge = body_from_case(c->a);
    ASSERT_FALSE(huge);
    EXPECT_EQ(huge.error.rfind("cases.jsonl:12: a: ", 0), 0U) << huge.error;
}

const std::pair<std::string, std::string> bad_lines[] = {
    {line_with(tetra, R"(,"pose_a":{"R":[1,0,0,0,1,0,0,0],"t":[0,0,0]})"),
     "pose_a.R has 8 numbers and needs 9"},
    {line_with(tetra, R"(,"pose_b":{"R":[1,0,0,0,1,0,0,0,1],"t":[0,0,0,0]})"),
     "pose_b.t has 4 numbers and needs 3"},
    {line_with(tetra, R"(,"pose_b":{"R":[1,0,0,0,1,0,0,0,null],"t":[0,0,0]})"),
     "pose_b.R[8] is not a finite number"},
    {line_with(tetra, R"(,"pose_b":[])"), "pose_b is not an object"},
    {line_with("7"), "a is not an object"},
    {line_with("{}"), "a.vertices is missing"},
    {line_with(R"({"vertices":[]})"), "a.vertices is empty"},
    {line_with(R"({"vertices":"no"})"), "a.vertices is not an array"},
    {line_with(R"({"vertices":[[0,0,0],[0,0]]})"), "a.vertices[1] has 2 numbers and needs 3"},
    {line_with(R"({"vertices":[5]})"), "a.vertices[0] is not an array of 3 numbers"},
    {line_with(R"({"vertices":[[0,0,"NaN"]]})"), "a.vertices[0][2] is not a finite number"},
    {line_with(R"({"vertices":[[0,true,0]]})"), "a.vertices[0][1] is not a finite number"},
    {line_with(R"({"vertices":[[0,0,1e999]]})"), "a number is too large for double precision"},
    {line_with(R"({"vertices":[[0,0,0]],"faces":[[0,0,1]]})"),
     "a.faces[0][2] is 1, but there are 1 vertices, counted from 0"},
    {line_with(R"({"vertices":[[0,0,0]],"faces":[[0,-1,0]]})"),
     "a.faces[0][1] is not a vertex number (0, 1, 2 ...)"},
    {line_with(R"({"vertices":[[0,0,0]],"faces":[[0,0.5,0]]})"),
     "a.faces[0][1] is not a vertex number (0, 1, 2 ...)"},
    {line_with(R"({"vertices":[[0,0,0]],"faces":[[0,0]]})"),
     "a.faces[0] is not an array of three or more vertices"},
    {line_with(R"({"vertices":[[0,0,0]],"faces":[]})"),
     "a.faces is empty; leave it out for the hull of the vertices"},
    {R"({"id":"x","a":)" + std::string(tetra) + "}", "b is missing"},
    {R"({"id":[1]})", "id is neither a string nor a whole number"},
    {"[1]", "the line is not a JSON object"},
    {line_with(tetra, R"(,"pose_b":{})"), "pose_b has neither R nor t; leave it out for the identity"},
    {line_with(tetra, R"(,"pose_b":{"R":[[1,0,0],[0,1,0]]})"), "pose_b.R has 2 rows and needs 3"},
    {line_with(tetra, R"(,"pose_b":{"R":[[1,0,0],[0,1],[0,0,1]]})"), "pose_b.R[1] has 2 numbers and needs 3"},
    {line_with(tetra, R"(,"pose_b":{"R":[[1,0,0],0,[0,0,1]]})"), "pose_b.R[1] is not an array of 3 numbers"},
    {line_with(tetra, R"(,"pose_b":{"R":[1,0,0]})"), "pose_b.R has 3 numbers and needs 9"},
    {line_with(tetra, R"(,"pose_b":{"R":"identity"})"), "pose_b.R is not an array"},
    {line_with(tetra, R"(,"pose_b":{"t":5})"), "pose_b.t is not an array of 3 numbers"},
    {line_with(tetra, R"(,"pose_b":{"t":[0,0,1],"t":[0,0,2]})"), "pose_b.t is given twice; keep one of them"},
    {line_with(tetra, R"(,"a":{"vertices":[[0,0,0]]})"), "a is given twice; keep one of them"},
};

TEST(CaseFile, EveryFaultNamesItsLineAndField) {
    for (const auto& [line, error] : bad_lines) {
        const Result<Case> c = parse(line);
        ASSERT_FALSE(c) << line;
        EXPECT_EQ(c.error, "cases.jsonl:12: " + error);
    }
}

/// All of it at once, with what a case looks like: no guessing member by member.
TEST(CaseFile, AllThatALineLacksIsNamed) {
    EXPECT_EQ(parse(R"({"a":1})").error.substr(0, 48), "cases.jsonl:12: id, b are missing; a case is {\"i");
    EXPECT_EQ(parse("{}").error.substr(0, 36), "cases.jsonl:12: id, a, b are missing");
    EXPECT_EQ(parse(R"({"id":"1","a":{},"b":{}})").error.substr(0, 49),
              "cases.jsonl:12: a.vertices, b.vertices are missin");
}

TEST(CaseFile, TakesRowsAndPartsOfAPose) {
    const char* const turned = R"("R":[[0,-1,0],[1,0,0],[0,0,1]])";
    const Result<Case> c =
        parse(line_with(tetra, std::string(R"(,"pose_a":{"t":[1,2,3]},"pose_b":{)") + turned + "}"));
    ASSERT_TRUE(c) << c.error;
    EXPECT_EQ(c->pose_a.translation, Vec3d(1, 2, 3));
    EXPECT_TRUE(c->pose_a.rotation.isIdentity(0));
    EXPECT_TRUE(c->pose_b.translation.isZero(0));
    EXPECT_EQ(c->pose_b.rotation(0, 1), -1);
    EXPECT_EQ(c->pose_b.rotation(1, 0), 1);
    EXPECT_TRUE(parse(line_with(tetra, R"(,"pose_a":{"R":null,"t":[1,2,3]},"pose_b":null)")));
}

/// At every level, with the known name that is nearest.
TEST(CaseFile, UnknownMembersAreRefused) {
    const std::vector<std::array<std::string, 3>> wrong = {
        {line_with(tetra, R"(,"poseB":{"t":[1,0,0]})"), "'poseB' is not a member of a case line", "pose_b"},
        {line_with(tetra, R"(,"POSE_A":{"t":[1,0,0]})"), "'POSE_A' is not a member of a case line", "pose_a"},
        {line_with(tetra, R"(,"pose":{"t":[1,0,0]})"), "'pose' is not a member of a case line", "pose_a"},
        {line_with(tetra, R"(,"pose_bb":{"t":[1,0,0]})"), "'pose_bb' is not a member of a case line",
         "pose_b"},
        {line_with(tetra, R"(,"B":{"vertices":[[0,0,0]]})"), "'B' is not a member of a case line", "b"},
        {line_with(tetra, R"(,"notes":"")"), "'notes' is not a member of a case line", "note"},
        {line_with(tetra, R"(,"pose_b":{"r":[1,0,0,0,1,0,0,0,1]})"), "'r' is not a member of pose_b", "R"},
        {line_with(tetra, R"(,"pose_a":{"T":[1,0,0]})"), "'T' is not a member of pose_a", "t"},
        {line_with(R"({"vertices":[[0,0,0]],"face":[]})"), "'face' is not a member of body a", "faces"},
        {line_with(R"({"vertexes":[[0,0,0]]})"), "'vertexes' is not a member of body a", "vertices"},
    };
    for (const auto& [line, what, near] : wrong) {
        const Result<Case> c = parse(line);
        ASSERT_FALSE(c) << line;
        EXPECT_EQ(c.error.rfind("cases.jsonl:12: " + what + "; did you mean '" + near + "'?", 0), 0U)
            << c.error;
    }
    for (const char* other : {R"(,"pose_b":{"translation":[1,0,0]})", R"(,"pose_b":{"t":[1,0,0],"scale":2})",
                              R"(,"transform":[])", R"(,"":1)", R"(,"margin":0.1)"})
        EXPECT_NE(parse(line_with(tetra, other)).error.find(" is not a member of "), std::string::npos)
            << other;
}

/// Members that are carried along and not read.
TEST(CaseFile, CarriesNotesAndExpectations) {
    for (const char* carried :
         {"source", "expect", "note", "kind", "tags", "shapes", "offset", "max_extent", "ortho_err",
          "input_precision", "thread_says", "agrees_with_thread", "disagreement"})
        EXPECT_TRUE(parse(line_with(tetra, ",\"" + std::string(carried) + R"(":{"any":["thing"]})")))
            << carried;
}

std::string with_matrix(const Mat3d& r, const char* pose = "pose_b") {
    std::string list;
    for (int k = 0; k < 9; ++k) list += (k == 0 ? "" : ",") + message(r(k / 3, k % 3));
    return line_with(tetra, ",\"" + std::string(pose) + R"(":{"R":[)" + list + R"(],"t":[3,0,0]})");
}

/// The names of refused matrices are tested in tests/unit/scene/nearest_rotation_test.cpp.
TEST(CaseFile, RefusesAMatrixThatIsNoRotation) {
    Mat3d shear = Mat3d::Identity(), flat = Mat3d::Identity(), mirror = Mat3d::Identity();
    shear(0, 1) = 0.01;
    flat(2, 2) = 0;
    mirror(1, 1) = -1;
    const Mat3d one = Mat3d::Identity();
    for (const Mat3d& r : {Mat3d(0.001 * one), Mat3d(1000 * one), Mat3d(2 * one), Mat3d(1.001 * one),
                           Mat3d(0 * one), Mat3d(-one), shear, flat, mirror}) {
        for (const char* pose : {"pose_a", "pose_b"}) {
            const Result<Case> c = parse(with_matrix(r, pose));
            ASSERT_FALSE(c) << r;
            EXPECT_EQ(c.error.rfind("cases.jsonl:12: " + std::string(pose) + ".R ", 0), 0U) << c.error;
        }
    }
    EXPECT_EQ(parse(with_matrix(0.001 * one)).error,
              "cases.jsonl:12: pose_b.R is 0.001 times a rotation: scale the vertices instead");
}

TEST(CaseFile, TakesTheNearestRotationAndSaysSoOnce) {
    Mat3d nearly = Mat3d::Identity();
    nearly(0, 1) = 1e-7;
    std::string text;
    for (int i = 0; i < 20; ++i) text += with_matrix(i % 2 == 1 ? nearly : Mat3d(Mat3d::Identity())) + "\n";
    std::istringstream stream(text);
    CaseReader reader(stream, "cases.jsonl");
    int line = 0;
    while (const auto c = reader.next()) {
        ASSERT_TRUE(*c) << c->error;
        EXPECT_LE(ortho_error((**c).pose_b.rotation), 2e-14);
        EXPECT_EQ((**c).pose_b.translation, Vec3d(3, 0, 0));
        EXPECT_EQ(c->warning.empty(), line % 2 == 0);
        if (line % 2 == 1) {
            EXPECT_NEAR((**c).pose_b.rotation(0, 1), 0.5e-7, 1e-13);
        }
        ++line;
    }
    EXPECT_EQ(
        reader.rotation_note(),
        "cases.jsonl: 10 lines have a matrix that is nearly a rotation; the nearest rotation is used (first line "
        "2: pose_b.R is 1e-07 from a rotation)");
}

TEST(CaseFile, SaysWhatOtherJsonIs) {
    for (const char* part : {"{", "[", "{\"id\": \"1\",", "{\"id\": \"cut", "[{\"id\": 1},"})
        EXPECT_NE(parse(part).error.find("write each case on one line"), std::string::npos) << part;
    EXPECT_NE(parse("[" + line_with(tetra) + "," + line_with(tetra) + "]").error.find("a list of 2 cases"),
              std::string::npos);
    EXPECT_EQ(parse("rubbish").error.find("write each"), std::string::npos);
}

TEST(CaseFile, WhatIsNotJsonNamesItsColumn) {
    for (const char* number : {"NaN", "Infinity", "-Infinity", "nan", "1.", "0x1"}) {
        const Result<Case> c = parse(line_with(std::string(R"({"vertices":[[0,0,)") + number + "]]}"));
        ASSERT_FALSE(c) << number;
        EXPECT_EQ(c.error.rfind("cases.jsonl:12: not JSON at column 3", 0), 0U) << c.error;
    }
    for (const char* text : {"{", "", "}", "{\"id\":\"\xff\"}", "{} {}"}) EXPECT_FALSE(parse(text)) << text;
    EXPECT_FALSE(parse(std::string(100000, '[')));
    const std::string deep = std::string(100'000, '[') + std::string(100'000, ']');
    EXPECT_EQ(parse(line_with(R"({"vertices":)" + deep + "}")).error,
              "cases.jsonl:12: nested deeper than 64 levels");
}

TEST(CaseFile, ABadLineDoesNotLoseTheRest) {
    std::istringstream stream(line_with(tetra) + "\r\n\n  \nbroken\n" +
                              R"({"id":17,"a":{},"b":{"vertices":[[0,0,0]]}})"
                              "\n" +
                              line_with(tetra));
    CaseReader reader(stream, "dir/cases.jsonl");
    std::vector<std::string> seen;
    while (const std::optional<Result<Case>> c = reader.next()) {
        seen.push_back(std::to_string(reader.line()) + " '" + reader.id() + "' " + (*c ? "read" : c->error));
    }
    const std::vector<std::string> want = {"1 'x' read", "4 '' dir/cases.jsonl:4: not JSON at column 1",
                                           "5 '17' dir/cases.jsonl:5: a.vertices is missing", "6 'x' read"};
    EXPECT_EQ(seen, want);
}

}  // namespace
}  // namespace edgewise::scene
