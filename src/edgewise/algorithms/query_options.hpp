// SPDX-License-Identifier: MIT
//
// Accuracy that a caller may trade for speed or robustness, and how answers are found. Nothing is traded
// unless asked for: both tolerances default to "as exact as the type allows". The paper's tolerances (section
// 3.4) are of the same two kinds.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

#include "edgewise/algorithms/distance.hpp"

namespace edgewise {

/// Solvers for the point of GJK's simplex that is closest to the origin. Both are Johnson's, and where they
/// agree they agree to the bit.
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

struct QueryOptions {
    /// Bodies at this distance or nearer are touching, in the bodies' own unit.
    double contact_tolerance = 0;
    /// GJK ends when the squared distance is known to this relative width: the duality gap |v|^2 - <v, w>
    /// over |v|^2. The distance is then too large by at most this part of itself. V-Clip ignores it.
    double gap_tolerance = 0;
    /// Distances beyond this, and beyond the contact tolerance, do not matter, in the bodies' own unit: GJK
    /// ends as soon as a direction shows that the bodies are farther from each other, and the distance is
    /// then an upper bound. 0: only the verdict matters. V-Clip knows nothing sooner than the distance, and
    /// ignores it.
    double cutoff = std::numeric_limits<double>::infinity();
    /// V-Clip only: if true, GJK answers after a cycle, and where rounding may have chosen the answer. If
    /// false, V-Clip is raw, as published: its last result is the answer, right or wrong. Its loops are not
    /// inlined then: raw V-Clip is there to be checked, not timed.
    bool hardened = true;
    /// GJK's solver; V-Clip has none, and where it asks GJK, GJK solves by the default.
    SubDistanceSolver sub_distance = SubDistanceSolver::cofactors;

    /// Returns true if distances beyond some value do not matter.
    [[nodiscard]] bool has_cutoff() const { return cutoff < std::numeric_limits<double>::infinity(); }
    /// Distances beyond this do not matter.
    template <class Scalar>
    [[nodiscard]] Scalar cutoff_in() const {
        return static_cast<Scalar>(std::max(cutoff, contact_tolerance));
    }
    /// Returns true if no distance matters: only whether the bodies are separated.
    [[nodiscard]] bool is_for_verdict() const { return cutoff <= contact_tolerance; }
};

/// Applies the contact tolerance to an answer. A distance within the tolerance stays as found: for GJK, which
/// stops as soon as it knows that much, an upper bound.
inline void apply_tolerance(const QueryOptions& options, Distance& answer) {
    if (answer.status == Status::separated && answer.distance <= options.contact_tolerance)
        answer.status = Status::touching;
}

}  // namespace edgewise
