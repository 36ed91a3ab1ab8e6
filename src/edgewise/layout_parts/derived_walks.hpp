// SPDX-License-Identifier: MIT
//
// Edges and faces of a table that stores neither, as ranges: around a face, and all faces of a body. Table
// gives next(half-edge), face_of(half-edge) and item<Item>(half-edge).
#pragma once

#include <algorithm>

#include "edgewise/geometry/polyhedron.hpp"

namespace edgewise {

/// `at` is the head's place in the ring of the tail, or, seen from the head, the tail's place in its ring.
struct DerivedEdge {
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

/// The first half-edge of its ring.
using DerivedFace = HalfEdgeAt;

/// The smallest half-edge of a face, by edges and then tail first, from any of them on: head(h) is where a
/// half-edge ends, next(h) the next around the face.
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

/// Half-edges of a face in order, from its first; as such, or as edges.
template <class Table, class Item>
class DerivedFaceRing {
  public:
    class Iterator {
      public:
        Iterator(const Table* table, const HalfEdgeAt& at, bool done) : table_(table), at_(at), done_(done) {}
        Item operator*() const { return table_->template item<Item>(at_); }
        Iterator& operator++() {
            at_ = table_->next(at_);
            done_ = true;
            return *this;
        }
        /// Beside the end: back at the first half-edge, once under way.
        bool operator!=(const Iterator& end) const { return !(done_ && at_ == end.at_); }

      private:
        const Table* table_;
        HalfEdgeAt at_;
        bool done_;
    };

    DerivedFaceRing(const Table* table, const DerivedFace& f) : table_(table), face_(f) {}
    [[nodiscard]] Iterator begin() const { return {table_, face_, false}; }
    [[nodiscard]] Iterator end() const { return {table_, face_, true}; }

  private:
    const Table* table_;
    DerivedFace face_;
};

/// Every half-edge that is the first of its face.
template <class Table>
class DerivedFaces {
  public:
    class Iterator {
      public:
        Iterator(const Table* table, Index vertex) : table_(table), at_{vertex, 0} { skip_to_first(); }
        DerivedFace operator*() const { return at_; }
        Iterator& operator++() {
            ++at_.at;
            skip_to_first();
            return *this;
        }
        bool operator!=(const Iterator& end) const { return at_.vertex != end.at_.vertex; }

      private:
        /// On to the next first half-edge, this one included; the places of all rings follow each other.
        void skip_to_first() {
            const Index end = static_cast<Index>(table_->vertex_count());
            if (table_->facts().face_count == 0) at_.vertex = end;
            for (; at_.vertex < end; ++at_.vertex) {
                for (; at_.at < table_->ring_end(at_.vertex); ++at_.at) {
                    if (table_->face_of(at_) == at_) return;
                }
            }
        }

        const Table* table_;
        HalfEdgeAt at_;
    };

    explicit DerivedFaces(const Table* table) : table_(table) {}
    [[nodiscard]] Iterator begin() const { return {table_, 0}; }
    [[nodiscard]] Iterator end() const { return {table_, static_cast<Index>(table_->vertex_count())}; }

  private:
    const Table* table_;
};

}  // namespace edgewise
