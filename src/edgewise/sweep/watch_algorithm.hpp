// SPDX-License-Identifier: MIT
//
// Looks into Enhanced GJK at work on a scene. None of it depends on the layout, so it is done for one.
#pragma once

#include <string>

#include "edgewise/measure/algorithm_work.hpp"
#include "edgewise/sweep/shared_queries.hpp"
#include "edgewise/bench/registry.hpp"

namespace edgewise {

/// For GJK on the layout of the paper in double; for anything else only the reason.
[[nodiscard]] AlgorithmWork algorithm_work(const std::string& algorithm, const TableType& type,
                                           const Group& group);

}  // namespace edgewise
