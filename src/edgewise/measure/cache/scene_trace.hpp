// SPDX-License-Identifier: MIT
//
// What a cell's traced passes gave: misses of modelled machines, reuse, heat.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/measure/cache/scene_caches.hpp"

namespace edgewise::measure {

/// A machine, or why it was not modelled.
struct ModelledMachine {
    std::string name, reason;
    MachineMisses first, steady;      ///< passes
    std::vector<std::uint64_t> cold;  ///< by cache level: misses of queries from empty caches
};

/// What of the tables' memory the scene ever touched.
struct TouchedTables {
    std::uint64_t bytes = 0, of_bytes = 0;
    std::map<std::string, double> by_component;  ///< part of the component's bytes
    /// part of the table's elements that hold vertices, edges, faces; nothing: it has none of their own
    std::optional<double> vertices, edges, faces;
};

/// Accesses of both passes.
struct SceneHeat {
    std::vector<std::uint64_t> by_field, by_step;
    std::uint64_t queries = 0, lines = 0;
    std::uint64_t lines_of_half = 0, lines_of_most = 0;  ///< hottest, of 50 % and of 90 % of accesses
    TouchedTables tables;
};

struct SceneTrace {
    std::string reason = "this cell was not chosen for modelled caches",
                remedy = "edgewise sweep --caches";     ///< why there is nothing; empty: there is
    std::uint64_t queries = 0, frames = 0, tables = 0;  ///< of a pass; tables in all
    std::vector<ModelledMachine> machines;
    std::vector<ModelledMachine> policies;  ///< one of the machines under other replacement policies
    ReuseOf lines, pages;
    SceneHeat heat;
    std::size_t answered = 0;  ///< queries of the second pass, cold first ones of pairs included
    double distances = 0;      ///< sum of its answers, in order
    std::span<const std::string_view> fields, steps;  ///< names by number

    [[nodiscard]] bool traced() const { return reason.empty(); }
};

}  // namespace edgewise::measure
