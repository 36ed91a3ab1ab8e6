// SPDX-License-Identifier: MIT
//
// How a runner places a scene's tables (in what order a body's vertices are numbered, whether instances share
// a table, where the memory comes from), and what it asks of every query.
#pragma once

#include <cstdint>

#include "edgewise/algorithms/query_options.hpp"
#include "edgewise/bench/memory/allocators.hpp"
#include "edgewise/geometry/vertex_order.hpp"
#include "edgewise/table/needs.hpp"

namespace edgewise::bench {

enum class Sharing : std::uint8_t {
    as_scene,      ///< as the scene needs it: shared, except for `pressure`
    shared,        ///< one table per body, instances point at it
    per_instance,  ///< a copy each, as in the paper
};

struct TableOptions {
    VertexOrder order = VertexOrder::given;
    Sharing sharing = Sharing::as_scene;
    AllocatorKind allocator = AllocatorKind::arena;

    [[nodiscard]] bool operator==(const TableOptions&) const = default;
};

/// Over the larger body's extent: some frames of motion at everyday speeds, and what engines keep contacts
/// for.
inline constexpr double usual_margin = 0.1;

struct RunnerOptions {
    QueryOptions query = {};  ///< contact_tolerance in the given bodies' unit; 0 where needs have a margin
    Needs needs = Needs::witnesses;  ///< what passes ask of every answer, and pay for
    TableOptions tables = {};
    double margin =
        usual_margin;             ///< where needs have one, over the extent of the larger of a query's bodies
    bool batch = false;           ///< pairs in a row that differ are asked together
    double radius = 0;            ///< around every body, over its extent; needs up to witnesses, pair by pair
    bool recorded_radii = false;  ///< the radii of the scene's instances instead

    /// Returns true if bodies have a radius.
    [[nodiscard]] bool has_radius() const { return radius > 0 || recorded_radii; }

    /// Sets the needs; for a verdict alone queries end as soon as it is known.
    void set_needs(Needs wanted) {
        needs = wanted;
        query.cutoff = wanted == Needs::verdict ? 0 : QueryOptions{}.cutoff;
    }
};

}  // namespace edgewise::bench
