// SPDX-License-Identifier: MIT
//
// Parts of recorders of robots: a prism for a cylinder, and joints that move without dynamics.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <vector>

/// Vertices of a prism of 32 sides around the cylinder along z. Says once on stderr that there is one.
inline std::vector<std::array<double, 3>> prism_around(double radius, double half_length) {
    constexpr int sides = 32;
    const double step = std::numbers::pi / sides, outer = radius / std::cos(step);  // 1.0048 of the radius
    std::vector<std::array<double, 3>> vertices;
    for (int i = 0; i < 2 * sides; ++i)
        vertices.push_back({outer * std::cos((i | 1) * step), outer * std::sin((i | 1) * step),
                            i % 2 == 0 ? half_length : -half_length});
    return vertices;
}

inline void say_that_cylinders_are_prisms(int cylinders) {
    if (cylinders == 0) return;
    std::fprintf(
        stderr,
        "cylinders (%d) are recorded as prisms of 32 sides around them, which are at their edges 0.5 %% "
        "of the radius wider\n",
        cylinders);
}

/// Where a joint may be: an angle in rad, or a length.
struct JointRange {
    double low, high;
};
inline constexpr JointRange free_turn = {-std::numbers::pi, std::numbers::pi}, free_slide = {-1, 1};

/// Moves a joint's place by `way` towards its goal; once there it gets another goal in its range.
inline void move_joint(double way, const JointRange& range, std::minstd_rand& random, double& place,
                       double& goal) {
    if (place == goal) goal = std::uniform_real_distribution<double>(range.low, range.high)(random);
    place += std::clamp(goal - place, -way, way);
    if (std::abs(goal - place) < 1e-9) place = goal;
}
