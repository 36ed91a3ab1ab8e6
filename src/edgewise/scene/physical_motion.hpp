// SPDX-License-Identifier: MIT
//
// Velocities of scene files in the units of scenes, which know steps alone: rad per step, and body sizes
// per step.
#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace edgewise::scene {

inline constexpr std::string_view random_turn = "random";  ///< in place of a number

struct MotionUnits {
    double time_step;  ///< s
    double size;       ///< of the body, m
};

/// Whether a parameter says how fast bodies turn.
[[nodiscard]] inline bool is_turn(std::string_view name) {
    return name == "angular_velocity" || name == "rotation_step";
}

/// A parameter as scenes know it: angular_velocity (rad/s) as rotation_step, linear_velocity (m/s) as
/// translation_step; all others as they are.
[[nodiscard]] inline std::pair<std::string, double> in_steps(const std::string& name, double value,
                                                             const MotionUnits& units) {
    if (name == "angular_velocity") return {"rotation_step", value * units.time_step};
    if (name == "linear_velocity") return {"translation_step", value * units.time_step / units.size};
    return {name, value};
}

}  // namespace edgewise::scene
