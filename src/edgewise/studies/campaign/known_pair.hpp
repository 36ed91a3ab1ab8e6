// SPDX-License-Identifier: MIT
//
// What is known of the distance of one pair: an interval that double arithmetic proved, or the exact answer.
// One for all cells that store the same bodies.
#pragma once

#include <memory>
#include <optional>

#include "edgewise/truth/accuracy_band.hpp"
#include "edgewise/truth/exact_distance.hpp"
#include "edgewise/truth/filter/float_proof.hpp"

namespace edgewise::studies::campaign {

enum class KnownBy { nothing, double_proof, wide_proof, exact };

struct KnownPair {
    KnownBy by = KnownBy::nothing;
    truth::ExactVerdict verdict = truth::ExactVerdict::separated;
    /// Proven of a pair whose distance or depth is within the band in double: any verdict is right, and which
    /// one is the truth was not asked; `verdict` says touching.
    bool is_grazing = false;
    double lower = 0, upper = 0;                  ///< the distance is in [lower, upper]
    std::unique_ptr<truth::ExactDistance> exact;  ///< as soon as somebody had to ask
    std::optional<double> depth;                  ///< likewise, of an overlap
    double offset = 0, ortho = 0;                 ///< for the band

    [[nodiscard]] bool is_separated() const { return verdict == truth::ExactVerdict::separated; }
};

/// The two bodies of a block as one storage holds them, and its pairs' poses.
class StoredPair {
  public:
    /// Keeps references.
    StoredPair(std::span<const Vec3d> a, std::span<const Vec3d> b) : a_(a), b_(b) {}

    /// By proof in double where that is narrower than the band in double, else exactly. `guess`: from A to B.
    [[nodiscard]] KnownPair know(const std::pair<Pose, Pose>& poses, const Vec3d& guess);

    /// The exact answer and, in contact, the depth, kept in `known`.
    const truth::ExactDistance& exact(const std::pair<Pose, Pose>& poses, KnownPair& known) const;
    double depth(const std::pair<Pose, Pose>& poses, KnownPair& known) const;

    [[nodiscard]] truth::AccuracyBand band(const KnownPair& known, double eps) const;

  private:
    truth::ScannedBody a_, b_;
};

}  // namespace edgewise::studies::campaign
