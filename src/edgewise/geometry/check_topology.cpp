// SPDX-License-Identifier: MIT
//
// Reads a body as a stranger would: offsets and ranges first, so that nothing is followed that leads out of
// an array; then edges and rings. The second stage runs only if the first found nothing, so that a broken
// array does not bury its cause under consequences.
#include "edgewise/geometry/check_topology.hpp"

#include <algorithm>

#include "edgewise/geometry/message.hpp"

namespace edgewise {
namespace {

using Violations = std::vector<std::string>;

void check_offsets(std::string_view name, const std::vector<Index>& offset, std::size_t rows,
                   std::size_t entries, Violations& found) {
    if (offset.size() != rows + 1) {
        found.push_back(message(name, "_offset has ", offset.size(), " entries, expected ", rows + 1));
    } else if (offset.front() != 0 || offset.back() != entries ||
               !std::is_sorted(offset.begin(), offset.end())) {
        found.push_back(message(name, "_offset must rise from 0 to ", entries));
    }
}

void check_half_edges(std::string_view name, const std::vector<HalfEdge>& ring, std::size_t half_edges,
                      Violations& found) {
    std::vector<int> seen(half_edges, 0);
    for (const HalfEdge h : ring) {
        if (h >= half_edges) {
            found.push_back(message(name, "_ring holds half-edge ", h, " of only ", half_edges));
            return;
        }
        ++seen[h];
    }
    for (std::size_t h = 0; h < half_edges; ++h) {
        if (seen[h] != 1)
            found.push_back(message("half-edge ", h, " is ", seen[h], " times in ", name, "_ring"));
    }
}

void check_arrays(const Polyhedron& body, Violations& found) {
    if (body.input_index.size() != body.vertex_count()) {
        found.push_back(
            message("input_index has ", body.input_index.size(), " entries, expected ", body.vertex_count()));
    }
    check_offsets("face", body.face_offset, body.face_count(), body.face_ring.size(), found);
    check_offsets("vertex", body.vertex_offset, body.vertex_count(), body.vertex_ring.size(), found);
    check_half_edges("face", body.face_ring, 2 * body.edge_count(), found);
    check_half_edges("vertex", body.vertex_ring, 2 * body.edge_count(), found);
    for (std::size_t e = 0; e < body.edge_count(); ++e) {
        const PolyhedronEdge& edge = body.edges[e];
        if (std::max(edge.tail, edge.head) >= body.vertex_count() ||
            std::max(edge.left, edge.right) >= body.face_count()) {
            found.push_back(message("edge ", e, " names a vertex or a face that does not exist"));
        }
    }
}

void check_euler(const Polyhedron& body, Violations& found) {
    const auto count = [](std::size_t n) { return static_cast<long long>(n); };
    const long long euler = count(body.vertex_count()) - count(body.edge_count()) + count(body.face_count());
    if (euler != 2) {
        found.push_back(message("Euler: ", body.vertex_count(), " vertices - ", body.edge_count(),
                                " edges + ", body.face_count(), " faces = ", euler, ", expected 2"));
    }
}

void check_edges(const Polyhedron& body, Violations& found) {
    const auto key = [](const PolyhedronEdge& e) { return std::pair(e.tail, e.head); };
    for (std::size_t e = 0; e < body.edge_count(); ++e) {
        const PolyhedronEdge& edge = body.edges[e];
        if (edge.tail >= edge.head) found.push_back(message("edge ", e, ": tail must be below head"));
        if (edge.left == edge.right)
            found.push_back(message("edge ", e, " has face ", edge.left, " on both sides"));
        if (e > 0 && !(key(body.edges[e - 1]) < key(edge))) {
            found.push_back(message("edges ", e - 1, " and ", e, " are not in the order of tail and head"));
        }
    }
}

void check_face_rings(const Polyhedron& body, Violations& found) {
    for (Index f = 0; f < body.face_count(); ++f) {
        const std::span<const HalfEdge> ring = body.ring_of_face(f);
        if (ring.size() < 3) {
            found.push_back(message("face ", f, " has ", ring.size(), " edges, expected at least 3"));
            continue;
        }
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const HalfEdge next = ring[(k + 1) % ring.size()];
            if (body.face(ring[k]) != f) {
                found.push_back(message("face ", f, ": half-edge ", ring[k], " in its ring belongs to face ",
                                        body.face(ring[k])));
            }
            if (body.head(ring[k]) != body.tail(next)) {
                found.push_back(
                    message("face ", f, ": its ring breaks between half-edges ", ring[k], " and ", next));
            }
        }
    }
}

/// The canonical order: rings from their smallest half-edge, faces by their first one.
void check_order(const Polyhedron& body, Violations& found) {
    const auto starts_low = [](std::span<const HalfEdge> ring) {
        return std::min_element(ring.begin(), ring.end()) == ring.begin();
    };
    const auto complain = [&](std::string_view kind, Index i) {
        found.push_back(message(kind, ' ', i, ": its ring does not start at its smallest half-edge"));
    };
    for (Index f = 0; f < body.face_count(); ++f) {
        if (!starts_low(body.ring_of_face(f))) complain("face", f);
    }
    for (Index v = 0; v < body.vertex_count(); ++v) {
        if (!starts_low(body.ring_of_vertex(v))) complain("vertex", v);
    }
    for (Index f = 1; f < body.face_count(); ++f) {
        if (body.ring_of_face(f - 1)[0] < body.ring_of_face(f)[0]) continue;
        found.push_back(
            message("faces ", f - 1, " and ", f, " are not in the order of their first half-edges"));
    }
}

void check_vertex_rings(const Polyhedron& body, Violations& found) {
    for (Index v = 0; v < body.vertex_count(); ++v) {
        const std::span<const HalfEdge> ring = body.ring_of_vertex(v);
        const std::size_t least = body.face_count() == 2 ? 2 : 3;  // a polygon has no third face
        if (ring.size() < least) {
            found.push_back(message("vertex ", v, " has ", ring.size(), " edges, expected at least ", least));
            continue;
        }
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const HalfEdge next = ring[(k + 1) % ring.size()];
            if (body.tail(ring[k]) != v) {
                found.push_back(message("vertex ", v, ": half-edge ", ring[k], " in its ring leaves vertex ",
                                        body.tail(ring[k])));
            }
            if (body.face(ring[k]) != body.face(next ^ 1)) {
                found.push_back(message("vertex ", v,
                                        ": its ring does not turn counter-clockwise from half-edge ", ring[k],
                                        " to ", next));
            }
        }
    }
}

}  // namespace

Violations check_topology(const Polyhedron& body) {
    Violations found;
    check_arrays(body, found);
    if (!found.empty()) return found;
    check_euler(body, found);
    check_edges(body, found);
    check_face_rings(body, found);
    check_vertex_rings(body, found);
    if (found.empty()) check_order(body, found);
    return found;
}

}  // namespace edgewise
