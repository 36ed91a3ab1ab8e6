// SPDX-License-Identifier: MIT
//
// Edges and faces of a table that stores neither, by their vertices and places in the rings.
#pragma once

#include <algorithm>

#include "edgewise/geometry/polyhedron.hpp"

namespace edgewise {

/// `at` is the head's place in the ring of the tail, or, seen from the head, the tail's place in its ring; or
/// `nowhere`: then it is searched when it is needed.
struct DerivedEdge {
    static constexpr Index nowhere = 0xffffffff;

    Index tail, head, at;
    bool from_head;

    [[nodiscard]] bool operator==(const DerivedEdge& other) const {
        return tail == other.tail && head == other.head;
    }
};

/// A half-edge: from `vertex` to the neighbour at this place of all rings.
struct HalfEdgeAt {
    Index vertex, at;
    [[nodiscard]] bool operator==(const HalfEdgeAt&) const = default;
};

/// A face, by the first half-edge of its ring.
using DerivedFace = HalfEdgeAt;

/// The smallest half-edge of a face, by edges and then tail first, from any of them: head(h) is the end of a
/// half-edge, next(h) the next half-edge around the face.
template <class Head, class Next>
[[nodiscard]] DerivedFace first_of_face(const HalfEdgeAt& start, Head head, Next next) {
    DerivedFace best = start;
    Index best_low = 0xffffffff, best_high = 0xffffffff;
    HalfEdgeAt h = start;
    do {
        const Index to = head(h);
        const Index low = std::min(h.vertex, to), high = std::max(h.vertex, to);
        if (low < best_low || (low == best_low && high < best_high)) {
            best = h;
            best_low = low;
            best_high = high;
        }
        h = next(h);
    } while (!(h == start));
    return best;
}

/// The first wanted half-edge from here on, at vertices below `vertices`; last(v) is the end of v's ring, and
/// the places of all rings follow each other. If there is none: vertex `vertices`, place 0.
template <class Last, class Wanted>
[[nodiscard]] HalfEdgeAt next_half_edge(HalfEdgeAt h, Index vertices, Last last, Wanted wanted) {
    for (; h.vertex < vertices; ++h.vertex) {
        for (; h.at < last(h.vertex); ++h.at) {
            if (wanted(h)) return h;
        }
    }
    return {vertices, 0};
}

/// A step on the way around a face: back at its first half-edge, the ring is done.
struct DerivedRingPlace {
    HalfEdgeAt at;
    bool under_way;
    [[nodiscard]] bool operator==(const DerivedRingPlace&) const = default;
};

}  // namespace edgewise
