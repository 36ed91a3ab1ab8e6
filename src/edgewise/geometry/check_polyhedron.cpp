// SPDX-License-Identifier: MIT
//
// Topology first (check_topology.cpp), then geometry, here: planes, convexity, winding. Tolerances: a vertex
// may lie off its face's plane, or above another's, by planarity x extent plus the rounding of the
// offset (offset_rounding x largest coordinate).
#include "edgewise/geometry/check_polyhedron.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "edgewise/geometry/hull/face_shape.hpp"
#include "edgewise/geometry/hull/vertex_boxes.hpp"
#include "edgewise/geometry/message.hpp"
#include "edgewise/geometry/tolerance.hpp"

namespace edgewise {
namespace {

using Violations = std::vector<std::string>;

/// Reports a normal that has not unit length, ring vertices off the plane, and a vertex above the plane.
void check_plane(const Polyhedron& body, const VertexBoxes& boxes, Index f, double tolerance,
                 Violations& found) {
    const Plane<double>& plane = body.face_planes[f];
    const double length = norm(plane.normal);
    if (!(std::abs(length - 1) <= unit_length)) {
        found.push_back(message(face_name(body, f), ": its normal has length ", length, ", expected 1"));
        return;
    }
    for (const HalfEdge h : body.ring_of_face(f)) {
        const double off = std::abs(plane.distance(body.vertices[body.tail(h)]));
        if (off <= tolerance) continue;
        found.push_back(message(face_name(body, f), " is not planar: vertex ", body.input_index[body.tail(h)],
                                " is ", rounded(off), " off"));
        break;
    }
    if (const std::optional<Index> v = boxes.first_above(plane, tolerance)) {
        found.push_back(message("not convex: vertex ", body.input_index[*v], " is ",
                                rounded(plane.distance(body.vertices[*v])), " above ", face_name(body, f)));
    }
}

}  // namespace

Violations check_polyhedron(const Polyhedron& body, double planarity) {
    Violations found = check_topology(body);
    if (!found.empty()) return found;
    if (!std::ranges::all_of(body.vertices, [](const Vec3d& v) { return v.allFinite(); }))
        return {"a vertex is not finite"};
    const double tolerance = shape_tolerance(body, planarity);
    const VertexBoxes boxes(body.vertices);
    for (Index f = 0; f < body.face_count(); ++f) {
        check_plane(body, boxes, f, tolerance, found);
        // A ring must be a convex polygon, counter-clockwise as seen from the plane's positive side.
        if (const std::optional<Index> corner = corner_outside(body, f, tolerance))
            found.push_back(message(face_name(body, f),
                                    ": not a convex polygon run counter-clockwise, see vertex ",
                                    body.input_index[*corner]));
    }
    return found;
}

}  // namespace edgewise
