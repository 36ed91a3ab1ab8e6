// SPDX-License-Identifier: MIT
#include "edgewise/geometry/bandwidth_order.hpp"

#include <algorithm>
#include <tuple>

namespace edgewise {
namespace {

std::size_t degree_of(const Polyhedron& body, Index v) { return body.ring_of_vertex(v).size(); }

bool fewer_neighbours(const Polyhedron& body, Index a, Index b) {
    return std::make_tuple(degree_of(body, a), a) < std::make_tuple(degree_of(body, b), b);
}

/// Vertices in breadth-first order: neighbours of a vertex follow it in the order of their degrees.
struct Levels {
    std::vector<Index> order;
    std::size_t count = 0, last_begins = 0;  ///< levels, and where the last one starts in `order`

    Levels(const Polyhedron& body, Index root) : order{root} {
        std::vector<bool> met(body.vertex_count());
        met[root] = true;
        for (std::size_t begin = 0; begin < order.size(); ++count) {
            last_begins = begin;
            const std::size_t end = order.size();
            for (; begin < end; ++begin) append_neighbours(body, order[begin], met);
        }
    }

  private:
    void append_neighbours(const Polyhedron& body, Index v, std::vector<bool>& met) {
        const auto first = static_cast<std::ptrdiff_t>(order.size());
        for (const HalfEdge h : body.ring_of_vertex(v)) {
            const Index neighbour = body.head(h);
            if (met[neighbour]) continue;
            met[neighbour] = true;
            order.push_back(neighbour);
        }
        std::sort(order.begin() + first, order.end(),
                  [&](Index a, Index b) { return fewer_neighbours(body, a, b); });
    }
};

/// Levels from a vertex that is as far as possible from some other vertex: they are many and narrow.
Levels longest_levels(const Polyhedron& body) {
    Levels best(body, 0);
    for (;;) {
        const auto last = best.order.begin() + static_cast<std::ptrdiff_t>(best.last_begins);
        const Index far = *std::min_element(last, best.order.end(),
                                            [&](Index a, Index b) { return fewer_neighbours(body, a, b); });
        Levels tried(body, far);
        const bool longer = tried.count > best.count;
        best = std::move(tried);
        if (!longer) return best;
    }
}

}  // namespace

std::vector<Index> bandwidth_order(const Polyhedron& body) {
    std::vector<Index> order = longest_levels(body).order;
    std::reverse(order.begin(), order.end());
    return order;
}

Index bandwidth(const Polyhedron& body) {
    Index widest = 0;
    for (const PolyhedronEdge& e : body.edges)
        widest = std::max(widest, std::max(e.tail, e.head) - std::min(e.tail, e.head));
    return widest;
}

}  // namespace edgewise
