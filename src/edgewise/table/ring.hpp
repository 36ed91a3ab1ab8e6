// SPDX-License-Identifier: MIT
//
// Rings as ranges: the neighbours of a vertex or a face, in order, read one entry at a time by a reader.
#pragma once

#include <cassert>
#include <cstdint>
#include <iterator>

namespace edgewise {

/// An edge as an entry of a ring. Around a vertex, `flipped` says that the vertex is the edge's head; around
/// a face, that the face is on the edge's right.
template <class Edge>
struct RingEdge {
    Edge edge;
    bool flipped;
};

/// Entries first..last of an array, each turned into a value by the reader when it is asked for.
template <class Reader>
class IndexedRing {
  public:
    class Iterator {
      public:
        Iterator(const Reader& reader, std::uint32_t at) : reader_(&reader), at_(at) {}
        auto operator*() const { return (*reader_)(at_); }
        Iterator& operator++() {
            ++at_;
            return *this;
        }
        bool operator!=(const Iterator& other) const { return at_ != other.at_; }

      private:
        const Reader* reader_;
        std::uint32_t at_;
    };

    IndexedRing(std::uint32_t first, std::uint32_t last, Reader reader)
        : first_(first), last_(last), reader_(reader) {
        assert(first <= last);
    }

    [[nodiscard]] Iterator begin() const { return {reader_, first_}; }
    [[nodiscard]] Iterator end() const { return {reader_, last_}; }
    [[nodiscard]] std::uint32_t size() const { return last_ - first_; }

  private:
    std::uint32_t first_, last_;
    Reader reader_;
};

template <class Reader>
IndexedRing(std::uint32_t, std::uint32_t, Reader) -> IndexedRing<Reader>;

/// A range and its own iterator: goes from one place to the next until the end. `item` returns the value at a
/// place, `next` the place after it.
template <class Place, class Item, class Next>
class Chain {
  public:
    Chain(Place at, Place end, Item item, Next next) : at_(at), end_(end), item_(item), next_(next) {}
    [[nodiscard]] Chain begin() const { return *this; }
    [[nodiscard]] std::default_sentinel_t end() const { return {}; }
    auto operator*() const {
        assert(!(at_ == end_));
        return item_(at_);
    }
    Chain& operator++() {
        assert(!(at_ == end_));
        at_ = next_(at_);
        return *this;
    }
    bool operator!=(std::default_sentinel_t) const { return !(at_ == end_); }

  private:
    Place at_, end_;
    Item item_;
    Next next_;
};

/// Range 0 .. count-1, for layouts with plain positions as handles.
[[nodiscard]] inline auto index_range(std::uint32_t count) {
    return IndexedRing(0, count, [](std::uint32_t at) { return at; });
}

}  // namespace edgewise
