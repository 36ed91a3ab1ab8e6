// SPDX-License-Identifier: MIT
//
// The point nearest to the origin in a simplex of at most four points, by signs alone: one text for GMP
// integers (the answer) and for double (a first guess). After Wolfe, "Finding the nearest point in a
// polytope", 1976, and Gilbert, Johnson and Keerthi, 1988.
//
// Departs from both in what it keeps: not the nearest point but a direction u along it and the height h =
// u.p, the same for every point p of the simplex. Then the nearest point is (h / u.u) u, its distance h /
// sqrt(u.u), and "no point of the set lies lower" reads u.q >= h. This halves the digits that a rational
// point would need.
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "edgewise/truth/integer_vector.hpp"

namespace edgewise::truth {

/// A vertex of body A and a vertex of body B: a point of the Minkowski difference A - B.
struct VertexPair {
    std::uint32_t a = 0;
    std::uint32_t b = 0;

    friend bool operator==(const VertexPair&, const VertexPair&) = default;
};

template <class Vec>
using ScalarOf = decltype(dot(std::declval<const Vec&>(), std::declval<const Vec&>()));

/// Affinely independent points; their hull holds the nearest point strictly inside (all weights positive).
template <class Vec>
struct MinimumSimplex {
    std::array<Vec, 4> point;
    std::array<VertexPair, 4> pair;
    int size = 0;
    Vec direction;           ///< u; unset for four points
    ScalarOf<Vec> height{};  ///< u.p, never negative; zero for four points

    [[nodiscard]] bool holds_origin() const { return sign(height) == 0; }
};

/// Some points of a simplex on trial, with the direction they would give.
template <class Vec>
struct SubsetTrial {
    std::array<const Vec*, 4> point{};
    int size = 0;
    Vec direction;
    ScalarOf<Vec> height{};
};

template <class Vec>
[[nodiscard]] bool find_edge_direction(SubsetTrial<Vec>& t) {
    const Vec& p = *t.point[0];
    const Vec& q = *t.point[1];
    const Vec along = q - p;
    if (sign(dot(q, along)) <= 0 || sign(dot(p, along)) >= 0) return false;
    t.direction = cross(along, cross(p, along));
    t.height = dot(t.direction, p);
    // The two products may leave a rounding residue below zero in double.
    return sign(t.height) >= 0;
}

template <class Vec>
[[nodiscard]] bool find_triangle_direction(SubsetTrial<Vec>& t) {
    const Vec& p = *t.point[0];
    const Vec& q = *t.point[1];
    const Vec& r = *t.point[2];
    const Vec first = q - p;
    const Vec second = r - p;
    const Vec normal = cross(first, second);
    if (sign(dot(normal, cross(q, r))) <= 0) return false;
    if (sign(dot(normal, cross(r, p))) <= 0) return false;
    if (sign(dot(normal, cross(p, q))) <= 0) return false;
    t.height = dot(normal, p);
    const bool away = sign(t.height) < 0;
    t.direction = away ? Vec(-normal) : normal;
    if (away) t.height = -t.height;
    return true;
}

template <class Vec>
[[nodiscard]] bool encloses_origin(const SubsetTrial<Vec>& t) {
    const Vec& p = *t.point[0];
    const Vec& q = *t.point[1];
    const Vec& r = *t.point[2];
    const Vec& s = *t.point[3];
    const Vec p_q = cross(p, q);
    const Vec r_s = cross(r, s);
    const int side = sign(dot(q, r_s));
    return side != 0 && sign(dot(p, r_s)) == -side && sign(dot(p_q, s)) == side && sign(dot(p_q, r)) == -side;
}

/// Returns true if the nearest point of the subset's affine hull lies strictly inside the subset; sets
/// direction and height. Returns false for affinely dependent points.
template <class Vec>
[[nodiscard]] bool find_direction(SubsetTrial<Vec>& t) {
    t.height = 0;
    if (t.size == 4) return encloses_origin(t);
    if (t.size == 3) return find_triangle_direction(t);
    if (t.size == 2) return find_edge_direction(t);
    t.direction = *t.point[0];
    t.height = dot(t.direction, t.direction);
    return true;
}

/// Takes the points of `from` named by the bits of `mask`, then `extra` if there is one.
template <class Vec>
[[nodiscard]] SubsetTrial<Vec> subset_of(const MinimumSimplex<Vec>& from, unsigned mask, const Vec* extra) {
    SubsetTrial<Vec> t;
    for (int i = 0; i < from.size; ++i) {
        if (mask >> i & 1U) t.point[t.size++] = &from.point[i];
    }
    if (extra) t.point[t.size++] = extra;
    return t;
}

/// True if no point of the simplex outside `mask` lies below the subset. Nothing is nearer than the origin
/// itself, and the normal of a triangle around it points to no particular side.
template <class Vec>
[[nodiscard]] bool is_lowest(const MinimumSimplex<Vec>& simplex, unsigned mask, const SubsetTrial<Vec>& t) {
    if (sign(t.height) == 0) return true;
    for (int i = 0; i < simplex.size; ++i) {
        if (!(mask >> i & 1U) && dot(t.direction, simplex.point[i]) < t.height) return false;
    }
    return true;
}

/// Replaces the simplex by the part of simplex + point that carries the nearest point. The point must lie
/// below the simplex (u.point < h), so it is affinely independent of it and belongs to the answer: only the
/// subsets with the point are tried, and exactly one passes. In double, rounding can leave none: false,
/// nothing changed.
template <class Vec>
[[nodiscard]] bool add_point(MinimumSimplex<Vec>& simplex, Vec point, VertexPair pair) {
    static constexpr std::array<unsigned, 8> order = {7, 3, 5, 6, 1, 2, 4, 0};
    for (const unsigned mask : order) {
        if (mask >> simplex.size) continue;
        SubsetTrial<Vec> t = subset_of(simplex, mask, &point);
        if (!find_direction(t) || !is_lowest(simplex, mask, t)) continue;
        int kept = 0;
        for (int i = 0; i < simplex.size; ++i) {
            if (!(mask >> i & 1U)) continue;
            if (kept != i) std::swap(simplex.point[kept], simplex.point[i]);
            simplex.pair[kept++] = simplex.pair[i];
        }
        simplex.point[kept] = std::move(point);
        simplex.pair[kept] = pair;
        simplex.size = kept + 1;
        simplex.direction = std::move(t.direction);
        simplex.height = std::move(t.height);
        return true;
    }
    return false;
}

}  // namespace edgewise::truth
