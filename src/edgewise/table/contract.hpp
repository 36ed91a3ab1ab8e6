// SPDX-License-Identifier: MIT
//
// The contract between layouts and algorithms: all that one may know of the other.
//
// A SupportTable gives its vertices; GJK asks for no more, so an engine may pass a shape of its own. With
// neighbours as well (ClimbingTable) support points are climbed to. A FeatureTable adds edges, faces, rings
// and the Voronoi planes that V-Clip tests; a MeasuredTable what is reported of a layout. Handles are the
// layout's own: compared, copied, handed back, never computed with. A plane may be stored or derived; the
// algorithm cannot tell, and asks only for signs and ratios of distances wherever that is enough.
//
// Orientation of planes: a vertex-edge plane is positive beyond the edge's end, on the side of that end's
// vertex; an edge-face plane is positive on the side of that face. So a point is in the Voronoi region of a
// vertex or of a face when every plane of its ring is >= 0, and in the region of an edge when its four planes
// are <= 0. Both neighbours ask the same plane and read the same number, which is what keeps V-Clip from
// arguing with itself.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <string_view>
#include <vector>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/table/ledger.hpp"
#include "edgewise/table/needs.hpp"
#include "edgewise/table/pieces.hpp"
#include "edgewise/table/precision.hpp"
#include "edgewise/table/ring.hpp"

namespace edgewise {

enum class End : bool { tail, head };
enum class Side : bool { left, right };

template <class T>
using ComputeOf = typename T::PrecisionType::Compute;

/// A shape that GJK answers for: a precision, a handle type, and three functions.
template <class T>
concept SupportTable = Precision<typename T::PrecisionType> && std::regular<typename T::Vertex> &&
    requires(const T& table, typename T::Vertex v) {
    /// where a cold query starts
    { table.first_vertex() } -> std::same_as<typename T::Vertex>;
    { table.vertex(v) } -> std::convertible_to<Vec3<ComputeOf<T>>>;
    /// how a scan visits all vertices
    { *table.all_vertices().begin() } -> std::convertible_to<typename T::Vertex>;
};

/// A shape on which support points may be climbed to along its edges. One whose handles are 0 ..
/// vertex_count() - 1 says `static constexpr bool counts_vertices = true`: scans then go over it in chunks.
/// One that may be climbed without being strictly convex says `bool climbable() const` (is_climbable), and by
/// `reach()` its largest coordinate.
template <class T>
concept ClimbingTable = SupportTable<T> && requires(const T& table, typename T::Vertex v) {
    { table.vertex_count() } -> std::convertible_to<std::size_t>;
    /// geometry/strictly_convex.hpp: false costs scans and proofs, and is never wrong
    { table.strictly_convex() } -> std::same_as<bool>;
    { *table.neighbours(v).begin() } -> std::convertible_to<typename T::Vertex>;
};

/// A climbing table that keeps the coordinates of a ring side by side: a climb then measures eight neighbours
/// at once, and answers as it does one by one. Blocks come in the order of neighbours(v), and within a block
/// lanes do; what a ring does not fill repeats its last vertex.
template <class T>
concept RingBlockTable = ClimbingTable<T> &&
    requires(const T& table, typename T::Vertex v, Vec3<ComputeOf<T>> direction, std::size_t lane) {
    /// <point, direction> of each
    { (*table.ring_blocks(v).begin()).heights(direction) } -> std::same_as<std::array<ComputeOf<T>, 8>>;
    { (*table.ring_blocks(v).begin()).vertex(lane) } -> std::same_as<typename T::Vertex>;
    { (*table.ring_blocks(v).begin()).point(lane) } -> std::same_as<Vec3<ComputeOf<T>>>;
};

template <class T>
concept FeatureTable = ClimbingTable<T> &&
    requires(const T& table, typename T::Vertex v, typename T::Edge e, typename T::Face f) {
    { table.tail(e) } -> std::same_as<typename T::Vertex>;
    { table.head(e) } -> std::same_as<typename T::Vertex>;
    /// what a segment's edge has on either side; its edge_face_planes are negative everywhere
    { T::no_face } -> std::convertible_to<typename T::Face>;
    { table.left(e) } -> std::same_as<typename T::Face>;
    { table.right(e) } -> std::same_as<typename T::Face>;
    /// tail to head; unit length where stored
    { table.direction(e) } -> std::convertible_to<Vec3<ComputeOf<T>>>;
    { *table.ring_of_vertex(v).begin() } -> std::convertible_to<RingEdge<typename T::Edge>>;
    { *table.ring_of_face(f).begin() } -> std::convertible_to<RingEdge<typename T::Edge>>;
    /// the body's largest coordinate: what the rounding of its planes is relative to
    { table.reach() } -> std::convertible_to<double>;
    { *table.all_faces().begin() } -> std::convertible_to<typename T::Face>;
    table.vertex_edge_plane(e, End::tail).distance(table.vertex(v));
    table.edge_face_plane(e, Side::left).distance(table.vertex(v));
    table.face_plane(f).distance(table.vertex(v));
};

/// Whether queries write to a table. A const table is safe to ask from several threads at once, as const
/// things are; unless it makes parts of itself when they are first asked for, and says so by
/// `static constexpr bool queries_write = true`: such a table serves one thread at a time, and so do all
/// views of its memory.
template <class Table>
inline constexpr bool queries_write = requires {
    requires Table::queries_write;
};

/// Whether a table stores planes, edges and faces even for support points alone, as the engine does whose
/// layout it is: `static constexpr bool keeps_faces = true`.
template <class Table>
inline constexpr bool keeps_faces = requires {
    requires Table::keeps_faces;
};

/// A layout that the registry lists, the sweep measures and the report describes.
template <class T>
concept MeasuredTable = SupportTable<T> && requires(const T& table, typename T::Vertex v) {
    { T::name } -> std::convertible_to<std::string_view>;
    { table.vertex_count() } -> std::convertible_to<std::size_t>;
    /// position of the vertex in the canonical Polyhedron
    { table.index_of(v) } -> std::convertible_to<Index>;
    { table.ledger() } -> std::convertible_to<Ledger>;
    /// all of its memory, and what each byte of it is for
    { table.pieces() } -> std::convertible_to<std::vector<Piece>>;
};

}  // namespace edgewise
