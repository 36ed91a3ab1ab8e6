// SPDX-License-Identifier: MIT
//
// Signed tetrahedra from the first point; see the header.
#include "edgewise/scene/mesh/mesh_volume.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "edgewise/geometry/hull/point_set.hpp"

namespace edgewise::scene {
namespace {

bool is_closed(std::span<const std::array<Index, 3>> triangles, std::span<const Index> weld) {
    using Arc = std::tuple<Index, Index, bool>;  // lower vertex, higher vertex, run downwards
    std::vector<Arc> arcs;
    for (const std::array<Index, 3>& triangle : triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Index from = weld[triangle[k]];
            const Index to = weld[triangle[(k + 1) % 3]];
            if (from != to) arcs.emplace_back(std::min(from, to), std::max(from, to), from > to);
        }
    }
    std::sort(arcs.begin(), arcs.end());
    for (std::size_t i = 0; i < arcs.size();) {
        const auto [low, high, down] = arcs[i];
        long balance = 0;
        for (; i < arcs.size() && std::get<0>(arcs[i]) == low && std::get<1>(arcs[i]) == high; ++i) {
            balance += std::get<2>(arcs[i]) ? -1 : 1;
        }
        if (balance != 0) return false;
    }
    return true;
}

}  // namespace

std::optional<double> mesh_volume(std::span<const Vec3d> points,
                                  std::span<const std::array<Index, 3>> triangles) {
    if (triangles.empty() || !is_closed(triangles, first_of_equals(points))) return std::nullopt;
    const Vec3d& origin = points[triangles.front()[0]];
    double six_volumes = 0;
    for (const auto& [first, second, third] : triangles) {
        const Vec3d normal = cross(Vec3d(points[second] - origin), Vec3d(points[third] - origin));
        six_volumes += dot(Vec3d(points[first] - origin), normal);
    }
    return std::abs(six_volumes) / 6;
}

}  // namespace edgewise::scene
