// SPDX-License-Identifier: MIT
//
// A scan over coordinates in lanes, with a best vertex per lane, so that no lane waits for another. It finds
// the farthest of all, the first of equals, with every bit as a scan one by one.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "edgewise/geometry/polyhedron.hpp"

namespace edgewise {

/// Farthest of `groups` times `Lanes` vertices: read(k, group, lane) is coordinate k of a vertex. Lanes that
/// no vertex fills repeat the last vertex, which then never comes first.
template <std::size_t Lanes, class Scalar, class Read>
[[nodiscard]] [[gnu::always_inline]] inline Index farthest_in_lanes(std::size_t groups,
                                                                    const Vec3<Scalar>& direction,
                                                                    const Read& read) {
    /// Has the width of Scalar, so that a single mask selects both.
    using Count = std::conditional_t<sizeof(Scalar) == 4, std::uint32_t, std::uint64_t>;
    const Scalar x = direction.x(), y = direction.y(), z = direction.z();
    std::array<Scalar, Lanes> best;
    std::array<Count, Lanes> group_of;
    best.fill(-std::numeric_limits<Scalar>::infinity());
    group_of.fill(0);
    for (Count group = 0; group < static_cast<Count>(groups); ++group) {
        for (std::size_t i = 0; i < Lanes; ++i) {
            const Scalar along = read(0, group, i) * x + read(1, group, i) * y + read(2, group, i) * z;
            const bool higher = along > best[i];
            best[i] = higher ? along : best[i];
            group_of[i] = higher ? group : group_of[i];
        }
    }
    const Scalar top = *std::max_element(best.begin(), best.end());
    std::size_t first = std::numeric_limits<std::size_t>::max();
    for (std::size_t i = 0; i < Lanes; ++i)
        if (best[i] == top) first = std::min(first, std::size_t{group_of[i]} * Lanes + i);
    return static_cast<Index>(first);
}

}  // namespace edgewise
