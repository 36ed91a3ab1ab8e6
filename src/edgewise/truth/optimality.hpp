// SPDX-License-Identifier: MIT
//
// The proof of an exact answer, checked for every answer, independently of the search that found it:
// non-negative weights that sum to one put the nearest point into A - B, and no vertex pair lies below the
// plane through it. Together these two say that no other point is nearer (Kuhn-Tucker).
#pragma once

#include <array>

#include "edgewise/truth/exact_body.hpp"

namespace edgewise::truth {

/// The weights of the nearest point, up to a common positive factor.
[[nodiscard]] std::array<mpz_class, 4> simplex_weights(const MinimumSimplex<IntegerVec>& s);

/// Throws std::logic_error if the simplex does not carry the point of A - B nearest to the origin.
void require_optimal(ExactPair& bodies, const MinimumSimplex<IntegerVec>& simplex);

}  // namespace edgewise::truth
