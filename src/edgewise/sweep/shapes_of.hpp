// SPDX-License-Identifier: MIT
//
// The bodies of a plan: built-in shapes and hulls of mesh files. A body that cannot be had becomes a shape
// with an error, so that its cells appear in the report as unavailable, with the reason.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "edgewise/sweep/plan.hpp"
#include "edgewise/sweep/shared_queries.hpp"

namespace edgewise::sweep {

/// Throws std::invalid_argument for an unknown built-in name (a slip of the user, not of the data).
[[nodiscard]] std::vector<scene::NamedShape> shapes_of(const Plan& plan,
                                                       const std::function<void(const std::string&)>& warn);

}  // namespace edgewise::sweep
