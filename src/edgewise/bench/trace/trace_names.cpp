// SPDX-License-Identifier: MIT
#include "edgewise/bench/trace/trace_names.hpp"

#include <array>

#include "edgewise/algorithms/sweep_and_prune.hpp"

namespace edgewise::bench {

std::span<const std::string_view> field_names() {
    static constexpr std::array<std::string_view, broad_phase_field + broad_phase_arrays> names = {
        "vertex",      "voronoi_plane", "edge_direction", "edge_ends", "face_plane",
        "vertex_ring", "face_ring",     "neighbour",      "edge_made", "pair_cache",
        "boxes",       "order_x",       "order_y",        "order_z",   "near_pairs"};
    return names;
}

std::span<const std::string_view> step_names() {
    static constexpr std::array<std::string_view, static_cast<std::size_t>(TraceStep::broad_phase) + 1>
        names = {"start",     "vertex_vertex", "vertex_edge",   "vertex_face", "edge_edge",
                 "edge_face", "settle",        "gjk_iteration", "pair_cache",  "broad_phase"};
    return names;
}

}  // namespace edgewise::bench
