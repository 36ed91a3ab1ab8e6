// SPDX-License-Identifier: MIT
//
// What a store keeps for pictures of heat on the body itself: each body once, and how often the scene of a
// cell read each of its features.
#pragma once

#include <string>

#include "edgewise/bench/registry.hpp"
#include "edgewise/bench/trace/touched_tables.hpp"

namespace edgewise::sweep {

/// {"vertices": [x, y, z, ...], "edges": [tail, head, ...], "faces": [[vertex, ...], ...]}
[[nodiscard]] std::string body_json(const Polyhedron& body);

/// {"queries": n, "vertices": [reads, ...], "edges": ..., "faces": ...}, in the body's order; null where the
/// layout stores nothing for these alone.
[[nodiscard]] std::string heat_json(const bench::FeatureHeat& heat);

/// Whether a table type's order of features is the body's, and its heat stands for its layout's (of one
/// precision each); of bodies that a picture can show.
[[nodiscard]] bool shows_heat(const bench::TableType& type, std::int64_t vertices);

}  // namespace edgewise::sweep
