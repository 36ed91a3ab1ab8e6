// SPDX-License-Identifier: MIT
//
// Looks into Enhanced GJK at work on a scene. None of it depends on the layout, so it is done for one.
#pragma once

#include <string>

#include "edgewise/bench/registry.hpp"
#include "edgewise/measure/algorithm_work.hpp"
#include "edgewise/sweep/shared_queries.hpp"

namespace edgewise::sweep {

/// For GJK on the layout of the paper in double; for anything else only the reason.
[[nodiscard]] measure::AlgorithmWork algorithm_work(const std::string& algorithm,
                                                    const bench::TableType& type,
                                                    const SharedQueries& shared);

}  // namespace edgewise::sweep
