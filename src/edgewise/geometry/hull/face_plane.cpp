// SPDX-License-Identifier: MIT
//
// Newell's plane; see the header.
#include "edgewise/geometry/hull/face_plane.hpp"

#include "edgewise/geometry/double_double.hpp"

namespace edgewise {
namespace {

Vec3d area_vector(std::span<const Vec3d> vertices, std::span<const Index> ring, double scale) {
    DoubleDoubleVec sum;
    const Vec3d& origin = vertices[ring[0]];
    DoubleDoubleVec previous = exact_difference(vertices[ring[1]], origin, scale);
    for (std::size_t k = 2; k < ring.size(); ++k) {
        const DoubleDoubleVec next = exact_difference(vertices[ring[k]], origin, scale);
        sum = sum + cross(previous, next);
        previous = next;
    }
    return sum.value();
}

/// Minus the middle of <normal, v> over the ring. In two-fold precision: far from the origin the middle of
/// rounded products would be off by more than the offset's own rounding.
double middle_offset(std::span<const Vec3d> vertices, std::span<const Index> ring, const Vec3d& normal) {
    DoubleDouble low = accurate_dot(normal, vertices[ring[0]]);
    DoubleDouble high = low;
    for (const Index v : ring.subspan(1)) {
        const DoubleDouble height = accurate_dot(normal, vertices[v]);
        if ((height - low).value() < 0) low = height;
        if ((height - high).value() > 0) high = height;
    }
    return -((low + high).value() / 2);
}

}  // namespace

Plane<double> face_plane(std::span<const Vec3d> vertices, std::span<const Index> ring, double scale) {
    const Vec3d area = area_vector(vertices, ring, scale);
    const double largest = max_abs(area);
    if (!(largest > 0)) return {Vec3d::Zero(), 0};
    const Vec3d safe = area / largest;  // slivers: the square of the area may vanish
    const Vec3d normal = safe / norm(safe);
    return {normal, middle_offset(vertices, ring, normal)};
}

}  // namespace edgewise
