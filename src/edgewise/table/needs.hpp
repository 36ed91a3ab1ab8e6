// SPDX-License-Identifier: MIT
//
// What a scene asks of an answer; tables and queries materialise only that.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace edgewise {

/// What an answer must hold, least first: from `verdict` on each asks for everything before it.
enum class Needs : std::uint8_t {
    nearer,       ///< nearer to each other than a margin or not: no more, not even whether they touch
    verdict,      ///< separated or not
    distance,     ///< and how far
    witnesses,    ///< and the two closest points
    features,     ///< and which vertices, edges or faces they lie on
    depth,        ///< and, of bodies in contact, how deep they overlap and where
    certificate,  ///< and an interval that provably holds the distance
};

inline constexpr std::array<std::string_view, 7> needs_names = {
    "nearer", "verdict", "distance", "witnesses", "features", "depth", "certificate"};

[[nodiscard]] constexpr std::string_view to_string(Needs needs) {
    assert(static_cast<std::size_t>(needs) < needs_names.size());
    return needs_names[static_cast<std::size_t>(needs)];
}

/// Nothing for an unknown name.
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
