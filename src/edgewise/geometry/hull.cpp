// SPDX-License-Identifier: MIT
//
// Hulls by Qhull, made canonical. The output vertices are the input doubles, untouched: only the copy that
// Qhull sees is recentred and scaled. Qhull gets the distinct points in the order of their coordinates, so
// neither duplicates nor the order of the input change the body.
//
// Qhull's answer is checked. It merges facets that rounding cannot distinguish, and the ring of a merged
// facet may be bent inwards. The rule: the corner that bends most is removed (it lies within rounding of
// the remaining body) and the hull is made again. A body that the checker still refuses is made a second
// time in axes of its own, which turns a needle into a round body. The checker decides in the end, and
// every point left out must lie within face_planarity of the body; otherwise there is an error, never an
// unsound body.
#include "edgewise/geometry/hull.hpp"

#include <algorithm>
#include <string>

#include "edgewise/geometry/check_polyhedron.hpp"
#include "edgewise/geometry/hull/extreme_frame.hpp"
#include "edgewise/geometry/hull/face_shape.hpp"
#include "edgewise/geometry/hull/point_set.hpp"
#include "edgewise/geometry/hull/qhull_facets.hpp"
#include "edgewise/geometry/message.hpp"
#include "edgewise/geometry/polyhedron_builder.hpp"

namespace edgewise {
namespace {

using Rings = std::vector<std::vector<Index>>;

/// Removes corners that only two faces share: they lie in the middle of an edge. A ring that shrinks to two
/// corners was a face without area; its two neighbours then meet at that edge.
void drop_middle_vertices(Rings& rings, std::size_t vertices) {
    for (bool changed = true; changed;) {
        std::vector<Index> faces(vertices, 0);
        for (const std::vector<Index>& ring : rings) {
            for (const Index v : ring) ++faces[v];
        }
        changed = false;
        for (std::vector<Index>& ring : rings) {
            changed |= std::erase_if(ring, [&](Index v) { return faces[v] < 3; }) > 0;
        }
        changed |= std::erase_if(rings, [](const std::vector<Index>& ring) { return ring.size() < 3; }) > 0;
    }
}

using Map = std::vector<Vec3d> (*)(std::span<const Vec3d>, std::span<const Index>);

/// One hull of the chosen points, as Qhull sees them through `map`. Points that keep a merged face from being
/// convex are removed from `chosen`, and the hull is made again, until no such point is left.
Result<Polyhedron> hull_through(Map map, std::span<const Vec3d> points, std::vector<Index> chosen) {
    for (;;) {
        QhullFacets facets = qhull_facets(map(points, chosen));
        if (!facets.error.empty()) return Result<Polyhedron>::failure("no hull: " + facets.error);
        drop_middle_vertices(facets.rings, chosen.size());
        Result<Polyhedron> body = build_outward(in_input_order(points, chosen, facets.rings));
        if (!body) return body;
        const double tolerance = shape_tolerance(*body, face_planarity);
        std::vector<Index> blamed;
        for (Index f = 0; f < body->face_count(); ++f)
            if (corner_outside(*body, f, tolerance))
                blamed.push_back(body->input_index[most_reflex_corner(*body, f)]);
        if (blamed.empty()) return body;
        std::erase_if(chosen,
                      [&](Index i) { return std::find(blamed.begin(), blamed.end(), i) != blamed.end(); });
    }
}

/// Returns an empty text when the body is sound and holds all points, up to rounding; else the error.
std::string hull_error(const Polyhedron& body, std::span<const Vec3d> points,
                       std::span<const Index> distinct) {
    const std::vector<std::string> violations = check_polyhedron(body);
    if (!violations.empty()) return violations.front();
    const double tolerance = shape_tolerance(body, face_planarity);
    for (const Index i : distinct) {
        const bool is_vertex = std::binary_search(body.input_index.begin(), body.input_index.end(), i);
        if (is_vertex) continue;  // the checker has seen it
        for (const Plane<double>& plane : body.face_planes) {
            const double above = plane.distance(points[i]);
            if (above > tolerance) return message("vertex ", i, " is ", rounded(above), " outside the hull");
        }
    }
    return {};
}

}  // namespace

Result<Polyhedron> convex_hull(std::span<const Vec3d> points) {
    std::string error = coordinate_error(points);
    if (!error.empty()) return Result<Polyhedron>::failure(std::move(error));
    const std::vector<Index> distinct = distinct_points(points);
    error = flatness_error(points, distinct);
    if (!error.empty()) return Result<Polyhedron>::failure(std::move(error));
    for (const Map map : {normalised, in_own_axes}) {
        Result<Polyhedron> body = hull_through(map, points, distinct);
        error = body ? hull_error(*body, points, distinct) : body.error;
        if (error.empty()) return body;
    }
    return Result<Polyhedron>::failure("no sound hull: " + error);
}

Result<Polyhedron> hull_of_moved(const Polyhedron& body, std::span<const Vec3d> moved, const char* where) {
    if (std::equal(moved.begin(), moved.end(), body.vertices.begin(), body.vertices.end()))
        return Result<Polyhedron>::success(body);
    Result<Polyhedron> hull = hull_of_any(moved);
    if (!hull) return Result<Polyhedron>::failure(message("rounded to ", where, ": ", hull.error));
    for (Index& name : (*hull).input_index) name = body.input_index[name];
    if (const std::size_t lost = body.vertex_count() - hull->vertex_count(); lost > 0)
        hull.warning = message(lost, " of ", body.vertex_count(), " vertices vanish in ", where);
    if (body.face_count() > 2 && hull->face_count() <= 2)
        hull.warning = message("the body is flat in ", where);
    return hull;
}

std::string single_range_error(const Polyhedron& body) {
    for (std::size_t v = 0; v < body.vertex_count(); ++v)
        if (!(max_abs(to_single(body.vertices[v])) <= largest_coordinate_single))
            return message("vertex ", body.input_index[v], ": ", max_abs(body.vertices[v]), " is beyond ",
                           largest_coordinate_single, ", the range of single precision; scale the body down");
    return {};
}

Result<Polyhedron> round_to_single(const Polyhedron& body) {
    std::string error = single_range_error(body);
    const double width = widest_extent(body.vertices);
    if (error.empty() && width > 0 && width < smallest_extent_single)
        error = message("the body is ", width, " wide, below ", smallest_extent_single,
                        ", the range of single precision; scale the body up");
    if (!error.empty()) return Result<Polyhedron>::failure(std::move(error));
    std::vector<Vec3d> single;
    for (const Vec3d& vertex : body.vertices) single.push_back(to_single(vertex));
    return hull_of_moved(body, single, "single precision");
}

}  // namespace edgewise
