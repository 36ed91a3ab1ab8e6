// SPDX-License-Identifier: MIT
//
// Reads a body without trusting its arrays: offsets and ranges first, so that no index leads out of an array;
// then edges and rings. The second stage runs only if the first found nothing, so that a broken array does
// not bury its cause under consequences.
#include <algorithm>

#include "edgewise/geometry/check_polyhedron.hpp"
#include "edgewise/geometry/message.hpp"

namespace edgewise {
namespace {

class TopologyCheck {
  public:
    explicit TopologyCheck(const Polyhedron& body) : body_(body) {}

    [[nodiscard]] std::vector<std::string> run() {
        check_arrays();
        if (!found_.empty()) return found_;
        check_euler();
        check_edges();
        check_face_rings();
        check_vertex_rings();
        if (found_.empty()) check_order();
        return found_;
    }

  private:
    template <class... Parts>
    void complain(const Parts&... parts) {
        found_.push_back(message(parts...));
    }

    void check_offsets(std::string_view name, const std::vector<Index>& offset, std::size_t rows,
                       std::size_t entries) {
        if (offset.size() != rows + 1) {
            complain(name, "_offset has ", offset.size(), " entries, expected ", rows + 1);
        } else if (offset.front() != 0 || offset.back() != entries ||
                   !std::is_sorted(offset.begin(), offset.end())) {
            complain(name, "_offset must rise from 0 to ", entries);
        }
    }

    void check_half_edges(std::string_view name, const std::vector<HalfEdge>& ring) {
        const std::size_t half_edges = 2 * body_.edge_count();
        std::vector<int> seen(half_edges, 0);
        for (const HalfEdge h : ring) {
            if (h >= half_edges) return complain(name, "_ring holds half-edge ", h, " of only ", half_edges);
            ++seen[h];
        }
        for (std::size_t h = 0; h < half_edges; ++h) {
            if (seen[h] != 1) complain("half-edge ", h, " is ", seen[h], " times in ", name, "_ring");
        }
    }

    void check_arrays() {
        if (body_.input_index.size() != body_.vertex_count()) {
            complain("input_index has ", body_.input_index.size(), " entries, expected ",
                     body_.vertex_count());
        }
        check_offsets("face", body_.face_offset, body_.face_count(), body_.face_ring.size());
        check_offsets("vertex", body_.vertex_offset, body_.vertex_count(), body_.vertex_ring.size());
        check_half_edges("face", body_.face_ring);
        check_half_edges("vertex", body_.vertex_ring);
        for (std::size_t e = 0; e < body_.edge_count(); ++e) {
            const PolyhedronEdge& edge = body_.edges[e];
            if (std::max(edge.tail, edge.head) >= body_.vertex_count() ||
                std::max(edge.left, edge.right) >= body_.face_count())
                complain("edge ", e, " names a vertex or a face that does not exist");
        }
    }

    void check_euler() {
        const auto count = [](std::size_t n) { return static_cast<long long>(n); };
        const long long euler =
            count(body_.vertex_count()) - count(body_.edge_count()) + count(body_.face_count());
        if (euler == 2) return;
        complain("Euler: ", body_.vertex_count(), " vertices - ", body_.edge_count(), " edges + ",
                 body_.face_count(), " faces = ", euler, ", expected 2");
    }

    void check_edges() {
        const auto key = [](const PolyhedronEdge& e) { return std::pair(e.tail, e.head); };
        for (std::size_t e = 0; e < body_.edge_count(); ++e) {
            const PolyhedronEdge& edge = body_.edges[e];
            if (edge.tail >= edge.head) complain("edge ", e, ": tail must be below head");
            if (edge.left == edge.right) complain("edge ", e, " has face ", edge.left, " on both sides");
            if (e > 0 && !(key(body_.edges[e - 1]) < key(edge)))
                complain("edges ", e - 1, " and ", e, " are not in the order of tail and head");
        }
    }

    /// Checks that the ring is long enough, and each half-edge with the next one by `check_pair`.
    template <class CheckPair>
    void check_ring(std::string_view kind, Index i, std::span<const HalfEdge> ring, std::size_t least,
                    CheckPair check_pair) {
        if (ring.size() < least)
            return complain(kind, ' ', i, " has ", ring.size(), " edges, expected at least ", least);
        for (std::size_t k = 0; k < ring.size(); ++k) check_pair(ring[k], ring[(k + 1) % ring.size()]);
    }

    void check_face_rings() {
        for (Index f = 0; f < body_.face_count(); ++f) {
            check_ring("face", f, body_.ring_of_face(f), 3, [&](HalfEdge h, HalfEdge next) {
                if (body_.face(h) != f)
                    complain("face ", f, ": half-edge ", h, " in its ring belongs to face ", body_.face(h));
                if (body_.head(h) != body_.tail(next))
                    complain("face ", f, ": its ring breaks between half-edges ", h, " and ", next);
            });
        }
    }

    void check_vertex_rings() {
        const std::size_t least = body_.face_count() == 2 ? 2 : 3;  // a polygon has no third face
        for (Index v = 0; v < body_.vertex_count(); ++v) {
            check_ring("vertex", v, body_.ring_of_vertex(v), least, [&](HalfEdge h, HalfEdge next) {
                if (body_.tail(h) != v)
                    complain("vertex ", v, ": half-edge ", h, " in its ring leaves vertex ", body_.tail(h));
                if (body_.face(h) != body_.face(next ^ 1))
                    complain("vertex ", v, ": its ring does not turn counter-clockwise from half-edge ", h,
                             " to ", next);
            });
        }
    }

    /// Checks the canonical order: rings from their smallest half-edge, faces by their first one.
    void check_order() {
        const auto check_start = [&](std::string_view kind, Index i, std::span<const HalfEdge> ring) {
            if (std::min_element(ring.begin(), ring.end()) != ring.begin())
                complain(kind, ' ', i, ": its ring does not start at its smallest half-edge");
        };
        for (Index f = 0; f < body_.face_count(); ++f) check_start("face", f, body_.ring_of_face(f));
        for (Index v = 0; v < body_.vertex_count(); ++v) check_start("vertex", v, body_.ring_of_vertex(v));
        for (Index f = 1; f < body_.face_count(); ++f) {
            if (body_.ring_of_face(f - 1)[0] >= body_.ring_of_face(f)[0])
                complain("faces ", f - 1, " and ", f, " are not in the order of their first half-edges");
        }
    }

    const Polyhedron& body_;
    std::vector<std::string> found_;
};

}  // namespace

std::vector<std::string> check_topology(const Polyhedron& body) { return TopologyCheck(body).run(); }

}  // namespace edgewise
