// SPDX-License-Identifier: MIT
//
// A first guess at the simplex that carries the answer, by GJK in plain double precision. It decides nothing:
// a good guess only saves exact iterations.
#pragma once

#include <array>

#include "edgewise/truth/exact_body.hpp"

namespace edgewise::truth {

/// Up to four points of A - B by their vertices. Also handed out with an answer, as the start of the next
/// query of the same two bodies.
struct SimplexSeed {
    std::array<VertexPair, 4> pair{};
    int size = 0;
};

/// Never empty. Starts from `start` where that names vertices the bodies have.
[[nodiscard]] SimplexSeed seed_simplex(ExactPair& bodies, const SimplexSeed& start);

}  // namespace edgewise::truth
