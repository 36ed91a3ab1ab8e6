// SPDX-License-Identifier: MIT
//
// Warnings and refusals of mesh files are the same in every format.
#include <tuple>

#include "edgewise/scene/recording.hpp"
#include "mesh_texts.hpp"

namespace edgewise::scene {
namespace {

using namespace edgewise::testing;

using Bodies = Result<std::vector<MeshBody>>;
using MeshNotices = testing::MeshFolder;

/// A flat mesh is refused where a solid is needed, with the vertices that it has, and taken where it may be
/// flat; whatever its format.
TEST_F(MeshNotices, TakesFlatMeshesAlike) {
    const Points square = {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(1, 1, 0), Vec3d(0, 1, 0)};
    const Points line = {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(2, 0, 0), Vec3d(3, 0, 0)};
    for (const auto& [name, text] : every_format) {
        SCOPED_TRACE(name);
        const std::string path = write(name, text(square, {{0, 1, 2, 3}}));
        expect_refused(path, ": flat: all 4 vertices lie in one plane");
        expect_refused(path, "; a solid is needed here: judge takes flat meshes");
        const Bodies polygon = read_mesh_file(path, {.takes_flat = true});
        ASSERT_TRUE(polygon) << polygon.error;
        EXPECT_EQ(polygon->front().points, square);
        EXPECT_EQ(polygon->front().body.face_count(), 2U);
        const std::string thin = write(name, text(line, {{0, 1, 2, 3}}));
        expect_refused(thin, ": flat: all 4 vertices lie on one line");
        EXPECT_EQ(read_mesh_file(thin, {.takes_flat = true})->front().body.vertex_count(), 2U);
    }
}

/// Where a format or its reader keeps single precision, a body far from the origin is not what was written.
TEST_F(MeshNotices, SaysWhereSinglePrecisionIsTooCoarse) {
    const Points box = box_points(Vec3d(0.125, 0.125, 0.125));
    int said = 0;
    for (const auto& [name, text] : every_format) {
        const std::string format = name;
        const bool in_double = format == "body.obj" || format == "body.stl";
        for (const double away : {0.0, 0.5, 2.0, 64.0, 65536.0}) {
            SCOPED_TRACE(format + " " + std::to_string(away));
            const Bodies bodies =
                read_mesh_file(write(name, text(shifted(box, Vec3d(0, away, 0)), box_faces())));
            const bool coarse = !in_double && away > 2;
            EXPECT_EQ(bodies.warning.find("read in single precision") != std::string::npos, coarse)
                << bodies.warning;
            EXPECT_EQ(bodies->front().step == 0, in_double);
            said += coarse ? 1 : 0;
        }
    }
    EXPECT_EQ(said, 4);
}

TEST_F(MeshNotices, SaysThatAMeshEnclosesNoVolume) {
    const Points tetrahedron = {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)};
    for (const auto& [name, text] : every_format) {
        // Two sheets, each run on both sides.
        const Bodies bodies =
            read_mesh_file(write(name, text(tetrahedron, {{0, 1, 2}, {2, 1, 0}, {0, 1, 3}, {3, 1, 0}})));
        EXPECT_EQ(bodies.warning, folder() + "/" + name + ": the mesh encloses no volume; its hull is used");
    }
}

/// COLLADA turns and scales by what the file says, and says so; as stored, it is what its STL twin is.
TEST_F(MeshNotices, SaysWhatAColladaFileDoes) {
    const std::string same = "1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1",
                      lift = "1 0 0 0  0 1 0 0  0 0 1 2  0 0 0 1";
    const std::string plain = collada_text(same, lift);  // z from 1.5 to 2.5
    const auto with = [&](const std::string& unit, const std::string& axis) {
        std::string text = plain;
        text.replace(text.find("meter=\"1\""), 9, "meter=\"" + unit + "\"");
        return text.replace(text.find("Y_UP"), 4, axis + "_UP");
    };
    const auto centre_of = [&](const Bodies& bodies) {
        Vec3d sum = Vec3d::Zero();
        for (const Vec3d& point : bodies->front().points) sum += point / 8;
        return sum;
    };
    const std::string turned_z = "turned from Z up to Y up", turned_x = "turned from X up to Y up";
    const std::tuple<const char*, const char*, std::string, Vec3d> files[] = {
        {"1", "Y", "", Vec3d(0, 0, 2)},
        {"1", "Z", turned_z + " as the file says; --as-stored leaves that out", Vec3d(0, 2, 0)},
        {"1", "X", turned_x + " as the file says; --as-stored leaves that out", Vec3d(0, 0, 2)},
        {"0.001", "Y", "scaled by 0.001 as the file says; --as-stored leaves that out", Vec3d(0, 0, 0.002)},
        {"0.0254", "Z", turned_z + " and scaled by 0.0254 as the file says; --as-stored leaves both out",
         Vec3d(0, 0.0508, 0)}};
    for (const auto& [unit, axis, said, centre] : files) {
        SCOPED_TRACE(std::string(unit) + " " + axis);
        const std::string path = write("link.dae", with(unit, axis));
        const Bodies read = read_mesh_file(path);
        ASSERT_TRUE(read) << read.error;
        EXPECT_EQ(read.warning, said.empty() ? "" : path + ": " + said);
        EXPECT_LT((centre_of(read) - centre).norm(), 1e-7);
        const Bodies stored = read_mesh_file(path, {.as_stored = true});
        ASSERT_TRUE(stored) << stored.error;
        EXPECT_EQ(stored.warning, "");
        EXPECT_EQ(centre_of(stored), Vec3d(0, 0, 2));
    }
}

/// A recording's mesh files are turned as those of --shape; its note says so.
TEST_F(MeshNotices, AreInTheNoteOfARecording) {
    const std::string same = "1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1",
                      lift = "1 0 0 0  0 1 0 0  0 0 1 2  0 0 0 1";
    std::string link = collada_text(same, lift);
    write("link.dae", link.replace(link.find("Y_UP"), 4, "Z_UP"));
    const std::string path =
        write("mine.jsonl", R"({"format":"convex-motion","version":0,"shapes":)"
                            R"([{"type":"mesh","file":"link.dae"}],"bodies":[{"shape":0}]})"
                            "\n"
                            R"({"t":0,"poses":[[0,0,0,1,0,0,0]]})"
                            "\n");
    const auto turned = read_recording(path), stored = read_recording(path, true);
    ASSERT_TRUE(turned && stored) << turned.error << stored.error;
    EXPECT_EQ(turned->note,
              folder() + "/link.dae: turned from Z up to Y up as the file says; --as-stored leaves that out");
    EXPECT_EQ(stored->note, "");
    EXPECT_NE(turned->checksum, stored->checksum);
}

/// Numbers of vertices are a reader's own.
TEST_F(MeshNotices, ShowsNoNumberOfAVertex) {
    const std::string huge = "1e31 0 0 0  0 1e31 0 0  0 0 1e31 0  0 0 0 1";
    const Bodies bodies = read_mesh_file(write("huge.dae", collada_text(huge, huge)));
    EXPECT_FALSE(bodies);
    EXPECT_NE(bodies.error.find(": a vertex: "), std::string::npos) << bodies.error;
}

}  // namespace
}  // namespace edgewise::scene
