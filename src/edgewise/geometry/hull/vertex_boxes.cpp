// SPDX-License-Identifier: MIT
#include "edgewise/geometry/hull/vertex_boxes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "edgewise/geometry/tolerance.hpp"

namespace edgewise {
namespace {

/// About how many vertices a cell holds. With V vertices on a surface there are V / 16 cells: testing that
/// many boxes costs no more than the vertices in the boxes that are opened.
constexpr double vertices_per_cell = 16;

/// Distance from the plane to the box's farthest corner on the positive side.
double reach(const Plane<double>& plane, const Aabb& box) {
    const Vec3d half = (box.high - box.low) / 2;
    return plane.distance(box.low + half) + plane.normal.cwiseAbs().dot(half);
}

}  // namespace

VertexBoxes::VertexBoxes(const std::vector<Vec3d>& vertices) : vertices_(vertices), rounding_(0) {
    if (vertices.empty()) return;
    const Aabb all = box_of(vertices);
    rounding_ = box_rounding * std::max(all.low.cwiseAbs().maxCoeff(), all.high.cwiseAbs().maxCoeff());
    // A surface of n x n x n cells has about 6 n^2 with vertices in them.
    const double per_axis =
        std::ceil(std::sqrt(static_cast<double>(vertices.size()) / (6 * vertices_per_cell)));
    const Vec3d extent = all.sides().cwiseMax(smallest_extent);
    std::map<std::array<int, 3>, std::vector<Index>> grid;
    for (Index v = 0; v < vertices.size(); ++v) {
        const Vec3d place = ((vertices[v] - all.low).cwiseQuotient(extent) * (per_axis - 1)).array().round();
        grid[{static_cast<int>(place.x()), static_cast<int>(place.y()), static_cast<int>(place.z())}]
            .push_back(v);
    }
    for (auto& [place, members] : grid) {
        std::vector<Vec3d> points;
        for (const Index v : members) points.push_back(vertices[v]);
        cells_.push_back({box_of(points), std::move(members)});
    }
}

std::optional<Index> VertexBoxes::first_above(const Plane<double>& plane, double height) const {
    std::optional<Index> first;
    for (const Cell& cell : cells_) {
        if (reach(plane, cell.box) + rounding_ <= height) continue;  // NaN counts as above
        for (const Index v : cell.vertices) {
            if (first && v >= *first) break;
            if (plane.distance(vertices_[v]) <= height) continue;
            first = v;
        }
    }
    return first;
}

}  // namespace edgewise
