// SPDX-License-Identifier: MIT
//
// What an answer may be wrong by, relative to the scale of its pair, before it counts as wrong: for runs that
// ask hard or foreign pairs. A sweep's own scenes are held to what computes alone (sweep/verify.hpp).
#pragma once

#include <string>

#include "edgewise/bench/registry.hpp"

namespace edgewise::studies {

struct AllowedErrors {
    double distance = 0;  ///< of distances and of the distance of witness points
    double depth = 0;
};

/// Where planes are stored in single and computed with in double, V-Clip is as good as the planes.
[[nodiscard]] AllowedErrors allowed_errors(const bench::TableType& type, const std::string& algorithm);

}  // namespace edgewise::studies
