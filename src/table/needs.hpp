// SPDX-License-Identifier: MIT
//
// What a scene asks of an answer; tables and queries materialise only that.
#pragma once

#include <cstdint>

namespace edgewise {

/// What an answer must hold, least first: each asks for everything before it.
enum class Needs : std::uint8_t {
    verdict,    ///< apart or not
    distance,   ///< and how far
    witnesses,  ///< and the two closest points
    features,   ///< and which vertices, edges or faces they lie on
};

/// The parts of a body that a table must hold for an algorithm.
enum class Parts : std::uint8_t {
    support,   ///< vertices and their neighbours: enough for GJK
    features,  ///< edges, faces, rings and Voronoi planes as well: V-Clip walks on them
};

}  // namespace edgewise
