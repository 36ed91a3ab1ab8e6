// SPDX-License-Identifier: MIT
//
// What queries of a body take: time, bytes of its table, lines. Cold pairs of two such bodies, all bodies
// timed in turn in rounds, the shortest of each.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "edgewise/bench/registry.hpp"
#include "edgewise/geometry/polyhedron.hpp"

namespace edgewise::studies::advise {

struct BodyCost {
    double ns = 0, table_bytes = 0, lines = 0;  ///< ns and lines per query
};

/// In the bodies' order. Throws std::invalid_argument where a table cannot hold one.
[[nodiscard]] std::vector<BodyCost> costs_of(std::span<const Polyhedron> bodies, const bench::TableType& type,
                                             const std::string& algorithm);

}  // namespace edgewise::studies::advise
