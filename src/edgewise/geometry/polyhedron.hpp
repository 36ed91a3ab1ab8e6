// SPDX-License-Identifier: MIT
//
// The canonical body, in double: the one source of every layout.
//
// Half-edge form without pointers. Edge e has two half-edges: 2e runs tail -> head with the left face on its
// left, 2e+1 runs head -> tail with the right face on its left ("left" as seen from outside, so every face
// ring runs counter-clockwise). Rings are stored back to back with offsets (compressed rows).
//
// Canonical order, so that the same body is the same bits wherever it was built: vertices in input order,
// edges by (tail, head) with tail < head, each ring starting at its smallest half-edge, faces by their first
// half-edge.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "edgewise/geometry/vec.hpp"

namespace edgewise {

using Index = std::uint32_t;
using HalfEdge = std::uint32_t;

/// Face number on both sides of the edge of a segment.
inline constexpr Index no_face = 0xffffffff;

/// Bodies with more edges are refused: a pair keeps two features in 8 bytes (table/feature_handle.hpp).
inline constexpr std::size_t most_edges = (std::size_t{1} << 21) - 1;

struct PolyhedronEdge {
    Index tail, head;   ///< vertices
    Index left, right;  ///< faces, or no_face
};

/// A convex body: a solid; or a flat body, which is a polygon with a front and a back face, a segment of one
/// edge without faces, or a point.
struct Polyhedron {
    std::vector<Vec3d> vertices;
    std::vector<Index> input_index;  ///< vertex -> index in the vertex list the user gave
    std::vector<PolyhedronEdge> edges;
    std::vector<Plane<double>> face_planes;  ///< outward, unit normal
    std::vector<Index> face_offset;          ///< faces + 1 entries into face_ring
    std::vector<HalfEdge> face_ring;         ///< half-edges of a face, counter-clockwise from outside
    std::vector<Index> vertex_offset;        ///< vertices + 1 entries into vertex_ring
    std::vector<HalfEdge> vertex_ring;       ///< half-edges leaving a vertex, counter-clockwise from outside

    [[nodiscard]] std::size_t vertex_count() const { return vertices.size(); }
    [[nodiscard]] std::size_t edge_count() const { return edges.size(); }
    [[nodiscard]] std::size_t face_count() const { return face_planes.size(); }

    [[nodiscard]] Index tail(HalfEdge h) const { return h & 1 ? edge_of(h).head : edge_of(h).tail; }
    [[nodiscard]] Index head(HalfEdge h) const { return h & 1 ? edge_of(h).tail : edge_of(h).head; }
    [[nodiscard]] Index face(HalfEdge h) const { return h & 1 ? edge_of(h).right : edge_of(h).left; }
    [[nodiscard]] const PolyhedronEdge& edge_of(HalfEdge h) const {
        assert(h >> 1 < edges.size());
        return edges[h >> 1];
    }

    [[nodiscard]] std::span<const HalfEdge> ring_of_face(Index f) const {
        assert(f + 1 < face_offset.size());
        return std::span(face_ring).subspan(face_offset[f], face_offset[f + 1] - face_offset[f]);
    }
    [[nodiscard]] std::span<const HalfEdge> ring_of_vertex(Index v) const {
        assert(v + 1 < vertex_offset.size());
        return std::span(vertex_ring).subspan(vertex_offset[v], vertex_offset[v + 1] - vertex_offset[v]);
    }
};

/// Length of the diagonal of the axis-aligned box around the points.
[[nodiscard]] double extent(std::span<const Vec3d> points);

/// Enclosed volume; positive for outward faces.
[[nodiscard]] double volume(const Polyhedron& body);

}  // namespace edgewise
