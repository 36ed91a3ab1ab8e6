// SPDX-License-Identifier: MIT
//
// A start nearer than the present features: the vertices that face each other along the line between the
// origins. V-Clip walks from its start, so a cold start or a large turn costs a walk over the body. Scans and
// climbs find these vertices at a fraction of a state's cost per vertex, from a seed (layout_parts/seeds.hpp)
// in a few steps. Boxes have a start of their own (box_start.hpp). Departure: the report starts anywhere.
#pragma once

#include <algorithm>
#include <cstddef>

#include "edgewise/algorithms/support.hpp"
#include "edgewise/algorithms/vclip/body.hpp"
#include "edgewise/algorithms/vclip/box_start.hpp"
#include "edgewise/algorithms/vclip/feature_pair.hpp"

namespace edgewise::vclip {

/// Returns a vertex of the feature: the start of a search for one that lies farther.
template <class Table>
[[nodiscard]] typename Table::Vertex vertex_on(const Body<Table>& body) {
    switch (body.feature.kind()) {
        case FeatureKind::vertex:
            return body.feature.vertex();
        case FeatureKind::edge:
            return body.table.tail(body.feature.edge());
        case FeatureKind::face:
            break;
    }
    return body.table.tail((*body.table.ring_of_face(body.feature.face()).begin()).edge);
}

/// A warm run that takes more steps than this started far off, over tables with seeds and of bodies that are
/// scanned: the pair's next query looks for a nearer start first, and goes on doing so until there is none.
/// If both bodies have more vertices than most_walked, the run itself looks for one, too. Time of aos_f64
/// over that without looking first, 0.1 / 1 rad per step / in any pose, a Xeon with AVX-512: boxes 0.98 /
/// 1.03 / 0.61, spheres of 38 vertices 0.95 / 0.60 / 0.66. On its way alone boxes took 1.01 / 1.21 / 0.88.
inline constexpr int steps_before_search = 5;
inline constexpr std::size_t most_walked = 16;

/// The same without seeds, where a search climbs from far off. Where a run takes twice as many steps from a
/// nearer start, as between prisms, the pair walks on from then on. Time of aos_f64 over walking on, a Zen 4,
/// 0.3 / 1 rad per step / any pose: spheres of 386 vertices 0.91 / 0.48 / 0.44, of 1538 0.55 / 0.39 / 0.39,
/// ellipsoids 1.00 / 0.86 / 0.69 and 1.10 / 0.93 / 0.98; at most 1.15 (discs of 1538, 0.5 rad).
inline constexpr int steps_before_climb = 24;

template <class TableA, class TableB>
inline constexpr bool are_boxes = BoxFeatureTable<TableA>&& BoxFeatureTable<TableB>;

/// The start of two boxes takes less time than three steps. Time of box_f64 with one / two / three, 0.01 /
/// 0.1 / 1 rad per step / any pose: 97, 126, 158, 179 / 94, 121, 167, 189 / 90, 113, 195, 211 ns.
inline constexpr int steps_before_search_of_boxes = 2;

/// Returns true if the features are those of a cold start; a warm pair almost never has them.
template <class TableA, class TableB>
[[nodiscard]] bool start_is_cold(const Body<TableA>& a, const Body<TableB>& b) {
    return a.feature == Feature<TableA>::of_vertex(a.table.first_vertex()) &&
           b.feature == Feature<TableB>::of_vertex(b.table.first_vertex());
}

/// Moves both bodies to the vertices that face each other. Time over that of a walk from the first vertices,
/// cold, 8 / 38 / 386 vertices: aos_f64 0.71 / 0.50 / 0.33, lean_f64 0.61 / 0.43 / 0.26. A second round,
/// along the line between the vertices found, took 1.2 of it, also for bodies a seventh as thick as wide.
/// Nothing is moved if the present features' vertices are nearer.
template <class TableA, class TableB>
[[nodiscard]] [[gnu::noinline]] Start start_nearer(Body<TableA>& a, Body<TableB>& b) {
    using Scalar = ComputeOf<TableA>;
    const auto vertex_a = vertex_on(a);
    const auto vertex_b = vertex_on(b);
    const Vec3<Scalar> present = a.table.vertex(vertex_a) - a.from_other.point(b.table.vertex(vertex_b));
    const Vec3<Scalar>& towards_b = a.from_other.translation;
    const auto on_a = cold_support(a.table, towards_b, vertex_a);
    const auto on_b = cold_support(b.table, b.from_other.direction(Vec3<Scalar>(-towards_b)), vertex_b);
    const Vec3<Scalar> between = on_a.point - a.from_other.point(on_b.point);
    if (!(squared_norm(between) < squared_norm(present))) return Start::none;
    a.move_to_vertex(on_a.vertex);
    b.move_to_vertex(on_b.vertex);
    return Start::nearer;
}

/// Moves two boxes to the features next to their closest points. Where there are none the boxes overlap, or
/// nearly: they are moved to the vertices next to the points. Nothing is moved if the present features'
/// vertices are nearer than the points.
template <BoxFeatureTable TableA, BoxFeatureTable TableB>
[[nodiscard]] [[gnu::noinline]] Start start_nearer(Body<TableA>& a, Body<TableB>& b) {
    const Transform<double> a_from_b = cast<double>(a.from_other);
    BoxPoints points(a.table.half_extents(), b.table.half_extents(), a_from_b);
    const double size =
        std::max({max_abs(a_from_b.translation), double{a.table.reach()}, double{b.table.reach()}});
    const Start found = points.approach(double{Tolerance<ComputeOf<TableA>>::contact_noise} * size);
    if (found == Start::overlaps) {  // the next query starts cold: it looks for such a point first
        a.move_to_vertex(a.table.first_vertex());
        b.move_to_vertex(b.table.first_vertex());
        return found;
    }
    const auto vertex = [](const auto& body) { return cast<double>(body.table.vertex(vertex_on(body))); };
    if (!(points.squared_distance() < squared_norm(Vec3d(vertex(a) - a_from_b.point(vertex(b))))))
        return Start::none;
    const bool is_feature = found == Start::nearer;
    const auto feature_a = feature_along<TableA>(points.vertex_of_a(), is_feature ? points.free_in_a() : 0);
    const auto feature_b = feature_along<TableB>(points.vertex_of_b(), is_feature ? points.free_in_b() : 0);
    if (feature_a == a.feature && feature_b == b.feature) return Start::none;
    a.feature = feature_a;
    b.feature = feature_b;
    return Start::nearer;
}

/// Steps after which a run looks for a nearer start; -1: never.
template <class TableA, class TableB>
[[nodiscard]] int most_steps_on_foot([[maybe_unused]] const TableA& a, [[maybe_unused]] const TableB& b) {
    if constexpr (are_boxes<TableA, TableB>) return steps_before_search_of_boxes;
    if constexpr (SeededTable<TableA> && SeededTable<TableB>) return steps_before_search;
    if constexpr (CountedTable<TableA> && CountedTable<TableB>)
        return is_small(a) && is_small(b) ? steps_before_search : steps_before_climb;
    return -1;
}

/// What is known of a run.
struct Outlook {
    int far_off = 0;  ///< the step before which the run is known to have moved far; 0: never
    bool overlaps = false;
    FirstTry next = FirstTry::walk;  ///< what the next query tries first
};

/// Moves a pair that starts cold, or moved far before, to a nearer start.
template <class TableA, class TableB>
[[nodiscard]] Outlook start_nearer_if_far(Body<TableA>& a, Body<TableB>& b, FirstTry first) {
    const bool is_cold = start_is_cold(a, b);
    if (first == FirstTry::walk_on && !is_cold) return {.next = first};
    if (is_cold || first == FirstTry::nearer_start) {
        const Start start = start_nearer(a, b);
        if (start == Start::overlaps) return {.overlaps = true};
        if (start == Start::nearer && !is_cold) return {.next = FirstTry::nearer_start};
    }
    return {is_cold ? 0 : 1 + most_steps_on_foot(a.table, b.table)};
}

/// Looks for a nearer start of a run that has moved far, where its walk would be long.
template <class TableA, class TableB>
void start_nearer_on_the_way(Body<TableA>& a, Body<TableB>& b, Outlook& known) {
    const bool is_short = std::min(a.table.vertex_count(), b.table.vertex_count()) <= most_walked;
    const Start start = is_short && !are_boxes<TableA, TableB> ? Start::nearer : start_nearer(a, b);
    if (start == Start::nearer) known.next = FirstTry::nearer_start;
    known.overlaps = start == Start::overlaps;
}

/// What the next query tries first if the bodies are not close. Boxes at rest must not leave their features.
template <class TableA, class TableB>
[[nodiscard]] FirstTry next_after(const Outlook& known, int steps) {
    if (known.next != FirstTry::nearer_start) return known.next;
    if constexpr (are_boxes<TableA, TableB>)
        return steps == std::max(known.far_off, 1) ? known.next : FirstTry::walk;
    return steps - known.far_off > 2 * steps_before_climb ? FirstTry::walk_on : known.next;
}

}  // namespace edgewise::vclip
