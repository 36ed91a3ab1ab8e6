// SPDX-License-Identifier: MIT
//
// Mesh files written by the test itself: formats, groupings, node transforms, concave and open meshes, and
// files that are no mesh at all.
#include "edgewise/scene/mesh/mesh_file.hpp"

#include <sys/stat.h>

#include <cctype>
#include <chrono>
#include <cstdio>
#include <limits>

#include "edgewise/scene/mesh/mesh_parts.hpp"
#include "geometry_bodies.hpp"
#include "mesh_texts.hpp"

/// Asked by the leak checker of sanitizer builds: Assimp's readers leak when they give up on a damaged file.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libassimp"; }

namespace edgewise::scene {
namespace {

using namespace edgewise::testing;

using Bodies = Result<std::vector<MeshBody>>;

using MeshFile = testing::MeshFolder;

void expect_cube(const Bodies& bodies, double volume_expected) {
    ASSERT_TRUE(bodies) << bodies.error;
    EXPECT_EQ(bodies.warning, "");
    ASSERT_EQ(bodies->size(), 1u);
    const Polyhedron& body = bodies->front().body;
    EXPECT_EQ(body.vertex_count(), 8u);
    EXPECT_EQ(body.face_count(), 6u);
    EXPECT_NEAR(volume(body), volume_expected, 1e-6 * volume_expected);
    EXPECT_EQ(all_violations(body), "");
}

TEST_F(MeshFile, ReadsACubeInEveryFormat) {
    const Points points = box_points(Vec3d(1, 0.5, 0.25));
    for (const auto& [name, text] : every_format) {
        SCOPED_TRACE(name);
        for (const bool each_mesh : {false, true}) {
            const Bodies bodies = read_mesh_file(write(name, text(points, box_faces())), {each_mesh});
            expect_cube(bodies, 1);
            EXPECT_EQ(bodies->front().name, "body");
        }
    }
}

TEST_F(MeshFile, GroupsSeveralMeshes) {
    const Points near = box_points(Vec3d(0.5, 0.5, 0.5));
    const Points far = shifted(near, Vec3d(3, 0, 0));
    const std::string text = obj_object("left", near, box_faces()) + obj_object("right", far, box_faces(), 9);
    const std::string path = write("pair.obj", text);

    const Bodies each = read_mesh_file(path, {.each_mesh = true});
    ASSERT_TRUE(each) << each.error;
    ASSERT_EQ(each->size(), 2u);
    EXPECT_EQ(each.warning, "");
    EXPECT_EQ((*each)[0].name, "pair#1");
    EXPECT_EQ((*each)[1].name, "pair#2");
    for (const MeshBody& part : *each) EXPECT_DOUBLE_EQ(volume(part.body), 1);

    const Bodies one = read_mesh_file(path);
    EXPECT_FALSE(one);
    EXPECT_EQ(one.error,
              path +
                  ": has 2 convex objects, and one hull would have 2 times their volume: take each as a "
                  "body (edgewise sweep --each-mesh), or write a file for each");
}

TEST_F(MeshFile, MakesOneHullOfMeshesThatAreNoBodiesOfTheirOwn) {
    const Points near = box_points(Vec3d(0.5, 0.5, 0.5));
    Faces open = box_faces();
    open.pop_back();
    const Bodies concave =
        read_mesh_file(write("open.obj", obj_object("left", near, open) +
                                             obj_object("right", shifted(near, Vec3d(3, 0, 0)), open, 9)));
    ASSERT_TRUE(concave) << concave.error;
    EXPECT_EQ(concave->front().name, "open");
    EXPECT_DOUBLE_EQ(volume(concave->front().body), 4);
    EXPECT_NE(concave.warning.find("not closed"), std::string::npos) << concave.warning;
    const Bodies touching = read_mesh_file(
        write("row.obj", obj_object("left", near, box_faces()) +
                             obj_object("right", shifted(near, Vec3d(1, 0, 0)), box_faces(), 9)));
    ASSERT_TRUE(touching) << touching.error;
    EXPECT_DOUBLE_EQ(volume(touching->front().body), 2);
}

TEST_F(MeshFile, WarnsOfAConcaveMesh) {
    const LShape shape;
    const std::string path = write("angle.obj", obj_object("angle", shape.points, shape.faces));
    const Bodies bodies = read_mesh_file(path);
    ASSERT_TRUE(bodies) << bodies.error;
    EXPECT_DOUBLE_EQ(volume(bodies->front().body), 3.5);
    EXPECT_EQ(bodies.warning,
              path + ": the mesh is concave; its hull is used, hull volume / mesh volume = 1.1667");
}

TEST_F(MeshFile, SaysWhenTheRatioIsUnknown) {
    Faces open = box_faces();
    open.pop_back();
    const std::string path = write("open.off", off_text(box_points(Vec3d(1, 1, 1)), open));
    const Bodies bodies = read_mesh_file(path);
    ASSERT_TRUE(bodies) << bodies.error;
    EXPECT_DOUBLE_EQ(volume(bodies->front().body), 8);
    EXPECT_NE(bodies.warning.find("not closed"), std::string::npos) << bodies.warning;
    EXPECT_NE(bodies.warning.find("unknown"), std::string::npos) << bodies.warning;
}

TEST_F(MeshFile, APointCloudIsAPointSet) {
    const Bodies bodies = read_mesh_file(write("cloud.ply", ply_text(box_points(Vec3d(1, 1, 1)), {})));
    expect_cube(bodies, 8);
}

TEST_F(MeshFile, AppliesTheTransformsOfAllNodes) {
    const std::string scale = "2 0 0 0  0 3 0 0  0 0 4 0  0 0 0 1";
    const std::string shift = "1 0 0 1  0 1 0 2  0 0 1 3  0 0 0 1";
    const Bodies bodies = read_mesh_file(write("nodes.dae", collada_text(scale, shift)), {.each_mesh = true});
    expect_cube(bodies, 24);
    if (!bodies) return;
    Vec3d low = bodies->front().body.vertices[0];
    for (const Vec3d& v : bodies->front().body.vertices) low = low.cwiseMin(v);
    EXPECT_EQ(low, Vec3d(1, 4.5, 10));  // scaled after the shift: 2 * (1 - 0.5), 3 * (2 - 0.5), 4 * (3 - 0.5)
}

TEST_F(MeshFile, AMirroredNodeStaysConvex) {
    const std::string mirror = "-1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1";
    const std::string same = "1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1";
    expect_cube(read_mesh_file(write("mirror.dae", collada_text(mirror, same))), 1);
}

TEST_F(MeshFile, RefusesFilesThatHoldNoBody) {
    expect_refused(folder() + "/nowhere.obj", "no such file");
    expect_refused(folder(), "is a directory");
    expect_refused(write("empty.obj", ""), "is empty (0 bytes)");
    expect_refused(write("letter.txt", "Dear reader, this is no mesh.\n"), "cannot be read as a mesh");
    expect_refused(write("comment.obj", "# nothing but a comment\n"), "has no mesh inside");
    expect_refused(write("cut.ply", "ply\nformat ascii 1.0\nelement vertex 8\n"),
                   "its PLY header does not end");
    const Points square = {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(1, 1, 0), Vec3d(0, 1, 0)};
    expect_refused(write("square.obj", obj_object("square", square, {{0, 1, 2, 3}})), "flat");
    for (const double value :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        Points broken = box_points(Vec3d(1, 1, 1));
        broken[3].y() = value;
        expect_refused(write("broken.off", off_text(broken, box_faces())),
                       ":6: '" + std::to_string(value) + "': every coordinate must be a finite number");
    }
}

/// Headers like these must not reach the parser: it would search for the end of the header forever, or
/// reserve the announced memory.
TEST_F(MeshFile, RefusesHeadersThatAnnounceMoreThanThereIs) {
    expect_refused(write("blank.ply", "\nply\nformat ascii 1.0\nend_header\n"),
                   "its first line is not 'ply'");
    const std::string more = ", more than its ", cut = "bytes can hold: it is cut short or damaged";
    for (const char* count : {"400000000", "4294967295", "18446744073709551616", "99"}) {
        for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
            const std::string ply =
                std::string("ply\nformat ") + format + " 1.0\nelement vertex " + count +
                "\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n";
            expect_refused(write("much.ply", ply), more);
        }
        const std::string off = std::string("OFF\n") + count + " 1 0\n0 0 0\n";
        expect_refused(write("much.off", off), cut);
        expect_refused(
            write("faces.off", std::string("OFF # no counts here\n# 1 1 1\n1 ") + count + " 0\n0 0 0\n"),
            cut);
    }
    expect_refused(write("words.ply", "ply\nformat ascii 1.0\nelement vertex many\nend_header\n"),
                   "has no count");
    expect_refused(write("named.txt", "ply\nelement vertex 99999\nproperty list uchar int i\nend_header\n"),
                   more);
    expect_refused(write("none.off", "OFF\n# nothing\n"), "its OFF header has no counts");
}

TEST_F(MeshFile, RefusesWhatIsNoRegularFile) {
    const std::string pipe = folder() + "/pipe.stl";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    expect_refused(pipe, "is no regular file");
    expect_refused("/dev/zero", "is no regular file");
}

TEST_F(MeshFile, IsReadUnderLimits) {
    const std::string cube = write("cube.ply", ply_text(grid_points(60, Vec3d(1, 1, 1)), {}));
    using namespace std::chrono_literals;
    const auto late = read_mesh_parts(cube, false, input::GuardLimits{std::uint64_t{1} << 30, 0ms});
    EXPECT_EQ(late.error,
              cube + ": cannot be read as a mesh: its reader took longer than the 0 s it was given");
    const auto lean = read_mesh_parts(cube, false, input::GuardLimits{0, 60s});
    EXPECT_FALSE(lean);
    EXPECT_NE(lean.error.find("cannot be read as a mesh"), std::string::npos) << lean.error;
    EXPECT_TRUE(read_mesh_parts(cube)) << "which its size allows";
}

TEST_F(MeshFile, ComesBackFromTheReadersProcessWhole) {
    const MeshPart part{"a\nname", {Vec3d(1, -0.0, 1e-300), Vec3d(2, 3, 4)}, {{0, 1, 0}, {1, 1, 1}}, true};
    const auto parts = Result<std::vector<MeshPart>>::success({part, {"", {}, {}}}, "turned");
    const std::string bytes = bytes_of(parts);
    const auto back = parts_from(bytes);
    ASSERT_TRUE(back && back->size() == 2) << back.error;
    EXPECT_EQ((*back)[0].name, part.name);
    EXPECT_EQ((*back)[0].points, part.points);
    EXPECT_TRUE((*back)[0].in_single);
    EXPECT_FALSE((*back)[1].in_single);
    EXPECT_EQ(back.warning, "turned");
    EXPECT_EQ((*back)[0].triangles, part.triangles);
    EXPECT_EQ(parts_from(bytes_of(Result<std::vector<MeshPart>>::failure("why"))).error, "why");
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_FALSE(parts_from(std::string_view(bytes).substr(0, size))) << size;
}

TEST_F(MeshFile, AnObjUnderAnotherNameIsNotReadInSingle) {
    expect_refused(write("cube.mesh3d", obj_object("cube", box_points(Vec3d(1, 1, 1)), box_faces())),
                   "cannot be read as a mesh");
    const std::string upper =
        write("CUBE.OBJ", obj_object("cube", box_points(Vec3d(1, 0.5, 0.25)), box_faces()));
    expect_cube(read_mesh_file(upper), 1);
    EXPECT_EQ(read_mesh_file(upper)->front().step, 0);
}

TEST_F(MeshFile, NamesTheMeshThatIsFlat) {
    const Points square = {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(1, 1, 0), Vec3d(0, 1, 0)};
    const std::string text = obj_object("solid", box_points(Vec3d(1, 1, 1)), box_faces()) +
                             obj_object("floor", square, {{0, 1, 2, 3}}, 9);
    const Bodies bodies = read_mesh_file(write("room.obj", text), {.each_mesh = true});
    EXPECT_FALSE(bodies);
    EXPECT_NE(bodies.error.find("(mesh 2 'floor'): flat"), std::string::npos) << bodies.error;
}

/// Every second digit becomes another one, which may be a body still.
void damage(char& c, Dice& dice) {
    const bool stays_number = std::isdigit(static_cast<unsigned char>(c)) != 0 && dice.below(2) == 0;
    c = static_cast<char>(stays_number ? '0' + dice.below(10) : dice.below(256));
}

TEST_F(MeshFile, SurvivesGarbage) {
    Dice dice(51);
    const std::string good[] = {obj_object("cube", box_points(Vec3d(1, 1, 1)), box_faces()),
                                off_text(box_points(Vec3d(1, 1, 1)), box_faces()),
                                ply_text(box_points(Vec3d(1, 1, 1)), box_faces()),
                                stl_text(box_points(Vec3d(1, 1, 1)), box_faces())};
    const char* endings[] = {".obj", ".off", ".ply", ".stl"};
    int refused = 0, accepted = 0;
    for (int trial = 0; trial < 200; ++trial) {
        std::string text = good[trial % 4];
        const std::size_t hits = 1 + dice.below(3);
        for (std::size_t k = 0; k < hits; ++k) damage(text[dice.below(text.size())], dice);
        if (trial % 10 == 0) text.resize(dice.below(text.size()) + 1);
        const Bodies bodies = read_mesh_file(write(std::string("garbage") + endings[trial % 4], text));
        if (bodies) {
            EXPECT_EQ(all_violations(bodies->front().body), "");
        } else {
            EXPECT_NE(bodies.error, "");
        }
        ++(bodies ? accepted : refused);
    }
    std::printf("damaged files: %d refused, %d read\n", refused, accepted);
    EXPECT_GT(refused, 20);
    EXPECT_GT(accepted, 20);
}

}  // namespace
}  // namespace edgewise::scene
