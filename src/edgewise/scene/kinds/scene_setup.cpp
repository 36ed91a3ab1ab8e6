// SPDX-License-Identifier: MIT
//
// Small measures of bodies that several scenes take.
#include "edgewise/scene/kinds/scene_setup.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace edgewise::scene {

Vec3d vertex_mean(std::span<const Vec3d> vertices) {
    assert(!vertices.empty());
    Vec3d sum = Vec3d::Zero();
    for (const Vec3d& vertex : vertices) sum += vertex;
    return sum / static_cast<double>(vertices.size());
}

double reach(std::span<const Vec3d> vertices, const Vec3d& from) {
    double most = 0;
    for (const Vec3d& vertex : vertices) most = std::max(most, norm(Vec3d(vertex - from)));
    return most;
}

double smallest_dimension(std::span<const Vec3d> vertices) { return box_of(vertices).sides().minCoeff(); }

Aabb world_box(const Polyhedron& body, const Pose& pose) {
    const Vec3d first = pose.apply(body.vertices.front());
    Aabb box{first, first};
    for (const Vec3d& vertex : body.vertices) box.include(pose.apply(vertex));
    return box;
}

double coarse(double x) {
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);  // exact, as are floor and ldexp
    return std::ldexp(std::floor(mantissa * 0x1p24 + 0.5), exponent - 24);
}

double cube_root(double x) {
    assert(x > 0);
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);
    const int thirds = exponent >= 0 ? (exponent + 2) / 3 : exponent / 3;
    const double value = std::ldexp(mantissa, exponent - 3 * thirds);  // in [1/8, 1)
    double root = 1;
    for (int i = 0; i < 8; ++i) root = (2 * root + value / (root * root)) / 3;  // from 1: converged by six
    return std::ldexp(root, thirds);
}

double box_half(double total_volume, double occupancy) {
    return coarse(cube_root(total_volume / occupancy)) / 2;
}

}  // namespace edgewise::scene
