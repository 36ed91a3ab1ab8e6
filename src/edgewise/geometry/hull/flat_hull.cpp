// SPDX-License-Identifier: MIT
//
// The vertices keep the input's coordinates. The corners of a polygon are found in its own plane, where each
// axis is scaled to about 1 (extreme_frame.hpp), by Andrew's monotone chain ("Another efficient algorithm for
// convex hulls in two dimensions", 1979). A corner that is straight to within rounding is left out.
#include <algorithm>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "edgewise/geometry/hull.hpp"
#include "edgewise/geometry/hull/extreme_frame.hpp"
#include "edgewise/geometry/hull/point_set.hpp"
#include "edgewise/geometry/polyhedron_builder.hpp"
#include "edgewise/geometry/tolerance.hpp"

namespace edgewise {
namespace {

Polyhedron point_body(const Vec3d& point, Index name) {
    Polyhedron body;
    body.vertices = {point};
    body.input_index = {name};
    body.face_offset = {0};
    body.vertex_offset = {0, 0};
    return body;
}

/// Segment between the two extreme points, in the order of the input.
Polyhedron segment_of(std::span<const Vec3d> points, std::span<const Index> distinct) {
    const std::vector<Vec3d> along = in_own_axes(points, distinct);
    const auto [low, high] = std::minmax_element(
        along.begin(), along.end(), [](const Vec3d& p, const Vec3d& q) { return p.x() < q.x(); });
    const auto number = [&](auto at) { return distinct[static_cast<std::size_t>(at - along.begin())]; };
    const auto [tail, head] = std::minmax({number(low), number(high)});
    Polyhedron body;
    body.vertices = {points[tail], points[head]};
    body.input_index = {tail, head};
    body.edges = {{0, 1, no_face, no_face}};
    body.face_offset = {0};
    body.vertex_offset = {0, 1, 2};
    body.vertex_ring = {0, 1};
    return body;
}

/// Returns true if p, q, r turn left; reads only x and y.
bool turns_left(const Vec3d& p, const Vec3d& q, const Vec3d& r) {
    return (q.x() - p.x()) * (r.y() - q.y()) - (q.y() - p.y()) * (r.x() - q.x()) > straight_corner;
}

/// Returns the ring counter-clockwise, as positions in `flat`.
std::vector<Index> polygon_ring(const std::vector<Vec3d>& flat) {
    std::vector<Index> order(flat.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::sort(order.begin(), order.end(), [&](Index i, Index j) {
        return std::pair(flat[i].x(), flat[i].y()) < std::pair(flat[j].x(), flat[j].y());
    });
    std::vector<Index> ring;
    const auto add_chain = [&](auto first, auto last) {
        const std::size_t base = ring.size();
        for (auto i = first; i != last; ++i) {
            while (ring.size() >= base + 2 &&
                   !turns_left(flat[ring[ring.size() - 2]], flat[ring.back()], flat[*i])) {
                ring.pop_back();
            }
            ring.push_back(*i);
        }
        ring.pop_back();  // it opens the other chain
    };
    add_chain(order.begin(), order.end());
    add_chain(order.rbegin(), order.rend());
    return ring;
}

/// The polygon with both its faces; the back is the front's plane reversed, to the bit.
Result<Polyhedron> polygon_of(std::span<const Vec3d> points, std::span<const Index> distinct) {
    const std::vector<Index> front = polygon_ring(in_own_axes(points, distinct));
    const std::vector<std::vector<Index>> rings = {front, {front.rbegin(), front.rend()}};
    Result<Polyhedron> body = build_polyhedron(in_input_order(points, distinct, rings));
    if (body) {
        const Plane<double>& plane = body->face_planes[0];
        (*body).face_planes[1] = {-plane.normal, -plane.offset};
    }
    return body;
}

}  // namespace

Result<Polyhedron> flat_hull(std::span<const Vec3d> points) {
    std::string error = points.empty() ? "no vertices" : coordinate_error(points);
    if (!error.empty()) return Result<Polyhedron>::failure(std::move(error));
    const std::vector<Index> distinct = distinct_points(points);
    if (distinct.size() == 1) {
        return Result<Polyhedron>::success(point_body(points[distinct[0]], distinct[0]));
    }
    if (extreme_frame(points, distinct).across_line < flat_thickness) {
        return Result<Polyhedron>::success(segment_of(points, distinct));
    }
    return polygon_of(points, distinct);
}

Result<Polyhedron> hull_of_any(std::span<const Vec3d> points) {
    const bool usable = !points.empty() && coordinate_error(points).empty();
    const bool flat = usable && !flatness_error(points, distinct_points(points)).empty();
    return flat ? flat_hull(points) : convex_hull(points);
}

}  // namespace edgewise
