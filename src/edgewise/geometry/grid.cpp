// SPDX-License-Identifier: MIT
#include "edgewise/geometry/grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "edgewise/geometry/aabb.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/geometry/hull/face_shape.hpp"
#include "edgewise/geometry/message.hpp"
#include "edgewise/geometry/tolerance.hpp"

namespace edgewise {

namespace {

/// Length of the longest side in steps: the most that 16 bits number, and two less before rounding, which may
/// move both ends of the box by half a step, and its low corner down by one.
constexpr double most_steps = 65535, most_steps_to_round = most_steps - 2;

/// How far a body grows at most before boxes replace it, in grid steps along its longest side.
constexpr int outward_steps = 64;

/// Grid around the points' box. Its step is the power of two above a part of the longest side and `finest`.
Grid grid_around(const Aabb& box, double steps, double finest) {
    Grid grid;
    finest = std::max(max_abs(box.sides()) / steps, finest);
    if (finest > 0) grid.step = std::ldexp(1.0, std::ilogb(finest) + 1);
    for (int i = 0; i < 3; ++i) grid.low[i] = std::floor(box.low[i] / grid.step) * grid.step;
    return grid;
}

/// The finest step whose multiples arithmetic with this rounding holds exactly: `rounding` times the largest
/// coordinate, and in single no less than the distance of its smallest numbers.
double finest_step(const Aabb& box, double rounding, double eps) {
    const double reach = std::max(max_abs(box.low), max_abs(box.high));
    const bool in_single = eps > Tolerance<double>::eps;
    return std::max(rounding * reach, in_single ? double{std::numeric_limits<float>::denorm_min()} : 0);
}

/// Returns each point at its nearest grid place; the points themselves if all lie on the grid already.
std::vector<Vec3d> on_grid(std::span<const Vec3d> points, double eps) {
    const auto moved_to = [&](const Grid& grid) {
        std::vector<Vec3d> result;
        for (const Vec3d& p : points) result.push_back(grid.at(grid.nearest(p)));
        return result;
    };
    std::vector<Vec3d> held = moved_to(Grid::of_rounded(points, eps));
    return std::ranges::equal(held, points) ? held : moved_to(Grid::for_rounding(points, eps));
}

/// Returns true if every point is a vertex of the hull, or inside all planes by more than its vertices may
/// lie off them and a height may be rounded.
bool contains(const Polyhedron& hull, std::span<const Vec3d> points) {
    const double noise = 2 * shape_tolerance(hull, face_planarity);
    return std::all_of(points.begin(), points.end(), [&](const Vec3d& p) {
        const auto is_below = [&](const Plane<double>& plane) { return plane.distance(p) < -noise; };
        const auto& planes = hull.face_planes;
        return (planes.size() > 2 && std::all_of(planes.begin(), planes.end(), is_below)) ||
               std::find(hull.vertices.begin(), hull.vertices.end(), p) != hull.vertices.end();
    });
}

/// Scales the body about its middle by the factor, then moves it to the grid.
Result<Polyhedron> grown(const Polyhedron& body, double factor, double eps) {
    Vec3d middle = Vec3d::Zero();
    for (const Vec3d& v : body.vertices) middle += v / static_cast<double>(body.vertex_count());
    std::vector<Vec3d> points;
    for (const Vec3d& v : body.vertices) points.push_back(middle + factor * (v - middle));
    return hull_of_moved(body, on_grid(points, eps), "16 bits");
}

/// The hull of small boxes around the vertices, two steps to each side: more than rounding moves a corner. It
/// has more vertices than the body, several of one name, and contains it however thin it is.
Result<Polyhedron> hull_of_boxes(const Polyhedron& body, double eps) {
    const double step = Grid::for_rounding(body.vertices, eps).step;
    std::vector<Vec3d> corners;
    for (const Vec3d& v : body.vertices) {
        for (int i = 0; i < 8; ++i) {
            const Vec3d away(i & 1 ? 2 : -2, i & 2 ? 2 : -2, i & 4 ? 2 : -2);
            corners.push_back(v + step * away);
        }
    }
    Result<Polyhedron> hull = hull_of_any(on_grid(corners, eps));
    if (!hull) return hull;
    for (Index& name : (*hull).input_index) name = body.input_index[name / 8];
    return hull;
}

/// Places are numbers of the table's precision.
std::string range_error(const Polyhedron& body, double eps) {
    return eps > Tolerance<double>::eps ? single_range_error(body) : std::string();
}

}  // namespace

Grid Grid::for_rounding(std::span<const Vec3d> points, double eps) {
    if (points.empty()) return {};
    const Aabb box = box_of(points);
    return grid_around(box, most_steps_to_round, finest_step(box, 2 * eps, eps));
}

Grid Grid::of_rounded(std::span<const Vec3d> points, double eps) {
    if (points.empty()) return {};
    const Aabb box = box_of(points);
    return grid_around(box, most_steps, finest_step(box, eps, eps));
}

Grid::Place Grid::nearest(const Vec3d& point) const {
    Place place;
    for (int i = 0; i < 3; ++i) {
        const double steps = std::round((point[i] - low[i]) / step);
        place[static_cast<std::size_t>(i)] = static_cast<std::uint16_t>(std::clamp(steps, 0.0, 65535.0));
    }
    return place;
}

Result<Polyhedron> round_to_grid(const Polyhedron& body, double eps) {
    if (std::string error = range_error(body, eps); !error.empty())
        return Result<Polyhedron>::failure(std::move(error));
    return hull_of_moved(body, on_grid(body.vertices, eps), "16 bits");
}

Result<Polyhedron> round_to_grid_outward(const Polyhedron& body, double eps) {
    Result<Polyhedron> rounded = round_to_grid(body, eps);
    if (body.face_count() <= 2 || !range_error(body, eps).empty()) return rounded;
    if (rounded && rounded->vertices == body.vertices) return rounded;
    // Growth in steps of a grid step over the extent: most bodies need one or two.
    const double growth = Grid::for_rounding(body.vertices, eps).step / extent(body.vertices);
    for (int n = 1; rounded && n <= outward_steps + 1; ++n) {
        if (contains(*rounded, body.vertices)) return rounded;
        rounded = grown(body, 1 + n * growth, eps);
    }
    rounded = hull_of_boxes(body, eps);
    if (rounded && contains(*rounded, body.vertices)) return rounded;
    return Result<Polyhedron>::failure(
        "the body cannot be held by a grid of 16 bits: rounded outward it is still not contained");
}

}  // namespace edgewise
