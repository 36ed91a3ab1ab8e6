// SPDX-License-Identifier: MIT
//
// Known facts about one pair of bodies as tables hold them: its exact answers, each computed when it is first
// asked for, or an interval that double arithmetic proved. One for all cells that store the same bodies.
#pragma once

#include <memory>
#include <optional>
#include <utility>

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

}  // namespace edgewise::truth
