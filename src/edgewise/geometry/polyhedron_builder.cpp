// SPDX-License-Identifier: MIT
//
// Pairs the sides of the rings into edges by sorting, then numbers everything in the canonical order.
#include "edgewise/geometry/polyhedron_builder.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "edgewise/geometry/double_double.hpp"
#include "edgewise/geometry/hull/point_set.hpp"
#include "edgewise/geometry/message.hpp"

namespace edgewise {
namespace {

/// One side of one ring, as an undirected edge with its direction.
struct Side {
    Index low, high;  ///< vertices
    bool backwards;   ///< runs high -> low
    Index face;
    Index position;  ///< in the face's ring

    [[nodiscard]] bool same_edge(const Side& other) const { return low == other.low && high == other.high; }
    [[nodiscard]] auto key() const { return std::tuple(low, high, backwards, face); }
};

std::string ring_error(const FaceRings& input) {
    if (input.rings.empty()) return "there are no faces";
    for (std::size_t f = 0; f < input.rings.size(); ++f) {
        std::vector<Index> ring = input.rings[f];
        if (ring.size() < 3)
            return message("face ", f, " has ", ring.size(), " corners; a face needs at least 3");
        std::sort(ring.begin(), ring.end());
        const auto twice = std::adjacent_find(ring.begin(), ring.end());
        if (twice != ring.end()) {
            return message("face ", f, " passes vertex ", input.input_index[*twice], " twice");
        }
    }
    return {};
}

std::vector<Side> sorted_sides(const FaceRings& input) {
    std::vector<Side> sides;
    for (Index f = 0; f < input.rings.size(); ++f) {
        const std::vector<Index>& ring = input.rings[f];
        for (Index k = 0; k < ring.size(); ++k) {
            const Index from = ring[k];
            const Index to = ring[k + 1 == ring.size() ? 0 : k + 1];
            sides.push_back({std::min(from, to), std::max(from, to), from > to, f, k});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.key() < b.key(); });
    return sides;
}

/// Returns an empty text when sides 2e and 2e + 1 are the two directions of edge e, for all e.
std::string pairing_error(const FaceRings& input, const std::vector<Side>& sides) {
    for (std::size_t i = 0; i < sides.size();) {
        const Side& side = sides[i];
        std::size_t count = 1;
        while (i + count < sides.size() && side.same_edge(sides[i + count])) ++count;
        const std::string edge =
            message("edge ", input.input_index[side.low], "-", input.input_index[side.high]);
        if (count == 1)
            return message("not closed: ", edge, " has a face on one side only (face ", side.face, ")");
        if (count > 2) return message(edge, " lies in ", count, " faces; an edge joins exactly 2");
        const Side& other = sides[i + 1];
        if (side.backwards == other.backwards) {
            return message("faces ", side.face, " and ", other.face, " run ", edge,
                           " in the same direction; reverse one of them");
        }
        i += count;
    }
    return {};
}

/// Returns the rings as half-edges, each starting at its smallest, sorted by their first half-edges.
std::vector<std::vector<HalfEdge>> canonical_rings(const FaceRings& input, const std::vector<Side>& sides) {
    std::vector<std::vector<HalfEdge>> rings(input.rings.size());
    for (std::size_t f = 0; f < rings.size(); ++f) rings[f].resize(input.rings[f].size());
    for (HalfEdge h = 0; h < sides.size(); ++h) rings[sides[h].face][sides[h].position] = h;
    for (std::vector<HalfEdge>& ring : rings) {
        std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    }
    std::sort(rings.begin(), rings.end());
    return rings;
}

Vec3d area_vector(std::span<const Vec3d> vertices, std::span<const Index> ring, double scale) {
    DoubleDoubleVec sum = DoubleDoubleVec::Zero();
    const Vec3d& origin = vertices[ring[0]];
    DoubleDoubleVec previous = exact_difference(vertices[ring[1]], origin, scale);
    for (std::size_t k = 2; k < ring.size(); ++k) {
        const DoubleDoubleVec next = exact_difference(vertices[ring[k]], origin, scale);
        sum += cross(previous, next);
        previous = next;
    }
    return cast<double>(sum);
}

/// Minus the middle of <normal, v> over the ring, computed in two-fold precision: far from the origin the
/// middle of rounded products would be off by more than the offset's own rounding.
double middle_offset(std::span<const Vec3d> vertices, std::span<const Index> ring, const Vec3d& normal) {
    DoubleDouble low = accurate_dot(normal, vertices[ring[0]]);
    DoubleDouble high = low;
    for (const Index v : ring.subspan(1)) {
        const DoubleDouble height = accurate_dot(normal, vertices[v]);
        if ((height - low).value() < 0) low = height;
        if ((height - high).value() > 0) high = height;
    }
    return -((low + high).value() / 2);
}

/// The plane of a polygon. The normal is Newell's area vector (the sum over all corners, so no corner is
/// favoured and a sliver has a plane wherever its area is not zero), summed in two-fold precision; unit, on
/// the side from which the ring runs counter-clockwise; zero when the ring encloses no area. The offset lies
/// halfway between the lowest and the highest vertex along the normal: the best plane with that normal.
/// `scale`: a power of two that takes the body to about unit size.
Plane<double> face_plane(std::span<const Vec3d> vertices, std::span<const Index> ring, double scale) {
    const Vec3d area = area_vector(vertices, ring, scale);
    const double largest = max_abs(area);
    if (!(largest > 0)) return {Vec3d::Zero(), 0};
    const Vec3d safe = area / largest;  // slivers: the square of the area may vanish
    const Vec3d normal = safe / norm(safe);
    return {normal, middle_offset(vertices, ring, normal)};
}

void fill_edges_and_faces(Polyhedron& body, const std::vector<Side>& sides,
                          const std::vector<std::vector<HalfEdge>>& rings) {
    for (std::size_t e = 0; 2 * e < sides.size(); ++e) {
        body.edges.push_back({sides[2 * e].low, sides[2 * e].high, 0, 0});
    }
    const double scale = unit_scale(body.vertices);
    body.face_offset.push_back(0);
    for (Index f = 0; f < rings.size(); ++f) {
        std::vector<Index> corners;
        for (const HalfEdge h : rings[f]) {
            PolyhedronEdge& edge = body.edges[h >> 1];
            (h & 1 ? edge.right : edge.left) = f;
            corners.push_back(body.tail(h));
        }
        body.face_ring.insert(body.face_ring.end(), rings[f].begin(), rings[f].end());
        body.face_offset.push_back(static_cast<Index>(body.face_ring.size()));
        body.face_planes.push_back(face_plane(body.vertices, corners, scale));
    }
}

/// Returns for each half-edge its predecessor in its face's ring.
std::vector<HalfEdge> predecessors(const Polyhedron& body) {
    std::vector<HalfEdge> before(body.face_ring.size());
    for (Index f = 0; f < body.face_count(); ++f) {
        HalfEdge last = body.ring_of_face(f).back();
        for (const HalfEdge h : body.ring_of_face(f)) {
            before[h] = last;
            last = h;
        }
    }
    return before;
}

std::string too_few_faces(Index name, Index degree) {
    return message("vertex ", name, " has only ", degree,
                   " faces around it, a corner needs 3; leave out vertices ", "in the middle of an edge");
}

/// Fills rings counter-clockwise around a vertex: from a leaving half-edge, across its left face, to the twin
/// of the half-edge that comes in there. Returns an empty text, or what is wrong with the fan.
std::string fill_vertex_rings(Polyhedron& body) {
    const std::vector<HalfEdge> before = predecessors(body);
    const auto none = static_cast<HalfEdge>(before.size());
    std::vector<HalfEdge> smallest(body.vertex_count(), none);
    std::vector<Index> degree(body.vertex_count(), 0);
    for (HalfEdge h = 0; h < none; ++h) {
        smallest[body.tail(h)] = std::min(smallest[body.tail(h)], h);
        ++degree[body.tail(h)];
    }
    body.vertex_offset.push_back(0);
    for (Index v = 0; v < body.vertex_count(); ++v) {
        const Index name = body.input_index[v];
        if (degree[v] < (body.face_count() > 2 ? 3U : 2U)) return too_few_faces(name, degree[v]);
        HalfEdge h = smallest[v];
        do {
            body.vertex_ring.push_back(h);
            h = before[h] ^ 1;
        } while (h != smallest[v]);
        body.vertex_offset.push_back(static_cast<Index>(body.vertex_ring.size()));
        if (body.ring_of_vertex(v).size() != degree[v])
            return message("vertex ", name, " joins two separate fans");
    }
    return {};
}

/// Returns true if the vertex farthest from the plane of face f is above it. (The sign of the volume would
/// give the same answer, except in needles because of rounding.)
bool looks_inward(const Polyhedron& body, Index f) {
    const Vec3d& normal = body.face_planes[f].normal;
    const Vec3d& origin = body.vertices[body.tail(body.ring_of_face(f)[0])];
    double farthest = 0;
    for (const Vec3d& v : body.vertices) {
        const double height = dot(normal, Vec3d(v - origin));
        if (std::abs(height) > std::abs(farthest)) farthest = height;
    }
    return farthest > 0;
}

}  // namespace

FaceRings in_input_order(std::span<const Vec3d> points, std::span<const Index> distinct,
                         std::span<const std::vector<Index>> rings) {
    FaceRings result;
    for (const std::vector<Index>& ring : rings) {
        for (const Index v : ring) result.input_index.push_back(distinct[v]);
    }
    std::vector<Index>& names = result.input_index;
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    for (const Index name : names) result.vertices.push_back(points[name]);
    for (const std::vector<Index>& ring : rings) {
        std::vector<Index>& renumbered = result.rings.emplace_back();
        for (const Index v : ring) {
            const auto at = std::lower_bound(names.begin(), names.end(), distinct[v]);
            renumbered.push_back(static_cast<Index>(at - names.begin()));
        }
    }
    return result;
}

Result<Polyhedron> build_polyhedron(const FaceRings& input) {
    std::string error = ring_error(input);
    if (!error.empty()) return Result<Polyhedron>::failure(std::move(error));
    const std::vector<Side> sides = sorted_sides(input);
    if (sides.size() / 2 > most_edges)
        return Result<Polyhedron>::failure(
            message("a body of ", sides.size() / 2, " edges; ", most_edges, " are the most, simplify it"));
    error = pairing_error(input, sides);
    if (!error.empty()) return Result<Polyhedron>::failure(std::move(error));
    Polyhedron body;
    body.vertices = input.vertices;
    body.input_index = input.input_index;
    fill_edges_and_faces(body, sides, canonical_rings(input, sides));
    error = fill_vertex_rings(body);
    if (!error.empty()) return Result<Polyhedron>::failure(std::move(error));
    return Result<Polyhedron>::success(std::move(body));
}

Result<Polyhedron> build_outward(FaceRings input) {
    Result<Polyhedron> body = build_polyhedron(input);
    if (!body || !looks_inward(*body, 0)) return body;
    for (std::vector<Index>& ring : input.rings) std::reverse(ring.begin(), ring.end());
    return build_polyhedron(input);
}

}  // namespace edgewise
