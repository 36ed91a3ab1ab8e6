// SPDX-License-Identifier: MIT
//
// Small bodies in the text formats of mesh files, a folder for files that a test writes, and what a refusal
// looks like.
#pragma once

#include <string>
#include <utility>

#include "../temporary_folder.hpp"
#include "edgewise/scene/mesh/mesh_file.hpp"
#include "geometry_bodies.hpp"

namespace edgewise::testing {

inline std::string coordinates(const Vec3d& p) {
    return std::to_string(p.x()) + " " + std::to_string(p.y()) + " " + std::to_string(p.z());
}

/// OBJ counts vertices from 1, through the whole file.
inline std::string obj_object(const std::string& name, const Points& points, const Faces& faces,
                              Index first = 1) {
    std::string text = "o " + name + "\n";
    for (const Vec3d& p : points) text += "v " + coordinates(p) + "\n";
    for (const std::vector<Index>& face : faces) {
        text += "f";
        for (const Index v : face) text.append(" ").append(std::to_string(v + first));
        text += "\n";
    }
    return text;
}

inline Points shifted(Points points, const Vec3d& shift) {
    for (Vec3d& p : points) p += shift;
    return points;
}

inline std::string off_text(const Points& points, const Faces& faces) {
    std::string text = "OFF\n" + std::to_string(points.size()) + " " + std::to_string(faces.size()) + " 0\n";
    for (const Vec3d& p : points) text += coordinates(p) + "\n";
    for (const std::vector<Index>& face : faces) {
        text += std::to_string(face.size());
        for (const Index v : face) text.append(" ").append(std::to_string(v));
        text += "\n";
    }
    return text;
}

inline std::string ply_text(const Points& points, const Faces& faces) {
    std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(points.size()) +
                       "\nproperty float x\nproperty float y\nproperty float z\n";
    if (!faces.empty()) {
        text += "element face " + std::to_string(faces.size()) + "\nproperty list uchar int vertex_indices\n";
    }
    text += "end_header\n";
    const std::string off = off_text(points, faces);
    return text + off.substr(off.find('\n', 4) + 1);
}

inline std::string stl_text(const Points& points, const Faces& faces) {
    std::string text = "solid body\n";
    for (const std::vector<Index>& face : faces) {
        for (std::size_t k = 1; k + 1 < face.size(); ++k) {
            text += "facet normal 0 0 0\nouter loop\n";
            for (const Index v : {face[0], face[k], face[k + 1]})
                text += "vertex " + coordinates(points[v]) + "\n";
            text += "endloop\nendfacet\n";
        }
    }
    return text + "endsolid body\n";
}

inline std::string obj_text(const Points& points, const Faces& faces) {
    return obj_object("part", points, faces);
}

using MeshWriter = std::string (*)(const Points&, const Faces&);
inline constexpr std::pair<const char*, MeshWriter> every_format[] = {
    {"body.obj", obj_text}, {"body.stl", stl_text}, {"body.ply", ply_text}, {"body.off", off_text}};

/// A unit cube under two nested nodes, each with its own matrix.
inline std::string collada_text(const std::string& outer_matrix, const std::string& inner_matrix) {
    std::string positions;
    for (const Vec3d& p : box_points(Vec3d(0.5, 0.5, 0.5))) positions += coordinates(p) + " ";
    std::string corners;
    for (const std::vector<Index>& face : box_faces()) {
        for (const Index v : face) corners += std::to_string(v) + " ";
    }
    return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="1"/><up_axis>Y_UP</up_axis></asset>
<library_geometries><geometry id="g" name="g"><mesh>
<source id="p"><float_array id="a" count="24">)" +
           positions + R"(</float_array><technique_common><accessor source="#a" count="8" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor>
</technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<polylist count="6"><input semantic="VERTEX" source="#v" offset="0"/><vcount>4 4 4 4 4 4</vcount><p>)" +
           corners + R"(</p></polylist></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="outer"><matrix>)" +
           outer_matrix + R"(</matrix><node id="inner"><matrix>)" + inner_matrix +
           R"(</matrix><instance_geometry url="#g"/></node></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>
)";
}

/// An L of three unit squares, one unit deep: volume 3, hull volume 3.5.
struct LShape {
    Points points;
    Faces faces{{5, 4, 3, 2, 1, 0}, {6, 7, 8, 9, 10, 11}};

    LShape() {
        const double outline[6][2] = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
        for (const double z : {0.0, 1.0}) {
            for (const auto& corner : outline) points.push_back(Vec3d(corner[0], corner[1], z));
        }
        for (Index k = 0; k < 6; ++k) faces.push_back({k, (k + 1) % 6, 6 + (k + 1) % 6, 6 + k});
    }
};

/// A folder of its own for each test, removed at its end.
class MeshFolder : public ::testing::Test {
  protected:
    std::string write(const std::string& name, const std::string& text) { return folder_.write(name, text); }
    [[nodiscard]] std::string folder() const { return folder_.path().string(); }

  private:
    const TemporaryFolder folder_;
};

inline void expect_said(const std::string& error, const std::string& said) {
    EXPECT_NE(error.find(said), std::string::npos) << error << " | " << said;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
}

inline void expect_refused(const std::string& path, const std::string& expected) {
    for (const bool each_mesh : {false, true}) {
        const auto bodies = scene::read_mesh_file(path, {each_mesh});
        EXPECT_FALSE(bodies) << path;
        EXPECT_EQ(bodies.error.rfind(path, 0), 0u) << bodies.error;
        expect_said(bodies.error, expected);
    }
}

}  // namespace edgewise::testing
