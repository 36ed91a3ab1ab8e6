// SPDX-License-Identifier: MIT
//
// The contract between layouts and algorithms: neither may know more of the other.
//
// A SupportTable gives its vertices; GJK needs no more, so an engine may pass a shape of its own. With
// neighbours as well (ClimbingTable), queries climb to support points. A FeatureTable adds edges, faces,
// rings and the Voronoi planes of V-Clip; a MeasuredTable the figures that are reported. Handles are the
// layout's own: compared, copied, handed back, never computed with. A plane may be stored or derived: the
// algorithm sees no difference. It asks only for signs and ratios of distances where possible.
//
// Orientation of planes: a vertex-edge plane is positive beyond the edge's end, on the side of that end's
// vertex; an edge-face plane is positive on the side of that face. So a point is in the Voronoi region of a
// vertex or of a face when every plane of its ring is >= 0, and in the region of an edge when its four planes
// are <= 0. Both neighbours ask the same plane and read the same number, so V-Clip cannot walk back and forth
// between them.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <string_view>
#include <vector>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/table/needs.hpp"
#include "edgewise/table/pieces.hpp"
#include "edgewise/table/ring.hpp"

namespace edgewise {

/// A precision is a pair of scalars: one stores, one computes. The layout passes it to the algorithms as a
/// template parameter: one program measures every precision.
struct f64 {
    using Stored = double;
    using Compute = double;
    static constexpr std::string_view name = "f64";
};

struct f32 {
    using Stored = float;
    using Compute = float;
    static constexpr std::string_view name = "f32";
};

struct mixed {
    using Stored = float;
    using Compute = double;
    static constexpr std::string_view name = "mixed";
};

template <class P>
concept Precision = requires {
    typename P::Stored;
    typename P::Compute;
    { P::name } -> std::convertible_to<std::string_view>;
};

enum class End : bool { tail, head };
enum class Side : bool { left, right };

template <class T>
using ComputeOf = typename T::PrecisionType::Compute;

/// A shape that GJK accepts: a precision, a handle type, and three functions.
template <class T>
concept SupportTable = Precision<typename T::PrecisionType> && std::regular<typename T::Vertex> &&
    requires(const T& table, typename T::Vertex v) {
    /// where a cold query starts
    { table.first_vertex() } -> std::same_as<typename T::Vertex>;
    { table.vertex(v) } -> std::convertible_to<Vec3<ComputeOf<T>>>;
    /// how a scan visits all vertices
    { *table.all_vertices().begin() } -> std::convertible_to<typename T::Vertex>;
};

/// A shape on which queries may climb along edges to support points. If its handles are 0 .. vertex_count() -
/// 1 it declares `static constexpr bool counts_vertices = true`: scans then go over it in chunks. If it may
/// be climbed without being strictly convex it has `bool climbable() const` (is_climbable), and `reach()`,
/// its largest coordinate.
template <class T>
concept ClimbingTable = SupportTable<T> && requires(const T& table, typename T::Vertex v) {
    { table.vertex_count() } -> std::convertible_to<std::size_t>;
    /// geometry/strictly_convex.hpp: false costs scans and proofs, but answers stay right
    { table.strictly_convex() } -> std::same_as<bool>;
    { *table.neighbours(v).begin() } -> std::convertible_to<typename T::Vertex>;
};

/// A climbing table that keeps the coordinates of a ring side by side: a climb then measures eight neighbours
/// at once, with the answer of measuring one by one. Blocks come in the order of neighbours(v), and within a
/// block lanes do; lanes that a ring does not fill repeat its last vertex.
template <class T>
concept RingBlockTable = ClimbingTable<T> &&
    requires(const T& table, typename T::Vertex v, Vec3<ComputeOf<T>> direction, std::size_t lane) {
    /// <point, direction> of each vertex
    { (*table.ring_blocks(v).begin()).heights(direction) } -> std::same_as<std::array<ComputeOf<T>, 8>>;
    { (*table.ring_blocks(v).begin()).vertex(lane) } -> std::same_as<typename T::Vertex>;
    { (*table.ring_blocks(v).begin()).point(lane) } -> std::same_as<Vec3<ComputeOf<T>>>;
};

template <class T>
concept FeatureTable = ClimbingTable<T> &&
    requires(const T& table, typename T::Vertex v, typename T::Edge e, typename T::Face f) {
    { table.tail(e) } -> std::same_as<typename T::Vertex>;
    { table.head(e) } -> std::same_as<typename T::Vertex>;
    /// a segment's edge has it on either side; its edge_face_planes are negative everywhere
    { T::no_face } -> std::convertible_to<typename T::Face>;
    { table.left(e) } -> std::same_as<typename T::Face>;
    { table.right(e) } -> std::same_as<typename T::Face>;
    /// tail to head; unit length where stored
    { table.direction(e) } -> std::convertible_to<Vec3<ComputeOf<T>>>;
    { *table.ring_of_vertex(v).begin() } -> std::convertible_to<RingEdge<typename T::Edge>>;
    { *table.ring_of_face(f).begin() } -> std::convertible_to<RingEdge<typename T::Edge>>;
    /// the body's largest coordinate: the rounding of its planes is relative to it
    { table.reach() } -> std::convertible_to<double>;
    { *table.all_faces().begin() } -> std::convertible_to<typename T::Face>;
    table.vertex_edge_plane(e, End::tail).distance(table.vertex(v));
    table.edge_face_plane(e, Side::left).distance(table.vertex(v));
    table.face_plane(f).distance(table.vertex(v));
};

/// True if queries write to a table. Several threads may query a const table at once, as with any const
/// object, unless it makes parts of itself when they are first read. A table that does so declares `static
/// constexpr bool queries_write = true`: it serves one thread at a time, and so do all views of its
/// memory.
template <class Table>
inline constexpr bool queries_write = requires {
    requires Table::queries_write;
};

/// True if a table stores planes, edges and faces even for support points alone, as the modelled engine does:
/// `static constexpr bool keeps_faces = true`.
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
    /// all of its memory, and the purpose of each byte
    { table.pieces() } -> std::convertible_to<std::vector<Piece>>;
};

}  // namespace edgewise
