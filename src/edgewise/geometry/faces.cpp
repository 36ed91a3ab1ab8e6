// SPDX-License-Identifier: MIT
//
// Bodies with faces taken as given. Points with equal coordinates become one vertex with the lowest index;
// points in no face are left out with a warning; a body wound inward throughout is reversed.
#include <algorithm>
#include <string>

#include "edgewise/geometry/check_polyhedron.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/geometry/hull/face_shape.hpp"
#include "edgewise/geometry/hull/point_set.hpp"
#include "edgewise/geometry/message.hpp"
#include "edgewise/geometry/polyhedron_builder.hpp"

namespace edgewise {
namespace {

using Faces = std::span<const std::vector<Index>>;

std::string index_error(std::size_t points, Faces faces) {
    if (faces.size() < 4) return message(faces.size(), " faces; a solid needs at least 4");
    for (std::size_t f = 0; f < faces.size(); ++f) {
        for (const Index v : faces[f]) {
            if (v < points) continue;
            return message("face ", f, " names vertex ", v, ", but there are only ", points, " (0 to ",
                           points - 1, ")");
        }
    }
    return {};
}

/// The vertices that faces use, in input order, equal points welded.
FaceRings welded(std::span<const Vec3d> points, Faces faces) {
    const std::vector<Index> first = first_of_equals(points);
    std::vector<Index> number(points.size(), 0);
    for (const std::vector<Index>& face : faces) {
        for (const Index v : face) number[first[v]] = 1;
    }
    FaceRings result;
    for (Index v = 0; v < points.size(); ++v) {
        if (number[v] == 0) continue;
        number[v] = static_cast<Index>(result.vertices.size());
        result.vertices.push_back(points[v]);
        result.input_index.push_back(v);
    }
    for (const std::vector<Index>& face : faces) {
        std::vector<Index>& ring = result.rings.emplace_back();
        for (const Index v : face) ring.push_back(number[first[v]]);
    }
    return result;
}

std::string unused_warning(std::span<const Vec3d> points, Faces faces) {
    std::vector<bool> used(points.size(), false);
    for (const std::vector<Index>& face : faces) {
        for (const Index v : face) used[v] = true;
    }
    const auto unused = std::count(used.begin(), used.end(), false);
    if (unused == 0) return {};
    const auto first = std::find(used.begin(), used.end(), false) - used.begin();
    return message(unused, " vertices are in no face and were left out, the first is vertex ", first);
}

/// Returns the hull of the vertices of a body with faces that single precision bent.
Result<Polyhedron> hull_of_bent(const Polyhedron& given) {
    Result<Polyhedron> hull = convex_hull(given.vertices);
    if (!hull) return hull;
    for (Index& name : (*hull).input_index) name = given.input_index[name];
    hull.warning = "the faces are bent by the rounding of their vertices; took the hull instead";
    return hull;
}

}  // namespace

Result<Polyhedron> polyhedron_from_faces(std::span<const Vec3d> points, Faces faces) {
    std::string error = coordinate_error(points);
    if (error.empty()) error = index_error(points.size(), faces);
    if (!error.empty()) return Result<Polyhedron>::failure(std::move(error));
    FaceRings rings = welded(points, faces);
    error = flatness_error(rings.vertices, distinct_points(rings.vertices));
    if (!error.empty()) return Result<Polyhedron>::failure(std::move(error));
    Result<Polyhedron> body = build_outward(std::move(rings));
    if (!body) return body;
    for (Index f = 0; f < body->face_count(); ++f)
        if (!(max_abs(body->face_planes[f].normal) > 0))
            return Result<Polyhedron>::failure(face_name(*body, f) + " has no area");
    const std::vector<std::string> violations = check_polyhedron(*body);
    if (!violations.empty()) {
        if (check_polyhedron(*body, single_planarity).empty()) {
            Result<Polyhedron> hull = hull_of_bent(*body);
            if (hull) add_warning(hull.warning, unused_warning(points, faces));
            return hull;
        }
        return Result<Polyhedron>::failure("the faces do not bound a convex solid: " + violations.front() +
                                           "; leave them out to get the hull");
    }
    body.warning = unused_warning(points, faces);
    return body;
}

}  // namespace edgewise
