// SPDX-License-Identifier: MIT
//
// The cases of one hard family for one kind of storage, and their exact answers. Tables that store alike hold
// the same bodies, so one exact answer serves all of them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "edgewise/scene/hard/families.hpp"
#include "edgewise/truth/exact_distance.hpp"

namespace edgewise::studies {

/// Two bodies that could be built, and their poses: of a warm family in time order, else all pairs of these
/// bodies that came in a row.
struct StabilityCase {
    Polyhedron a, b;
    std::vector<std::pair<Pose, Pose>> poses;
};

class StabilityCases {
  public:
    /// About `count` poses. `single`: for tables that store in single precision.
    StabilityCases(const scene::HardFamily& family, std::size_t count, std::uint64_t seed, bool single,
                   std::span<const Polyhedron> real);

    [[nodiscard]] const std::vector<StabilityCase>& all() const { return cases_; }
    [[nodiscard]] std::size_t refused() const { return refused_; }
    [[nodiscard]] const std::string& first_refusal() const { return first_refusal_; }

    /// Of pose `pose` of case `index` between the bodies that the tables hold: as given, or rounded to
    /// single.
    [[nodiscard]] const truth::ExactDistance& exact(std::size_t index, std::size_t pose,
                                                    const Polyhedron& stored_a, const Polyhedron& stored_b);
    /// Likewise; for pairs in contact. Worked out when first asked for.
    [[nodiscard]] double depth(std::size_t index, std::size_t pose, const Polyhedron& stored_a,
                               const Polyhedron& stored_b);

    /// The paper's control, in double on the same bodies; nothing where a body is flat.
    [[nodiscard]] std::optional<bool> control(std::size_t index, std::size_t pose, const Polyhedron& stored_a,
                                              const Polyhedron& stored_b);

  private:
    struct Truth {
        std::optional<truth::ExactDistance> distance;
        std::optional<double> depth;
        std::optional<std::optional<bool>> control;
    };

    std::vector<StabilityCase> cases_;
    std::vector<std::vector<Truth>> truths_;
    std::size_t refused_ = 0;
    std::string first_refusal_;
};

}  // namespace edgewise::studies
