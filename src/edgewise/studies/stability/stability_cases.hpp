// SPDX-License-Identifier: MIT
//
// The cases of one hard family for one kind of storage, and their exact answers. Tables that store the same
// values hold the same bodies, so one exact answer serves all of them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "edgewise/scene/hard/families.hpp"
#include "edgewise/truth/known_pair.hpp"

namespace edgewise::studies {

/// Two bodies that could be built, and their poses. In a warm family the poses are in time order. Otherwise
/// they are the poses of all consecutive cases with the same two bodies.
struct StabilityCase {
    Polyhedron a, b;
    std::vector<std::pair<Pose, Pose>> poses;
};

struct StabilityPose {
    std::size_t index, pose;  ///< of the case, and of its poses
};

class StabilityCases {
  public:
    /// About `count` poses. `single`: for tables that store in single precision.
    StabilityCases(const scene::HardFamily& family, std::size_t count, std::uint64_t seed, bool single,
                   std::span<const Polyhedron> real);

    [[nodiscard]] const std::vector<StabilityCase>& all() const { return cases_; }
    [[nodiscard]] std::size_t refused() const { return refused_; }
    [[nodiscard]] const std::string& first_refusal() const { return first_refusal_; }

    /// Returns the exact answers for a pose between the two bodies that the tables hold: as given, or rounded
    /// to single.
    [[nodiscard]] truth::KnownPair& known(StabilityPose at) { return truth_of(at).pair; }
    [[nodiscard]] truth::PlacedBodies placed(StabilityPose at, std::span<const Polyhedron> stored) const {
        return {stored[0].vertices, poses_of(at).first, stored[1].vertices, poses_of(at).second};
    }
    /// Returns the verdict of the paper's control, in double on the same bodies; nothing if a body is flat.
    [[nodiscard]] std::optional<bool> control(StabilityPose at, std::span<const Polyhedron> stored);

  private:
    struct Truth {
        truth::KnownPair pair;
        std::optional<std::optional<bool>> control;
    };

    [[nodiscard]] Truth& truth_of(StabilityPose at) { return truths_[at.index][at.pose]; }
    [[nodiscard]] const std::pair<Pose, Pose>& poses_of(StabilityPose at) const {
        return cases_[at.index].poses[at.pose];
    }

    std::vector<StabilityCase> cases_;
    std::vector<std::vector<Truth>> truths_;
    std::size_t refused_ = 0;
    std::string first_refusal_;
};

}  // namespace edgewise::studies
