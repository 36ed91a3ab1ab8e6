// SPDX-License-Identifier: MIT
//
// Decides how far a run's answer is trusted: how rounding may have changed it, and what answers instead.
//
// The line between the closest points is a difference of two points, each rounded: its direction is off by
// the rounding over its length. Where an edge of each body lies almost along the other's, or a face along an
// edge, whole valleys of feature pairs have almost the same distance, and V-Clip may stop anywhere. A vertex
// over a face, and edges that cross at a fair angle, are safe: a plane or a cross product says
// which way is out, whatever the distance.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "edgewise/algorithms/answerable.hpp"
#include "edgewise/algorithms/distance.hpp"
#include "edgewise/algorithms/support.hpp"
#include "edgewise/algorithms/vclip/body.hpp"
#include "edgewise/geometry/tolerance.hpp"

namespace edgewise::vclip {

/// Decision about the answer of a run that ended without a cycle.
enum class Trust : std::uint8_t {
    sound,    ///< it is kept
    doubted,  ///< not proven: its corners are to prove it, or the fallback answers
    close,    ///< right up to rounding, which may exceed it: it is computed again, as a refinement
};

/// Times the size: below this distance the direction between closest points cannot be trusted.
template <class TableA, class TableB>
inline constexpr double untrusted =
    rounded_planes<TableA> || rounded_planes<TableB> ? close_of_rounded_planes
                                                     : double{Tolerance<ComputeOf<TableA>>::close};

/// Times the size: below this distance even the signs of V-Clip's tests are in doubt, on any features: by
/// rounding, or because the two bodies' frames, by R and by its transpose, differ by R's distance from
/// orthogonal.
template <class Table>
[[nodiscard]] double hardly_apart(const Body<Table>& body) {
    const double error{std::sqrt(squared_rotation_error(body.from_other.rotation))};
    return std::max(double{Tolerance<ComputeOf<Table>>::hardly_apart}, sloppy_steps * error);
}

/// Outward direction, from A to B, where the pair's own geometry has it in full precision: a face's normal,
/// which the answer has by now, or that of two edges that cross at a fair angle. Nothing where the pair may
/// slide.
template <class TableA, class TableB>
[[nodiscard]] std::optional<Vec3d> known_normal(const Distance& result, const Body<TableA>& a,
                                                const Body<TableB>& b) {
    using enum FeatureKind;
    if (rounded_planes<TableA> || rounded_planes<TableB>) return std::nullopt;
    if (a.feature.kind() == face || b.feature.kind() == face) return result.normal;
    if (a.feature.kind() == vertex || b.feature.kind() == vertex) return std::nullopt;
    using Scalar = ComputeOf<TableA>;
    const auto p = a.table.direction(a.feature.edge());
    const auto q = a.from_other.direction(b.table.direction(b.feature.edge()));
    const Scalar fair = Tolerance<Scalar>::fair_crossing * squared_norm(p) * squared_norm(q);
    const Vec3<Scalar> common = cross(p, q);
    if (!(squared_norm(common) >= fair)) return std::nullopt;
    const Vec3d normal = cast<double>(Vec3<Scalar>(common / norm(common)));
    return dot(normal, result.normal) < 0 ? Vec3d(-normal) : normal;
}

/// Decides about an answer below `untrusted`. Features that meet to within rounding are in contact: each
/// point is one of its body. (Edges that cross in the middle of deeply overlapping boxes look like closest
/// features at distance 1e-16.) This fails for rounded planes: a foot on one may be as far off as the plane.
template <class TableA, class TableB>
[[nodiscard]] [[gnu::noinline]] Trust trust_close(Distance& result, double size, const Body<TableA>& a,
                                                  const Body<TableB>& b) {
    constexpr bool rounded = rounded_planes<TableA> || rounded_planes<TableB>;
    if (!rounded && result.distance <= double{Tolerance<ComputeOf<TableA>>::meeting} * size) {
        result.status = Status::touching;
        result.distance = 0;
        result.normal = Vec3d::Zero();
        return Trust::sound;
    }
    const std::optional<Vec3d> normal = known_normal(result, a, b);
    if (!normal || result.distance <= hardly_apart(a) * size) return Trust::close;
    result.normal = *normal;
    return Trust::sound;
}

/// Largest coordinate of both bodies and their offset, to which rounding is relative.
template <class TableA, class TableB>
[[nodiscard]] double pair_size(const Body<TableA>& a, const Body<TableB>& b) {
    const double offset{max_abs(a.from_other.translation)};
    return std::max({offset, a.table.reach(), b.table.reach()});
}

/// Returns true if the body provably ends at its feature along a direction, which is off by the rounding of
/// `size`: at a face, since it is convex; at an edge or a vertex whose neighbours are clearly lower.
template <class Table>
[[nodiscard]] bool body_ends_here(const Body<Table>& body, const Vec3<ComputeOf<Table>>& direction,
                                  double size) {
    using Scalar = ComputeOf<Table>;
    const Table& table = body.table;
    if (table.strictly_convex()) return true;
    if (!may_climb(table)) return false;
    if (body.feature.kind() == FeatureKind::face) return !rounded_planes<Table>;
    const Scalar band = Tolerance<Scalar>::level * static_cast<Scalar>(table.reach() * size);
    const auto is_top = [&](auto v, auto besides) {
        for (const auto other : table.neighbours(v)) {
            const Vec3<Scalar> down = table.vertex(v) - table.vertex(other);
            if (other != besides && !(dot(down, direction) > band)) return false;
        }
        return true;
    };
    if (body.feature.kind() == FeatureKind::vertex)
        return is_top(body.feature.vertex(), body.feature.vertex());
    const auto tail = table.tail(body.feature.edge()), head = table.head(body.feature.edge());
    return is_top(tail, head) && is_top(head, tail);
}

/// Proves that both features hold the closest points where a body is not strictly convex. Time of queries
/// over that with a proof by support points (fallback.hpp), aos_f64 / aos_f32, 0.01 rad per step: mesh of 137
/// vertices 0.58 / 0.61, of 364 0.61 / 0.53; sphere of 1538 (strictly convex in double) 1.0 / 0.59.
template <class TableA, class TableB>
[[nodiscard]] [[gnu::noinline]] bool both_end_here(const Distance& result, double size, const Body<TableA>& a,
                                                   const Body<TableB>& b) {
    const std::optional<Vec3d> normal = known_normal(result, a, b);
    if (normal) size = 1;
    const auto towards_b = cast<ComputeOf<TableA>>(normal ? *normal : Vec3d(result.point_b - result.point_a));
    return body_ends_here(a, towards_b, size) && body_ends_here(b, b.from_other.direction(-towards_b), size);
}

/// Decides about any answer. On a body that is not strictly convex a feature's region continues under the
/// surface, and nothing is trusted without proof: `proven`, by the corners next to the features, or later.
template <class TableA, class TableB>
[[nodiscard]] Trust trust(Distance& result, const Body<TableA>& a, const Body<TableB>& b, bool proven) {
    if (result.status == Status::overlapping) return Trust::sound;
    const bool is_proven = proven || (a.table.strictly_convex() && b.table.strictly_convex());
    if (result.status == Status::touching) {
        if (!is_proven) return Trust::doubted;
        return rounded_planes<TableA> || rounded_planes<TableB> ? Trust::close : Trust::sound;
    }
    const double size = pair_size(a, b);
    const bool is_far = result.distance > untrusted<TableA, TableB> * size;
    if (!is_proven && !both_end_here(result, size, a, b)) return is_far ? Trust::doubted : Trust::close;
    return is_far ? Trust::sound : trust_close(result, size, a, b);
}

}  // namespace edgewise::vclip
