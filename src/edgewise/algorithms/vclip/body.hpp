// SPDX-License-Identifier: MIT
//
// One of the two bodies as a V-Clip state sees it, and the possible results of a state.
#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "edgewise/geometry/pose.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/table/feature_handle.hpp"
#include "edgewise/table/ring_questions.hpp"

namespace edgewise::vclip {

enum class Step : std::uint8_t {
    moved,        ///< to a neighbouring feature
    escaped,      ///< from a local minimum under a face, to any face
    separated,    ///< both features hold the closest points
    touching,     ///< they meet to within rounding: in doubt
    overlapping,  ///< an edge pierces a face, or a vertex lies inside
};

template <FeatureTable Table>
struct Body {
    const Table& table;
    const Transform<ComputeOf<Table>>& from_other;  ///< maps the other body's points into this body's frame
    Feature<Table> feature;

    using Scalar = ComputeOf<Table>;

    void move_to_vertex(typename Table::Vertex v) { feature = Feature<Table>::of_vertex(v); }
    void move_to_edge(typename Table::Edge e) { feature = Feature<Table>::of_edge(e); }
    void move_to_face(typename Table::Face f) { feature = Feature<Table>::of_face(f); }
};

/// Returns a different number for each pair of kinds.
constexpr int pair_of(FeatureKind a, FeatureKind b) { return 3 * static_cast<int>(a) + static_cast<int>(b); }

/// False for a face with an edge or a face: the closest points of bodies never need both.
constexpr bool may_be_closest(FeatureKind a, FeatureKind b) {
    using enum FeatureKind;
    return (a != face || b == vertex) && (b != face || a == vertex);
}

/// A table that computes planes from corners when asked for.
template <class Table>
concept DerivesPlanes = requires {
    Table::derives_planes;
};

/// Precision of a table's planes: that of storage, or, where they are derived, that of the arithmetic.
template <class Table>
using PlaneScalar =
    std::conditional_t<DerivesPlanes<Table>, ComputeOf<Table>, typename Table::PrecisionType::Stored>;

/// Relative to the coordinates: heights over a plane, or distances, up to this may have a sign that rounding
/// changed. Planes are only as accurate as their storage.
template <class Table>
inline constexpr ComputeOf<Table> plane_noise =
    static_cast<ComputeOf<Table>>(Tolerance<PlaneScalar<Table>>::contact_noise);

/// Largest distance of a face of this body from its plane: by rounding; or, for a body with corners so small
/// that the hull may have merged them, by what counts as flat.
template <class Table>
[[nodiscard]] ComputeOf<Table> face_noise(const Table& table) {
    using Scalar = ComputeOf<Table>;
    const Scalar merged = static_cast<Scalar>(face_planarity);
    const Scalar relative =
        table.strictly_convex() ? plane_noise<Table> : std::max(plane_noise<Table>, merged);
    return relative * static_cast<Scalar>(table.reach());
}

/// True if planes are stored rounder than the arithmetic: a point on one side may lie on the other.
template <class Table>
inline constexpr bool rounded_planes = !std::is_same_v<PlaneScalar<Table>, ComputeOf<Table>>;

/// A straight piece from tail to head.
template <class Scalar>
struct Segment {
    Vec3<Scalar> tail, head;

    [[nodiscard]] Vec3<Scalar> at(Scalar lambda) const { return tail + lambda * (head - tail); }
};

template <class Table>
[[nodiscard]] Segment<ComputeOf<Table>> segment_of(const Table& table, typename Table::Edge e) {
    return {table.vertex(table.tail(e)), table.vertex(table.head(e))};
}

/// The edge in the frame of the viewing body.
template <class Viewer, class Table>
[[nodiscard]] Segment<ComputeOf<Table>> segment_seen_by(const Viewer& viewer, const Table& table,
                                                        typename Table::Edge e) {
    const auto own = segment_of(table, e);
    return {viewer.from_other.point(own.tail), viewer.from_other.point(own.head)};
}

/// Squared slope (ring_questions.hpp) of the body's edge, tail to head, over a plane of the other body with
/// this normal. V-F, E-F and E-E must agree on "towards the plane" to the last bit, or the pair cycles
/// between them: so all of them ask the table for the edge's slope along the normal turned into its frame.
template <class Table>
[[nodiscard]] ComputeOf<Table> slope_over(const Body<Table>& body, const Vec3<ComputeOf<Table>>& normal) {
    return slope_along(body.table, body.feature.edge(), body.from_other.direction(normal));
}

/// Signed height over the plane at a place of the segment.
template <class Plane, class Scalar>
[[nodiscard]] Scalar height_at(const Plane& plane, const Segment<Scalar>& segment, Scalar lambda) {
    const Scalar tail = plane.distance(segment.tail);
    return tail + lambda * (plane.distance(segment.head) - tail);
}

}  // namespace edgewise::vclip
