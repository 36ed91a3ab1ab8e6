// SPDX-License-Identifier: MIT
//
// One scene on one shape: the queries that every cell of a comparison answers, and their exact answers. Exact
// answers depend on the bodies alone, so cells that store the same bodies share them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "edgewise/scene/workload.hpp"
#include "edgewise/sweep/plan.hpp"
#include "edgewise/truth/exact_distance.hpp"

namespace edgewise {

/// A body and where it came from.
struct NamedShape {
    std::string name, source;  ///< source: "built-in", or the mesh file's name
    Polyhedron body;
    std::string error;  ///< why there is no body; its cells are unavailable
};

class Group {
  public:
    /// Throws std::invalid_argument when the scene cannot be made.
    Group(const Plan& plan, const SceneChoice& scene, const NamedShape& shape);

    [[nodiscard]] const SceneParameters& parameters() const { return parameters_; }
    [[nodiscard]] const Workload& workload() const { return workload_; }

    /// Positions of the checked queries, spread evenly over the workload.
    [[nodiscard]] const std::vector<std::size_t>& checked() const { return checked_; }

    /// Exact answers of the checked queries for these bodies, in the order of checked().
    [[nodiscard]] const std::vector<ExactDistance>& exact(std::span<const Polyhedron> bodies);

    /// What the paper's control says of them, in contact or not (truth/moore_wilhelms.hpp); empty where
    /// the plan does not ask it, and nothing for most of large bodies, where it takes too long.
    [[nodiscard]] const std::vector<std::optional<bool>>& control(std::span<const Polyhedron> bodies);

  private:
    [[nodiscard]] std::vector<ExactDistance> work_out(std::span<const Polyhedron> bodies) const;

    bool asks_control_;
    SceneParameters parameters_;
    Workload workload_;
    std::vector<std::size_t> checked_;
    std::map<std::string, std::vector<ExactDistance>> exact_;  // by the bodies' fingerprint
    std::map<std::string, std::vector<std::optional<bool>>> control_;
};

}  // namespace edgewise
