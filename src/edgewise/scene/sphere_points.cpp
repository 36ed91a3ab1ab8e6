// SPDX-License-Identifier: MIT
//
// Grid nodes on the octahedron or the cube, pushed out to a slightly uneven sphere. Nodes are listed slice by
// slice (x, then y, then z), so that neighbours on the body are mostly near one another in memory.
//
// Angles by scene/angle.hpp, the same on every machine; the radius noise of meridians and parallels is a
// sixteenth of the squared spacing next to the poles, where points are nearest to each other.
#include "edgewise/scene/sphere_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "edgewise/scene/angle.hpp"
#include "edgewise/scene/rng.hpp"

namespace edgewise::scene {
namespace {

std::vector<Vec3d> octahedral_nodes(int k) {
    std::vector<Vec3d> nodes;
    for (int x = -k; x <= k; ++x) {
        const int width = k - std::abs(x);
        for (int y = -width; y <= width; ++y) {
            const int z = width - std::abs(y);
            nodes.emplace_back(x, y, -z);
            if (z != 0) nodes.emplace_back(x, y, z);
        }
    }
    return nodes;
}

/// Rounds each coordinate to the nearest multiple of 2^-21.
Vec3d on_grid(const Vec3d& point) {
    const auto to_grid = [](double x) { return std::floor(x * 0x1p21 + 0.5) * 0x1p-21; };
    return {to_grid(point.x()), to_grid(point.y()), to_grid(point.z())};
}

/// Takes a point of the cube [-1, 1]^3's surface to the unit sphere, nodes closer to evenly spaced than along
/// rays. The map is the well-known x sqrt(1 - y^2/2 - z^2/2 + y^2 z^2/3).
Vec3d spread(const Vec3d& p) {
    const Vec3d s(p.x() * p.x(), p.y() * p.y(), p.z() * p.z());
    return {p.x() * std::sqrt(1 - s.y() / 2 - s.z() / 2 + s.y() * s.z() / 3),
            p.y() * std::sqrt(1 - s.z() / 2 - s.x() / 2 + s.z() * s.x() / 3),
            p.z() * std::sqrt(1 - s.x() / 2 - s.y() / 2 + s.x() * s.y() / 3)};
}

std::vector<Vec3d> cubic_nodes(int k) {
    std::vector<Vec3d> nodes;
    const auto at = [k](int i) { return (2.0 * i - k) / k; };
    for (int x = 0; x <= k; ++x) {
        for (int y = 0; y <= k; ++y) {
            const bool rim = x == 0 || x == k || y == 0 || y == k;
            for (int z = 0; z <= k; z += rim ? 1 : k) nodes.push_back(spread({at(x), at(y), at(z)}));
        }
    }
    return nodes;
}

}  // namespace

std::vector<SphereSize> sphere_sizes() {
    std::vector<SphereSize> sizes;
    for (const SphereFamily family : {SphereFamily::octahedral, SphereFamily::cubic}) {
        for (SphereSize size{family, 1}; size.vertices() <= largest_sphere; ++size.k) sizes.push_back(size);
    }
    std::ranges::sort(sizes, {}, &SphereSize::vertices);
    return sizes;
}

std::vector<Vec3d> sphere_points(SphereSize size) {
    std::vector<Vec3d> points =
        size.family == SphereFamily::octahedral ? octahedral_nodes(size.k) : cubic_nodes(size.k);
    const double spacing = 1.0 / size.k;  // neighbours are at least this far apart, in either family
    const double noise = spacing * spacing / 16;
    Rng rng(size.vertices());
    for (Vec3d& point : points) {
        const double radius = 1 + rng.uniform(-noise, noise);
        const double factor = radius / norm(point);
        point = on_grid(point * factor);
    }
    return points;
}

std::vector<Vec3d> uv_sphere_points() {
    constexpr int parallels = 24, meridians = 16;
    const double step = std::numbers::pi / (parallels + 1);
    const double spacing = sine_cosine(step).sine * 2 * std::numbers::pi / meridians;
    const double noise = spacing * spacing / 16;
    Rng rng(parallels * meridians + 2);
    std::vector<Vec3d> points = {{0, 0, -1}};
    for (int i = 1; i <= parallels; ++i) {
        const SineCosine polar = sine_cosine(step * i);
        for (int k = 0; k < meridians; ++k) {
            const SineCosine around = sine_cosine(2 * std::numbers::pi * k / meridians);
            const double radius = 1 + rng.uniform(-noise, noise);
            points.push_back(
                on_grid(radius * Vec3d(polar.sine * around.cosine, polar.sine * around.sine, -polar.cosine)));
        }
    }
    points.emplace_back(0, 0, 1);
    return points;
}

}  // namespace edgewise::scene
