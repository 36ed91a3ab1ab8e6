// SPDX-License-Identifier: MIT
//
// Names of the numbers of a trace: fields of tables (table/loader.hpp), then of a scene's data besides its
// tables; and steps of algorithms.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "edgewise/algorithms/sweep_and_prune.hpp"
#include "edgewise/geometry/feature.hpp"
#include "edgewise/table/loader.hpp"

namespace edgewise::bench {

/// Behind the fields of tables.
inline constexpr std::uint8_t pair_cache_field = static_cast<std::uint8_t>(Field::seed) + 1;
/// The first array of the broad phase; its other arrays follow.
inline constexpr std::uint8_t broad_phase_field = pair_cache_field + 1;

enum class TraceStep : std::uint8_t {
    start,  ///< before the first state or iteration
    vertex_vertex,
    vertex_edge,
    vertex_face,
    edge_edge,
    edge_face,
    settle,  ///< V-Clip's answer is not believed: GJK on the same tables
    gjk_iteration,
    pair_cache,
    broad_phase,
};

/// The state of V-Clip on features of two kinds, in either order. Work after the last state (points, proofs)
/// counts as part of it.
[[nodiscard]] constexpr TraceStep step_of(FeatureKind a, FeatureKind b) {
    if (a > b) return step_of(b, a);
    if (a == FeatureKind::vertex) {
        if (b == FeatureKind::vertex) return TraceStep::vertex_vertex;
        return b == FeatureKind::edge ? TraceStep::vertex_edge : TraceStep::vertex_face;
    }
    return b == FeatureKind::edge ? TraceStep::edge_edge : TraceStep::edge_face;
}

/// Names of the fields, by number.
[[nodiscard]] inline std::span<const std::string_view> field_names() {
    static constexpr std::array<std::string_view, broad_phase_field + broad_phase_arrays> names = {
        "vertex",    "voronoi_plane", "edge_direction", "edge_ends", "face_plane", "vertex_ring",
        "face_ring", "neighbour",     "edge_made",      "seed",      "pair_cache", "boxes",
        "order_x",   "order_y",       "order_z",        "near_pairs"};
    return names;
}

[[nodiscard]] inline std::span<const std::string_view> step_names() {
    static constexpr std::array<std::string_view, static_cast<std::size_t>(TraceStep::broad_phase) + 1>
        names = {"start",     "vertex_vertex", "vertex_edge",   "vertex_face", "edge_edge",
                 "edge_face", "settle",        "gjk_iteration", "pair_cache",  "broad_phase"};
    return names;
}

}  // namespace edgewise::bench
