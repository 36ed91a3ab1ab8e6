// SPDX-License-Identifier: MIT
//
// The check of an answer: what it claims about a stored pair is compared with what is known exactly, and an
// error counts as wrong where it is larger than allowed.
//
// Known facts about one pair of bodies as tables hold them: its exact answers, each computed when it is first
// asked for, or an interval that double arithmetic proved. One for all cells that store the same bodies.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/truth/accuracy_band.hpp"
#include "edgewise/truth/exact_distance.hpp"
#include "edgewise/truth/filter/scanned_body.hpp"

namespace edgewise::truth {

/// Two vertex sets and where they are. Keeps references.
struct PlacedBodies {
    std::span<const Vec3d> a;
    const Pose& pose_a;
    std::span<const Vec3d> b;
    const Pose& pose_b;

    [[nodiscard]] AccuracyBand band(double eps) const { return accuracy_band(a, pose_a, b, pose_b, eps); }
};

/// The exact answers about one pair. Every call names the same bodies.
class KnownPair {
  public:
    KnownPair() = default;
    /// A pair with exact answers that were computed before.
    explicit KnownPair(const ExactDistance& exact, std::optional<double> depth = {})
        : exact_(std::make_unique<ExactDistance>(exact)), depth_(depth) {}

    /// Throws std::invalid_argument where exact_distance fails.
    const ExactDistance& exact(const PlacedBodies& bodies);
    /// Exact penetration depth of bodies in contact.
    double depth(const PlacedBodies& bodies);

  private:
    std::unique_ptr<ExactDistance> exact_;
    std::optional<double> depth_;
};

using PosesOfPair = std::pair<Pose, Pose>;

enum class KnownBy { nothing, double_proof, wide_proof, exact };

/// An interval that holds the distance.
struct ProvenPair {
    KnownBy by = KnownBy::nothing;
    ExactVerdict verdict = ExactVerdict::separated;
    /// Proven: the distance or depth is within the band in double. Any verdict is accepted, and the true one
    /// is not computed; `verdict` says touching.
    bool is_grazing = false;
    double lower = 0, upper = 0;
    KnownPair answers;             ///< as soon as the interval does not decide
    double offset = 0, ortho = 0;  ///< for the band

    [[nodiscard]] bool is_separated() const { return verdict == ExactVerdict::separated; }
};

/// Two bodies that are looked at in many poses.
class StoredPair {
  public:
    /// Keeps references.
    StoredPair(std::span<const Vec3d> a, std::span<const Vec3d> b) : a_(a), b_(b) {}

    /// Proves the distance in double if that is narrower than the band, else exactly. `guess`: from A to B.
    [[nodiscard]] ProvenPair know(const PosesOfPair& poses, const Vec3d& guess);

    [[nodiscard]] PlacedBodies placed(const PosesOfPair& poses) const {
        return {a_.vertices(), poses.first, b_.vertices(), poses.second};
    }
    [[nodiscard]] AccuracyBand band(const ProvenPair& known, double eps) const;

  private:
    ScannedBody a_, b_;
};

/// The checked parts of an answer. In contact the distance is not checked.
struct Claim {
    bool separated = false;
    double distance = 0;
    double witness_error = 0;  ///< | |p_a - p_b| - d | of the two witness points
    std::optional<double> depth = {};
    bool verdict_only = false;  ///< the distance is a bound, and no witness was asked for
    bool failed = false;        ///< there is no answer, which is wrong
};

/// Errors allowed over the scale of the pair.
struct AllowedErrors {
    double distance = 0;  ///< also of the distance of the witness points
    double depth = 0;
    bool beyond_band = true;  ///< errors count from the band on; false: from 0, which is stricter
};

/// The errors allowed to arithmetic with this rounding step (Tolerance<Compute>::eps). Where planes are
/// stored in single and computed with in double, V-Clip is as good as the planes.
[[nodiscard]] constexpr AllowedErrors allowed_errors(double eps, bool rounded_planes = false) {
    const bool single = eps > Tolerance<double>::eps;
    return {single || rounded_planes ? verified_error_single : verified_error_double,
            single ? verified_error_single : verified_depth_error_double};
}

/// Tolerances that a query was given. Bodies within the contact tolerance are in contact, and distances count
/// from that tolerance on; a distance may be too long by gap_tolerance times itself.
struct Leeway {
    double contact_tolerance = 0, gap_tolerance = 0;
};

struct CheckedAnswer {
    ExactVerdict exact = ExactVerdict::separated;
    bool verdict_wrong = false;  ///< contact against no contact outside the band, or a distance that is NaN
    bool in_band = false;  ///< the pair is nearer to grazing than the band, as far as its depth was asked
    bool distance_wrong = false, depth_wrong = false;
    bool is_bound = false;     ///< an interval proved the answer right: errors are upper bounds
    bool has_distance = true;  ///< false: only the verdict was asked, and no error is set
    double error = 0;          ///< |d - d*|, contact counting as d = 0; d* of the bodies that the table holds
    double error_given = 0;    ///< |d - d*|, d* of the bodies as given; set on request
    double witness_error = 0, depth_error = 0;
    AccuracyBand band;
    /// True if the verdict differs from the paper's control; no value if the control was not asked or has
    /// no answer.
    std::optional<bool> control_disagrees = {};

    [[nodiscard]] bool wrong() const { return verdict_wrong || distance_wrong || depth_wrong; }
    /// The larger error of distance and witness points, over scale and beyond the band.
    [[nodiscard]] double worst_beyond() const;
};

/// |d - d*| beyond the contact tolerance; a distance within it counts as 0, and so does contact.
[[nodiscard]] double distance_error(const Claim& claim, const ExactDistance& exact,
                                    double contact_tolerance = 0);

/// Verdicts are about distance zero or not; touching counts as contact. A wrong "separated" is excused by the
/// band only if its distance is inside it too. The depth is asked for where that decides, or is claimed.
[[nodiscard]] CheckedAnswer check(const Claim& claim, const PlacedBodies& bodies, KnownPair& known,
                                  const AccuracyBand& band, const AllowedErrors& allowed,
                                  const Leeway& leeway = {});

/// A verdict on nearness: whether the bodies are nearer to each other than a margin. Either is right for a
/// pair at its margin to within the band; "farther" is, too, where the gap tolerance explains it.
[[nodiscard]] CheckedAnswer check_nearness(bool nearer, const ExactDistance& exact, double margin,
                                           const AccuracyBand& band, double gap_tolerance);

/// The check by an interval where that proves the answer right, else by exact arithmetic.
[[nodiscard]] CheckedAnswer check(const Claim& claim, const StoredPair& bodies, const PosesOfPair& poses,
                                  ProvenPair& known, const AccuracyBand& band, const AllowedErrors& allowed);

}  // namespace edgewise::truth
