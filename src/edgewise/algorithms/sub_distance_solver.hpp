// SPDX-License-Identifier: MIT
//
// Solvers, by name, for the point of GJK's simplex that is closest to the origin. Both are Johnson's, and
// where they agree they agree to the bit.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace edgewise {

enum class SubDistanceSolver : std::uint8_t {
    cofactors,  ///< all cofactors at once; search where their signs decide nothing
    johnson,    ///< Johnson's search, one subset after the other: what the replicated paper ran
};

inline constexpr std::array<std::string_view, 2> sub_distance_solver_names = {"cofactors", "johnson"};

[[nodiscard]] constexpr std::string_view to_string(SubDistanceSolver solver) {
    assert(static_cast<std::size_t>(solver) < sub_distance_solver_names.size());
    return sub_distance_solver_names[static_cast<std::size_t>(solver)];
}

/// Returns the solver with this name; nothing for an unknown name.
[[nodiscard]] constexpr std::optional<SubDistanceSolver> sub_distance_solver_from(std::string_view name) {
    for (std::size_t i = 0; i < sub_distance_solver_names.size(); ++i) {
        if (sub_distance_solver_names[i] == name) return static_cast<SubDistanceSolver>(i);
    }
    return std::nullopt;
}

}  // namespace edgewise
