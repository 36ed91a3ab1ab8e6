// SPDX-License-Identifier: MIT
//
// How near to contact a pair must be for its verdict to be a matter of rounding, and how an answer is judged.
//
//     scale  = max(extent A, extent B, |offset|)
//     extent = diagonal of the vertex box, in the body's frame
//     offset = max(|t_B - t_A|, largest |v| of A and B): what a query in the frame of one body has to carry
//     band   = 16 eps scale + 4 ortho_error max(extent), eps = 2^-52, or 2^-23 where single computes
//
// The translations count by their difference only: queries subtract them first, in double. ortho_error is
// that of the worse of the two rotations: code that uses R_A^T R_B may differ by it from R v + t as given.
#pragma once

#include <optional>
#include <span>

#include "edgewise/geometry/pose.hpp"
#include "edgewise/truth/exact_distance.hpp"

namespace edgewise::truth {

struct AccuracyBand {
    double scale = 0;
    double band = 0;
};

/// eps: Tolerance<Compute>::eps.
[[nodiscard]] AccuracyBand accuracy_band(std::span<const Vec3d> a, const Pose& pose_a,
                                         std::span<const Vec3d> b, const Pose& pose_b, double eps);

/// What the band asks of a body: the largest |v|, and the diagonal of its vertices' box.
struct BodySize {
    double reach = 0, extent = 0;
};

/// The same of bodies that were measured before, at many poses. ortho_error: of the worse rotation.
[[nodiscard]] AccuracyBand accuracy_band(const BodySize& a, const BodySize& b, double offset,
                                         double ortho_error, double eps);

/// An answer as far as it is judged. In contact the distance is not judged.
struct JudgedAnswer {
    bool separated = false;
    double distance = 0;
};

struct Judgement {
    bool verdict_wrong = false;   ///< contact against no contact, outside the band; or a distance that is NaN
    bool in_band = false;         ///< the pair is nearer to grazing than the band; see judge
    double error = 0;             ///< |d - d*|, contact counting as d = 0
    double error_over_scale = 0;  ///< error / scale; 0 for two points at one place that were found there
};

/// Verdicts are about distance zero or not; touching counts as contact. The margin is the exact distance when
/// separated, 0 when touching, the depth (if known) when overlapping. A wrong "separated" is excused by the
/// band only if its distance is inside it too. If the depth is not known, that distance alone decides, and
/// in_band is only known, and only set, for such an answer.
[[nodiscard]] Judgement judge(const JudgedAnswer& answer, const ExactDistance& exact,
                              const AccuracyBand& band, std::optional<double> depth = std::nullopt);

}  // namespace edgewise::truth
