// SPDX-License-Identifier: MIT
//
// One scene on one shape: the queries that every cell of a comparison answers, and their exact answers. Exact
// answers depend on the bodies alone, so cells that store the same bodies share them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "edgewise/scene/shapes.hpp"
#include "edgewise/scene/workload.hpp"
#include "edgewise/sweep/plan.hpp"
#include "edgewise/truth/known_pair.hpp"

namespace edgewise::sweep {

class SharedQueries {
  public:
    /// Throws std::invalid_argument when the scene cannot be made.
    SharedQueries(const Plan& plan, const SceneChoice& scene, const scene::NamedShape& shape);

    [[nodiscard]] const scene::Workload& workload() const { return workload_; }
    /// The same queries, none of which knows its pair's last answer.
    [[nodiscard]] const scene::Workload& cold_workload();

    /// Positions of the checked queries, spread evenly over the workload.
    [[nodiscard]] const std::vector<std::size_t>& checked() const { return checked_; }

    /// The checked queries between these bodies, in the order of checked(): their exact distances are known.
    [[nodiscard]] std::vector<truth::KnownPair>& known(std::span<const Polyhedron> bodies);

    /// What the paper's control says of them, in contact or not (truth/moore_wilhelms.hpp); empty where
    /// the plan does not ask it, and nothing for most of large bodies, where it takes too long.
    [[nodiscard]] const std::vector<std::optional<bool>>& control(std::span<const Polyhedron> bodies);

  private:
    bool asks_control_;
    scene::Workload workload_;
    std::optional<scene::Workload> cold_workload_;  ///< once it was asked for
    std::vector<std::size_t> checked_;
    std::map<std::string, std::vector<truth::KnownPair>> known_;  // by the bodies' fingerprint
    std::map<std::string, std::vector<std::optional<bool>>> control_;
};

}  // namespace edgewise::sweep
