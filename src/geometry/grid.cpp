// SPDX-License-Identifier: MIT
#include "edgewise/geometry/grid.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "edgewise/geometry/hull.hpp"

namespace edgewise {

namespace {

/// One less than places fit 16 bits: the box's low corner is rounded down.
constexpr double most_steps = 65534;

std::vector<Vec3d> on_grid(std::span<const Vec3d> points, double eps) {
    const Grid grid(points, eps);
    std::vector<Vec3d> result;
    for (const Vec3d& p : points) result.push_back(grid.at(grid.nearest(p)));
    return result;
}

/// Every plane of the hull has all points on its inner side.
bool contains(const Polyhedron& hull, std::span<const Vec3d> points) {
    return std::all_of(points.begin(), points.end(), [&](const Vec3d& p) {
        return std::all_of(hull.face_planes.begin(), hull.face_planes.end(),
                           [&](const Plane<double>& plane) { return plane.distance(p) <= 0; });
    });
}

}  // namespace

Grid::Grid(std::span<const Vec3d> points, double eps) {
    if (points.empty()) return;
    Vec3d high = points[0];
    low = points[0];
    double reach = 0;
    for (const Vec3d& p : points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
        reach = std::max(reach, max_abs(p));
    }
    const double finest = std::max(max_abs(Vec3d(high - low)) / most_steps, 2 * eps * reach);
    if (finest > 0) step = std::ldexp(1.0, std::ilogb(finest) + 1);
    for (int i = 0; i < 3; ++i) low[i] = std::floor(low[i] / step) * step;
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
    return hull_of_moved(body, on_grid(body.vertices, eps), "16 bits");
}

Result<Polyhedron> round_to_grid_outward(const Polyhedron& body, double eps) {
    Vec3d middle = Vec3d::Zero();
    for (const Vec3d& v : body.vertices) middle += v / static_cast<double>(body.vertex_count());
    const double step = Grid(body.vertices, eps).step;
    Result<Polyhedron> rounded = round_to_grid(body, eps);
    // Growth in steps of a grid step over the extent: most bodies need one or two.
    const double size = extent(body.vertices);
    for (int n = 1; n <= 64 && rounded && rounded->face_count() > 2; ++n) {
        if (contains(*rounded, body.vertices)) return rounded;
        std::vector<Vec3d> grown;
        const double factor = 1 + n * step / size;
        for (const Vec3d& v : body.vertices) grown.push_back(middle + factor * (v - middle));
        rounded = hull_of_moved(body, on_grid(grown, eps), "16 bits");
    }
    return rounded;
}

}  // namespace edgewise
