// SPDX-License-Identifier: MIT
//
// Angles by scene/angle.hpp, the same on every machine. The radius noise is a sixteenth of the squared
// spacing next to the poles, where points are nearest to each other.
#include "edgewise/scene/uv_sphere.hpp"

#include <numbers>

#include "edgewise/scene/angle.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/sphere_points.hpp"

namespace edgewise::scene {
namespace {

constexpr int parallels = 24, meridians = 16;

}  // namespace

std::vector<Vec3d> uv_sphere_points() {
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
            points.push_back(on_sphere_grid(
                radius * Vec3d(polar.sine * around.cosine, polar.sine * around.sine, -polar.cosine)));
        }
    }
    points.emplace_back(0, 0, 1);
    return points;
}

}  // namespace edgewise::scene
