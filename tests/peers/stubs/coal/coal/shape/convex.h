// SPDX-License-Identifier: MIT
//
// The part of Coal's types that its adapter uses, written from the calls.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <vector>

namespace coal {

using Vec3s = Eigen::Matrix<double, 3, 1>;
using Matrix3s = Eigen::Matrix<double, 3, 3>;
using support_func_guess_t = Eigen::Vector2i;

struct Transform3s {
    Transform3s(const Matrix3s& rotation, const Vec3s& translation) : R(rotation), T(translation) {}
    Matrix3s R;
    Vec3s T;
};

struct Triangle {
    Triangle(std::size_t a, std::size_t b, std::size_t c) : vids{a, b, c} {}
    std::size_t vids[3];
};

template <class Polygon>
struct Convex {
    Convex(std::shared_ptr<std::vector<Vec3s>> vertices, unsigned vertex_count,
           std::shared_ptr<std::vector<Polygon>> faces, unsigned face_count)
        : points(vertices), num_points(vertex_count), polygons(faces), num_polygons(face_count) {}
    std::shared_ptr<std::vector<Vec3s>> points;
    unsigned num_points;
    std::shared_ptr<std::vector<Polygon>> polygons;
    unsigned num_polygons;
};

}  // namespace coal
