// SPDX-License-Identifier: MIT
//
// Cost of the queries of a body: time, bytes of its table, lines. Queries are of cold pairs of two equal
// bodies. All bodies are timed in turn in rounds; the shortest time of each body counts.
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

/// Returns the costs in the bodies' order. Throws std::invalid_argument where a table cannot hold a body.
[[nodiscard]] std::vector<BodyCost> costs_of(std::span<const Polyhedron> bodies, const bench::TableType& type,
                                             const std::string& algorithm);

}  // namespace edgewise::studies::advise
