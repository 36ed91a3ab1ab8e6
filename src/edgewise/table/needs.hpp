// SPDX-License-Identifier: MIT
//
// The parts of an answer that a scene needs; tables and queries compute only these.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace edgewise {

/// The parts of an answer, least first: from `verdict` on, each value includes everything before it.
enum class Needs : std::uint8_t {
    nearer,    ///< nearer to each other than a margin or not: nothing else, not even contact
    within,    ///< the distance and the witnesses of bodies nearer than a margin, of others that they are not
    verdict,   ///< separated or not
    distance,  ///< and the distance
    witnesses,    ///< and the two closest points
    features,     ///< and which vertices, edges or faces they lie on
    depth,        ///< and, of bodies in contact, how deep they overlap and where
    certificate,  ///< and an interval that is proven to hold the distance
};

inline constexpr std::array<std::string_view, 8> needs_names = {
    "nearer", "within", "verdict", "distance", "witnesses", "features", "depth", "certificate"};

[[nodiscard]] constexpr std::string_view to_string(Needs needs) {
    assert(static_cast<std::size_t>(needs) < needs_names.size());
    return needs_names[static_cast<std::size_t>(needs)];
}

/// Returns true for a question about a margin.
[[nodiscard]] constexpr bool has_margin(Needs needs) { return needs <= Needs::within; }

/// Returns the value with this name; nothing for an unknown name.
[[nodiscard]] constexpr std::optional<Needs> needs_from(std::string_view name) {
    for (std::size_t i = 0; i < needs_names.size(); ++i) {
        if (needs_names[i] == name) return static_cast<Needs>(i);
    }
    return std::nullopt;
}

/// The parts of a body that a table must hold for an algorithm.
enum class Parts : std::uint8_t {
    support,   ///< vertices and their neighbours: enough for GJK
    features,  ///< edges, faces, rings and Voronoi planes as well: V-Clip walks on them
};

}  // namespace edgewise
