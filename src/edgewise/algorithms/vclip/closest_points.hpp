// SPDX-License-Identifier: MIT
//
// Closest points of two features, once a run has ended (and of two segments, on the way).
//
// Edge-edge parameters come from cross products: their error is eps over the angle between the edges, where
// the textbook 1 - k^2 has eps over its square and is useless below 1e-8 rad.
#pragma once

#include <algorithm>
#include <cassert>
#include <utility>

#include "edgewise/algorithms/vclip/body.hpp"
#include "edgewise/algorithms/vclip/clip.hpp"
#include "edgewise/geometry/tolerance.hpp"

namespace edgewise::vclip {

/// A pair of points: on the first feature and on the second.
template <class Scalar>
using PointPair = std::pair<Vec3<Scalar>, Vec3<Scalar>>;

template <class Scalar>
[[nodiscard]] Vec3<Scalar> closest_on_segment(const Segment<Scalar>& segment, const Vec3<Scalar>& point) {
    const Vec3<Scalar> along = segment.head - segment.tail;
    return segment.at(std::clamp(projection(segment.tail, along, point), Scalar(0), Scalar(1)));
}

/// The lines through two segments, and where they come closest to each other.
template <class Scalar>
class CrossingLines {
  public:
    CrossingLines(const Segment<Scalar>& a, const Segment<Scalar>& b)
        : a_(a), b_(b), common_(cross(along_a(), along_b())), squared_(squared_norm(common_)) {
        const Scalar inverse = 1 / squared_;
        lambda_ = dot(cross(between_tails(), along_b()), common_) * inverse;
        mu_ = dot(cross(between_tails(), along_a()), common_) * inverse;
    }

    /// Direction perpendicular to both lines; zero where they are parallel, with no crossing then.
    [[nodiscard]] const Vec3<Scalar>& common() const { return common_; }
    [[nodiscard]] bool are_parallel() const { return !(squared_ > 0); }
    [[nodiscard]] Vec3<Scalar> between_tails() const { return b_.tail - a_.tail; }
    [[nodiscard]] Scalar lambda() const { return lambda_; }

    /// Returns true if they cross at an angle that keeps parameters accurate, with both feet on the segments.
    [[nodiscard]] bool cross_fairly_within() const {
        const bool inside = lambda_ >= 0 && lambda_ <= 1 && mu_ >= 0 && mu_ <= 1;
        const Scalar fair =
            Tolerance<Scalar>::fair_crossing * squared_norm(along_a()) * squared_norm(along_b());
        return inside && squared_ >= fair;
    }
    [[nodiscard]] PointPair<Scalar> feet() const { return {a_.at(lambda_), b_.at(mu_)}; }

  private:
    [[nodiscard]] Vec3<Scalar> along_a() const { return a_.head - a_.tail; }
    [[nodiscard]] Vec3<Scalar> along_b() const { return b_.head - b_.tail; }

    Segment<Scalar> a_, b_;
    Vec3<Scalar> common_;
    Scalar squared_, lambda_, mu_;
};

/// Closest points of two segments. Edges that cross at a fair angle, with both feet inside, need one
/// division; near-parallel or clamped ones are projected back and forth, which keeps the distance right where
/// a parameter is only accurate to eps over the angle.
template <class Scalar>
[[nodiscard]] PointPair<Scalar> closest_on_segments(const Segment<Scalar>& a, const Segment<Scalar>& b) {
    const CrossingLines<Scalar> lines(a, b);
    if (lines.are_parallel()) {  // any start will do
        const Vec3<Scalar> on_b = closest_on_segment(b, a.tail);
        return {closest_on_segment(a, on_b), on_b};
    }
    if (lines.cross_fairly_within()) return lines.feet();
    const Vec3<Scalar> on_b = closest_on_segment(b, a.at(std::clamp(lines.lambda(), Scalar(0), Scalar(1))));
    return {closest_on_segment(a, on_b), on_b};
}

template <class Scalar>
struct FaceFoot {
    Vec3<Scalar> point;
    Vec3<Scalar> normal = Vec3<Scalar>::Zero();  ///< the face's, unit; zero where the stored one is rounder
};

/// Foot of a point on a plane of unit normal.
template <class Plane, class Scalar>
[[nodiscard]] FaceFoot<Scalar> foot_on_plane(const Plane& plane, const Vec3<Scalar>& point) {
    return {point - plane.distance(point) * plane.normal, plane.normal};
}

/// Foot of a point on a face's plane. Where planes are stored with less precision than the arithmetic, the
/// plane is derived again from the face's vertices (Newell's normal), so that the answer is as accurate as
/// they are.
template <class Table>
[[nodiscard]] FaceFoot<ComputeOf<Table>> foot_on_face(const Table& table, typename Table::Face face,
                                                      const Vec3<ComputeOf<Table>>& point) {
    using Scalar = ComputeOf<Table>;
    if constexpr (!rounded_planes<Table>) {
        return foot_on_plane(table.face_plane(face), point);
    } else {
        const auto ring = table.ring_of_face(face);
        const auto first = *ring.begin();
        const Vec3<Scalar> base =
            table.vertex(first.flipped ? table.head(first.edge) : table.tail(first.edge));
        Vec3<Scalar> normal = Vec3<Scalar>::Zero();
        for (const auto [edge, flipped] : ring) {
            const auto side = segment_of(table, edge);
            const Vec3<Scalar> area = cross(Vec3<Scalar>(side.tail - base), Vec3<Scalar>(side.head - base));
            normal += flipped ? Vec3<Scalar>(-area) : area;
        }
        return {point - (dot(Vec3<Scalar>(point - base), normal) / squared_norm(normal)) * normal};
    }
}

/// Closest points of two bodies, in the frame of A.
template <class Scalar>
struct ClosestPoints {
    Vec3<Scalar> on_a, on_b;
    Vec3<Scalar> normal = Vec3<Scalar>::Zero();  ///< from A to B where a face has it, else zero
};

/// Closest points of two features that may_be_closest.
template <class TableA, class TableB>
[[nodiscard]] ClosestPoints<ComputeOf<TableA>> closest_points(const Body<TableA>& a, const Body<TableB>& b) {
    using Scalar = ComputeOf<TableA>;
    if (b.feature.kind() == FeatureKind::vertex) {
        const Vec3<Scalar> point = a.from_other.point(b.table.vertex(b.feature.vertex()));
        switch (a.feature.kind()) {
            case FeatureKind::vertex:
                return {a.table.vertex(a.feature.vertex()), point};
            case FeatureKind::edge:
                return {closest_on_segment(segment_of(a.table, a.feature.edge()), point), point};
            case FeatureKind::face:
                const auto foot = foot_on_face(a.table, a.feature.face(), point);
                return {foot.point, point, foot.normal};
        }
    }
    if (a.feature.kind() == FeatureKind::edge) {
        const auto [on_a, on_b] = closest_on_segments(segment_of(a.table, a.feature.edge()),
                                                      segment_seen_by(a, b.table, b.feature.edge()));
        return {on_a, on_b};
    }
    assert(may_be_closest(a.feature.kind(), b.feature.kind()));
    const Vec3<Scalar> vertex = a.table.vertex(a.feature.vertex());
    if (b.feature.kind() == FeatureKind::edge) {
        return {vertex, closest_on_segment(segment_seen_by(a, b.table, b.feature.edge()), vertex)};
    }
    const auto foot = foot_on_face(b.table, b.feature.face(), b.from_other.point(vertex));
    return {vertex, a.from_other.point(foot.point), a.from_other.direction(-foot.normal)};
}

}  // namespace edgewise::vclip
