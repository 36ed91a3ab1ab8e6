// SPDX-License-Identifier: MIT
//
// An interval that provably holds the distance of two bodies, and their verdict, from double arithmetic
// alone. It takes less than a microsecond, and exact integers take tens of them, for nearly every pair. Where
// it proves nothing it says so, and exact_distance must be used.
//
// A GJK in double from a guessed direction finds the simplex; none of its results is trusted. Lower bound:
// full scans of both bodies along its directions, rounded downward. Upper bound: the mean of its points with
// non-negative weights, rounded upward. If the bounds are farther apart than wanted, both are
// computed again in double-double for the vertices that decide. Overlap: four points of A - B around the
// origin; no rounding can change the signs of its four volumes. Touching is never proved, since it has no
// margin. A proof may say that a pair is nearer to touching than the wanted width, on either side.
#pragma once

#include <array>
#include <limits>

#include "edgewise/truth/filter/posed_pair.hpp"

namespace edgewise::truth {

enum class FloatVerdict {
    unknown,
    separated,
    overlapping,
    grazing,  ///< neither the distance nor the depth exceeds the width asked for
};

struct FloatProof {
    FloatVerdict verdict = FloatVerdict::unknown;
    double lower = 0;  ///< the distance is in [lower, upper]; [0, 0] of an overlap
    double upper = std::numeric_limits<double>::infinity();
    double most_depth =
        std::numeric_limits<double>::infinity();  ///< an upper bound of the depth; 0 if separated
    Vec3d separation = Vec3d::Zero();             ///< about a - b between closest points, as far as GJK came
    bool is_wide = false;                         ///< double-double had to help

    [[nodiscard]] double width() const { return upper - lower; }
};

/// `guess`: a direction from A to B in the world, of any length; zero or NaN: no guess. Ends as soon as the
/// interval is no wider than `width`. Rotations and translations must be finite.
[[nodiscard]] FloatProof prove_distance(ScannedBody& a, const Pose& pose_a, ScannedBody& b,
                                        const Pose& pose_b, const Vec3d& guess, double width);
[[nodiscard]] FloatProof prove_distance(PosedPair& pair, const Vec3d& guess, double width);

// Tests if the origin is strictly inside a tetrahedron with corners known to within an error, by the signs of
// the four volumes that the origin has with its faces.

/// Returns true only if every choice of corners within `error` of the given ones encloses the origin.
[[nodiscard]] bool surely_encloses_origin(const std::array<Vec3d, 4>& corners, double error);

}  // namespace edgewise::truth
