// SPDX-License-Identifier: MIT
//
// The two bounds of a distance again, where those in double are too far from each other: the few vertices
// that decide are computed as sums of two doubles.
//
// A world coordinate is three exact products and an exact difference of translations, summed in
// double-double: off by less than 2^-96 of the lengths in it, and a height along a unit direction likewise
// (wide_rounding has a margin of some binary places).
#pragma once

#include "edgewise/truth/filter/posed_pair.hpp"

namespace edgewise::truth {

/// A height of A - B along the direction that none of its points is below, after a scan along it: only
/// vertices that the scan cannot distinguish from the lowest are computed again.
[[nodiscard]] double wide_least_height(PosedPair& pair, const Vec3d& direction, const ScannedLowest& scanned);

/// An upper bound of the length of the mean of the simplex's points with these weights, which are not
/// negative.
[[nodiscard]] double wide_length(const PosedPair& pair, const MinimumSimplex<Vec3d>& simplex,
                                 const std::array<double, 3>& weights);

}  // namespace edgewise::truth
