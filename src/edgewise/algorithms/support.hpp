// SPDX-License-Identifier: MIT
//
// The support point: the vertex farthest along a direction. Large bodies climb along neighbour rings
// (Cameron, "Enhancing GJK", ICRA 1997): on a convex body a vertex without a farther neighbour is the
// farthest. Small bodies are scanned: below the break-even a scan's predictable loop, of several vertices at
// a time, beats the climb's unpredictable one. Where neighbours are level to within rounding, the climb
// visits all of them: behind them it may continue. Bodies on which even that may end below the top are
// scanned (geometry/strictly_convex.hpp).
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>

#include "edgewise/geometry/pack.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/table/contract.hpp"

namespace edgewise {

/// Highest of eight numbers, in three steps.
template <class Scalar>
[[nodiscard]] Scalar highest(const std::array<Scalar, 8>& of) {
    const Scalar a = std::max(of[0], of[1]), b = std::max(of[2], of[3]);
    const Scalar c = std::max(of[4], of[5]), d = std::max(of[6], of[7]);
    return std::max(std::max(a, b), std::max(c, d));
}

/// Position of the first of eight numbers that equals `number`.
template <class Scalar>
[[nodiscard]] int first_equal(const std::array<Scalar, 8>& of, Scalar number) {
    unsigned equal = 1U << 8;
#pragma GCC unroll 8
    for (unsigned i = 0; i < 8; ++i) equal |= static_cast<unsigned>(of[i] == number) << i;
    return std::countr_zero(equal);
}

template <class Table>
struct SupportPoint {
    typename Table::Vertex vertex;
    Vec3<ComputeOf<Table>> point;
    ComputeOf<Table> along;  ///< <point, direction>
};

/// A table that declares that its handles count the vertices, from 0: each can be named without a walk.
template <class Table>
concept CountedTable = ClimbingTable<Table> && requires {
    requires Table::counts_vertices && std::unsigned_integral<typename Table::Vertex>;
};

/// Vertices below which a linear scan is used, from a warm start. By packs, time of scanning over time of
/// climbing, GJK at 0.01 / 1 rad per step, a Zen 3 with AVX2: lean_f64 0.86 / 0.88 at 8 vertices, 0.91 / 0.92
/// at 26, 0.97 / 0.94 at 38, 1.01 / 0.95 at 56; aos_f64 0.88 / 0.91, 0.93 / 0.95, 1.0 / 0.97, 1.03 / 0.98;
/// singles the same. So bodies that a search in singles scans (search/single_search.hpp) are scanned. One
/// by one, as a list makes it, climbing took 0.89 of scanning at 8 vertices and 0.67 at 38, on a Zen 5.
inline constexpr std::size_t most_scanned = 64;
template <class Table>
inline constexpr std::size_t scan_below = CountedTable<Table> ? most_scanned + 1 : 8;

/// Vertices below which a scan is used from a cold start, where branch prediction fails on every climbing
/// step. Scanning over climbing: lean_f64 0.77 at 38 vertices and 0.97 at 60, lean_f32 0.74 and 0.85, aos_f64
/// 0.86 and 1.0; with a seed (lean_seeds) 0.88 and 1.0. One by one 0.69 to 0.80 at 8, 0.83 at 18, 1.02 at 38.
template <class Table>
inline constexpr std::size_t scan_cold_below = CountedTable<Table> ? 65 : 32;

/// Heights of a pack of vertices, of the last one in place of those behind it.
template <CountedTable Table, class Number>
[[gnu::always_inline]] inline void heights_from(const Table& table, const Vec3<Number>& direction,
                                                std::size_t first, typename Pack<Number>::Numbers& to) {
    const std::size_t last = table.vertex_count() - 1;
    Pack<Number>::fill(
        [&](std::size_t lane) __attribute__((always_inline)) {
            const auto v = static_cast<typename Table::Vertex>(std::min(first + lane, last));
            return dot(cast<Number>(table.vertex(v)), direction);
        },
        to);
}

/// Scans a pack of vertices at a time, the last ones perhaps twice: each lane keeps its highest, and at the
/// end the first vertex with the highest value of all wins, as in scan_any. No processor can predict which
/// vertex is the highest so far: nothing branches except the loop.
template <CountedTable Table>
[[nodiscard]] SupportPoint<Table> scan_packs(const Table& table, const Vec3<ComputeOf<Table>>& direction) {
    using Vertex = typename Table::Vertex;
    using Of = Pack<ComputeOf<Table>>;
    const std::size_t count = table.vertex_count();
    typename Of::Numbers heights;
    heights_from(table, direction, 0, heights);
    HighestOfPacks<Of> highest(heights);
    for (std::size_t first = Of::size; first < count; first += Of::size) {
        heights_from(table, direction, first, heights);
        highest.take(heights, first);
    }
    const auto vertex = static_cast<Vertex>(highest.first_highest(count - 1));
    const auto point = table.vertex(vertex);
    return {vertex, point, dot(point, direction)};
}

/// The farthest vertex of all, the first of equals, by a loop that any table allows.
template <SupportTable Table>
[[nodiscard]] [[gnu::noinline]] SupportPoint<Table> scan_any(const Table& table,
                                                             const Vec3<ComputeOf<Table>>& direction) {
    if constexpr (CountedTable<Table> && pack_bytes > 0) {
        return scan_packs(table, direction);
    } else {
        const auto first = table.first_vertex();
        const auto start = table.vertex(first);
        SupportPoint<Table> best{first, start, dot(start, direction)};
        for (const auto v : table.all_vertices()) {
            const auto point = table.vertex(v);
            const auto along = dot(point, direction);
            if (along > best.along) best = {v, point, along};
        }
        return best;
    }
}

/// The farthest vertex by a scan. A layout that can scan faster defines a member of this name, which must
/// return the same vertex.
template <SupportTable Table>
[[nodiscard]] SupportPoint<Table> scan_support(const Table& table, const Vec3<ComputeOf<Table>>& direction) {
    if constexpr (requires { table.scan_support(direction); }) {
        const auto vertex = table.scan_support(direction);
        const auto point = table.vertex(vertex);
        return {vertex, point, dot(point, direction)};
    } else {
        return scan_any(table, direction);
    }
}

/// A table that knows a vertex far along any direction without a walk (layout_parts/seeds.hpp).
template <class Table>
concept SeededTable = ClimbingTable<Table> && requires(const Table& table, Vec3<ComputeOf<Table>> direction) {
    { table.seed(direction) } -> std::same_as<typename Table::Vertex>;
};

/// Returns true if climbs on this table find the top.
template <ClimbingTable Table>
[[nodiscard]] bool may_climb(const Table& table) {
    if constexpr (requires { table.climbable(); })
        return table.climbable();
    else
        return table.strictly_convex();
}

/// Largest difference in height of vertices that may be equally high.
template <ClimbingTable Table>
[[nodiscard]] ComputeOf<Table> level_band(const Table& table, const SupportPoint<Table>& near,
                                          const Vec3<ComputeOf<Table>>& direction) {
    using Scalar = ComputeOf<Table>;
    Scalar size = max_abs(near.point);
    if constexpr (requires { table.reach(); }) size = static_cast<Scalar>(table.reach());
    return Tolerance<Scalar>::level * size * max_abs(direction);
}

/// Leaves a vertex with no higher neighbour but with neighbours as high to within `band`: past all level ones
/// to a higher vertex. False, and `best` stays the top, if there is none. Vertices above any height are
/// connected on a convex body, so this misses none. Where very many are level a scan finds the highest.
template <ClimbingTable Table>
[[nodiscard]] [[gnu::noinline]] bool leave_level(const Table& table, const Vec3<ComputeOf<Table>>& direction,
                                                 ComputeOf<Table> band, SupportPoint<Table>& best) {
    std::array<typename Table::Vertex, 32> level;
    level[0] = best.vertex;
    std::size_t count = 1;
    for (std::size_t i = 0; i < count; ++i) {
        for (const auto v : table.neighbours(level[i])) {
            const auto point = table.vertex(v);
            const auto along = dot(point, direction);
            if (along > best.along) {
                best = {v, point, along};
                return true;
            }
            const auto known = level.begin() + static_cast<std::ptrdiff_t>(count);
            if (along < best.along - band || std::find(level.begin(), known, v) != known) continue;
            if (count == level.size()) {
                best = scan_support(table, direction);
                return false;
            }
            level[count++] = v;
        }
    }
    return false;
}

/// One round of a climb over the ring of best.vertex, eight neighbours at a time: moves `best` to the highest
/// neighbour, and returns true, if that is higher. `next`: the highest of the other neighbours.
template <RingBlockTable Table>
[[nodiscard]] bool climb_ring_blocks(const Table& table, const Vec3<ComputeOf<Table>>& direction,
                                     SupportPoint<Table>& best, ComputeOf<Table>& next) {
    bool improved = false;
    for (const auto block : table.ring_blocks(best.vertex)) {
        const auto heights = block.heights(direction);
        const auto top = highest(heights);
        if (top > best.along) {
            const auto lane = static_cast<std::size_t>(first_equal(heights, top));
            best = {block.vertex(lane), block.point(lane), heights[lane]};
            improved = true;
        } else {
            next = std::max(next, top);
        }
    }
    return improved;
}

/// Steepest ascent from `start`. Strictly upward, so it ends within as few rounds as there are vertices; if
/// not, the shape changes during the query, and a scan decides. A neighbour as high as the top, except for
/// rounding, may hide a slope behind it.
template <ClimbingTable Table>
[[nodiscard]] SupportPoint<Table> climb_support(const Table& table, const Vec3<ComputeOf<Table>>& direction,
                                                typename Table::Vertex start) {
    using Scalar = ComputeOf<Table>;
    const auto point = table.vertex(start);
    SupportPoint<Table> best{start, point, dot(point, direction)};
    for (std::size_t round = 0; round <= table.vertex_count(); ++round) {
        Scalar next = -std::numeric_limits<Scalar>::infinity();
        bool improved = false;
        if constexpr (RingBlockTable<Table>) {
            improved = climb_ring_blocks(table, direction, best, next);
        } else {
            for (const auto v : table.neighbours(best.vertex)) {
                const auto candidate = table.vertex(v);
                const auto along = dot(candidate, direction);
                if (along > best.along) {
                    best.point = candidate;
                    best.along = along;
                    start = v;
                    improved = true;
                } else {
                    next = std::max(next, along);
                }
            }
            best.vertex = start;
        }
        if (improved) continue;
        const Scalar band = level_band(table, best, direction);
        if (!(next >= best.along - band) || !leave_level(table, direction, band, best)) return best;
        start = best.vertex;
    }
    assert(false && "a climb passed more vertices than there are");
    return scan_support(table, direction);
}

/// The support point, by a climb from `start` where that pays (`scan_under` vertices and more) and is safe,
/// else by a scan.
template <SupportTable Table>
[[nodiscard]] SupportPoint<Table> support(const Table& table, const Vec3<ComputeOf<Table>>& direction,
                                          [[maybe_unused]] typename Table::Vertex start,
                                          [[maybe_unused]] std::size_t scan_under = scan_below<Table>) {
    if constexpr (ClimbingTable<Table>) {
        if (may_climb(table) && table.vertex_count() >= scan_under)
            return climb_support(table, direction, start);
    }
    return scan_support(table, direction);
}

/// Returns true if all vertices can be looked at in the time of a climb.
template <SupportTable Table>
[[nodiscard]] bool is_small(const Table& table) {
    if constexpr (requires { table.vertex_count(); })
        return table.vertex_count() <= most_scanned;
    else
        return false;
}

/// Height of the farthest vertex, by a scan. A layout that can scan faster defines a member of this name.
template <SupportTable Table, class Number>
[[nodiscard]] Number scan_height(const Table& table, const Vec3<Number>& direction) {
    if constexpr (requires { table.scan_height(direction); }) {
        return table.scan_height(direction);
    } else if constexpr (CountedTable<Table> && pack_bytes > 0) {
        typename Pack<Number>::Numbers greatest, heights;
        heights_from(table, direction, 0, greatest);
        for (std::size_t first = Pack<Number>::size; first < table.vertex_count();
             first += Pack<Number>::size) {
            heights_from(table, direction, first, heights);
            greatest = heights > greatest ? heights : greatest;
        }
        return Pack<Number>::greatest(greatest);
    } else {
        Number greatest = -std::numeric_limits<Number>::infinity();
        for (const auto v : table.all_vertices())
            greatest = std::max(greatest, dot(cast<Number>(table.vertex(v)), direction));
        return greatest;
    }
}

/// Vertices up to which a wider scalar scans heights: neighbours of a vertex lie in more lines. Lines of GJK
/// on aos_f32 by neighbours / by a scan, 0.01 rad per step and cold: at 18 vertices 9.1 / 7.3 and 11.8 / 8.0,
/// at 38 12.4 / 14.0 and 20.1 / 16.0, with 43 / 75 and 112 / 155 reads. Near contact in singles, trying
/// neighbours first above this many takes 0.81 to 0.85 of the time.
inline constexpr std::size_t most_heights_scanned = 32;

/// The height of a vertex and its neighbours in a wider scalar than the table's, if none of them is higher by
/// more than rounding and the body is strictly convex for the table's scalar: then no vertex is. Behind level
/// neighbours a body can rise by about rounding over strict_turn, 2e-9 of its size in doubles (an estimate).
template <ClimbingTable Table, class Number>
[[nodiscard]] std::optional<Number> height_of_top(const Table& table, const Vec3<Number>& direction,
                                                  typename Table::Vertex vertex) {
    if (!table.strictly_convex()) return std::nullopt;
    const Vec3<Number> point = cast<Number>(table.vertex(vertex));
    const Number height = dot(point, direction);
    Number highest = height;
    for (const auto v : table.neighbours(vertex))
        highest = std::max(highest, dot(cast<Number>(table.vertex(v)), direction));
    const Number band = Tolerance<Number>::level * max_abs(point) * max_abs(direction);
    return highest <= height + band ? std::optional(highest) : std::nullopt;
}

/// Height of the farthest vertex along a direction, in the direction's scalar. In the table's own scalar, a
/// climb from `start` finds it on large bodies. In a wider one, `start` and its neighbours are tried first
/// above most_heights_scanned vertices; else all vertices.
template <SupportTable Table, class Number>
[[nodiscard]] Number greatest_height(const Table& table, const Vec3<Number>& direction,
                                     typename Table::Vertex start) {
    if constexpr (std::is_same_v<Number, ComputeOf<Table>>) {
        if (!is_small(table)) return support(table, direction, start).along;
    } else if constexpr (ClimbingTable<Table>) {
        if (table.vertex_count() > most_heights_scanned)
            if (const auto height = height_of_top(table, direction, start)) return *height;
    }
    return scan_height(table, direction);
}

/// The support point from a cold start, far from the top: climbs from the table's seed, if that is farther
/// than `start`.
template <SupportTable Table>
[[nodiscard]] SupportPoint<Table> cold_support(const Table& table, const Vec3<ComputeOf<Table>>& direction,
                                               typename Table::Vertex start) {
    if constexpr (SeededTable<Table>) {
        if (table.vertex_count() >= scan_cold_below<Table>) {
            const auto seed = table.seed(direction);
            if (dot(table.vertex(seed), direction) > dot(table.vertex(start), direction)) start = seed;
        }
    }
    return support(table, direction, start, scan_cold_below<Table>);
}

}  // namespace edgewise
