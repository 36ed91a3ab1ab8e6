// SPDX-License-Identifier: MIT
//
// What Enhanced GJK does inside, whatever the layout: how its support points move, how its sub-distance
// algorithm ends, and where it ends beside V-Clip.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace edgewise::measure {

struct AlgorithmWork {
    std::uint64_t queries = 0;  ///< observed; 0: none
    std::uint64_t supports = 0, hops = 0,
                  vertices = 0;  ///< calls that climbed; edges climbed; vertices visited
    /// Of warm queries, vertices of the last simplex: all; in the one before; beside one of it.
    std::uint64_t kept_of = 0, kept = 0, near = 0;
    std::uint64_t sub_distances = 0, subsets_tried = 0;
    std::array<std::uint64_t, 4> accepted{};        ///< sub-distances by the size of the subset that held
    std::uint64_t compared = 0, same_features = 0;  ///< answers beside V-Clip's
    std::string reason = "not observed", remedy;    ///< where queries is 0
};

}  // namespace edgewise::measure
