// SPDX-License-Identifier: MIT
//
// Names to bodies. Everything goes through convex_hull, as a user's point set does. Next to the bodies that
// the header describes there are box8, a box with unequal sides (1.75, 1 and 0.625 m), and ellipsoidN,
// sphereN with half axes of 1, 0.5 and 0.25 m.
#include "edgewise/scene/shapes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "edgewise/geometry/hull.hpp"
#include "edgewise/input/known_names.hpp"
#include "edgewise/scene/sphere_points.hpp"

namespace edgewise::scene {
namespace {

constexpr double corner = 0.5625;  // 9/16: exact in every precision, radius 0.97 m
constexpr std::string_view sphere_prefix = "sphere", ellipsoid_prefix = "ellipsoid";

/// half: half of each side.
std::vector<Vec3d> box_points(const Vec3d& half) {
    std::vector<Vec3d> points;
    for (int i = 0; i < 8; ++i)
        points.emplace_back(i & 4 ? half[0] : -half[0], i & 2 ? half[1] : -half[1],
                            i & 1 ? half[2] : -half[2]);
    return points;
}

std::vector<Vec3d> tetra_points() {
    return {{corner, corner, corner},
            {corner, -corner, -corner},
            {-corner, corner, -corner},
            {-corner, -corner, corner}};
}

/// Returns the N of a name "sphereN", or of another prefix; no value for other names.
std::optional<std::size_t> count_in(std::string_view name, std::string_view prefix) {
    if (!name.starts_with(prefix)) return std::nullopt;
    const std::string_view digits = name.substr(prefix.size());
    std::size_t count = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), count);
    if (digits.empty() || digits.front() == '0' || end != digits.data() + digits.size()) return std::nullopt;
    return error == std::errc::result_out_of_range ? largest_sphere + 1 : count;
}

Result<Polyhedron> make_sphere(std::string_view name, std::size_t count, const Vec3d& half_axes) {
    const std::vector<SphereSize> sizes = sphere_sizes();
    const auto above = std::ranges::lower_bound(sizes, count, {}, &SphereSize::vertices);
    if (above != sizes.end() && above->vertices() == count) {
        std::vector<Vec3d> points = sphere_points(*above);
        for (Vec3d& point : points) point = point.cwiseProduct(half_axes);
        return convex_hull(points);
    }
    const std::string_view kind = name.substr(0, name.find_first_of("0123456789"));
    std::string near;
    if (above != sizes.begin()) near += fmt::format("{}{}", kind, (above - 1)->vertices());
    if (above != sizes.begin() && above != sizes.end()) near += " and ";
    if (above != sizes.end()) near += fmt::format("{}{}", kind, above->vertices());
    return Result<Polyhedron>::failure(
        fmt::format("shape '{}': it has 4 k^2 + 2 or 6 k^2 + 2 vertices, at most {}; the nearest: {}", name,
                    sizes.back().vertices(), near));
}

}  // namespace

std::vector<ShapeInfo> list_shapes() {
    std::vector<ShapeInfo> shapes = {
        {"tetra4", 4, 6, 4}, {"cube8", 8, 12, 6}, {"box8", 8, 12, 6}, {"uv_sphere386", 386, 1152, 768}};
    for (const SphereSize& size : sphere_sizes()) {
        const std::size_t n = size.vertices();
        shapes.push_back({fmt::format("sphere{}", n), n, 3 * n - 6, 2 * n - 4});
    }
    return shapes;
}

Result<Polyhedron> make_shape(std::string_view name) {
    if (name == "tetra4") return convex_hull(tetra_points());
    if (name == "cube8") return convex_hull(box_points({corner, corner, corner}));
    if (name == "box8") return convex_hull(box_points({0.875, 0.5, 0.3125}));
    if (name == "uv_sphere386") return convex_hull(uv_sphere_points());
    if (const auto count = count_in(name, sphere_prefix)) return make_sphere(name, *count, {1, 1, 1});
    if (const auto count = count_in(name, ellipsoid_prefix)) return make_sphere(name, *count, {1, 0.5, 0.25});
    std::vector<std::string> known;
    for (const ShapeInfo& shape : list_shapes()) known.push_back(shape.name);
    return Result<Polyhedron>::failure(fmt::format(
        "unknown shape '{}'{} known: tetra4, cube8, box8, uv_sphere386, sphereN and ellipsoidN with N = 4 k^2 + 2 "
        "or 6 k^2 + 2 (sphere6, sphere8, sphere18, sphere26, sphere38 ... sphere386 ...)",
        name, did_you_mean(name, known)));
}

Polyhedron scaled(const Polyhedron& body, double factor) {
    Polyhedron result = body;
    for (Vec3d& vertex : result.vertices) vertex *= factor;
    for (Plane<double>& plane : result.face_planes) plane.offset *= factor;
    return result;
}

}  // namespace edgewise::scene
