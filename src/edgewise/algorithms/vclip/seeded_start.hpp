// SPDX-License-Identifier: MIT
//
// A start nearer than the pair's last features, for tables with seeds (layout_parts/seeds.hpp): V-Clip walks
// from wherever it stands, one feature a step, so a cold start or a large turn costs a walk over the body.
// The vertices that face each other are found by climbs, which cost less per vertex than V-Clip's states, and
// a few from a seed.
#pragma once

#include "edgewise/algorithms/support.hpp"
#include "edgewise/algorithms/vclip/body.hpp"
#include "edgewise/algorithms/vclip/proof.hpp"

namespace edgewise::vclip {

/// A run that has not ended by this step is taken to have started far off.
inline constexpr int steps_before_seeds = 4;

template <class TableA, class TableB>
inline constexpr bool has_seeds = SeededTable<TableA>&& SeededTable<TableB>;

/// As a cold pair starts, and as good as never another.
template <class TableA, class TableB>
[[nodiscard]] bool start_is_cold(const Body<TableA>& a, const Body<TableB>& b) {
    return a.feature == Feature<TableA>::of_vertex(a.table.first_vertex()) &&
           b.feature == Feature<TableB>::of_vertex(b.table.first_vertex());
}

/// Moves both bodies to the vertices that face each other: first along the line between the origins, then
/// along the line between the vertices so far, as long as these come nearer. Of round bodies the first pair
/// is next to the closest features. False, and nothing moved, if the present ones are nearer.
template <class TableA, class TableB>
[[nodiscard]] [[gnu::noinline]] bool start_nearer(Body<TableA>& a, Body<TableB>& b) {
    using Scalar = ComputeOf<TableA>;
    constexpr int most_rounds = 3;
    auto vertex_a = vertex_on(a);
    auto vertex_b = vertex_on(b);
    const Vec3<Scalar> first = a.table.vertex(vertex_a) - a.from_other.point(b.table.vertex(vertex_b));
    Scalar nearest = squared_norm(first);
    Vec3<Scalar> between = -a.from_other.translation;  // from B to A
    bool moved = false;
    for (int round = 0; round < most_rounds; ++round) {
        const auto on_a = cold_support(a.table, Vec3<Scalar>(-between), vertex_a);
        const auto on_b = cold_support(b.table, b.from_other.direction(between), vertex_b);
        between = on_a.point - a.from_other.point(on_b.point);
        if (!(squared_norm(between) < nearest)) break;
        nearest = squared_norm(between);
        vertex_a = on_a.vertex;
        vertex_b = on_b.vertex;
        moved = true;
    }
    if (!moved) return false;
    a.move_to_vertex(vertex_a);
    b.move_to_vertex(vertex_b);
    return true;
}

}  // namespace edgewise::vclip
