// SPDX-License-Identifier: MIT
//
// Every read of a table goes through its loader. `Direct` costs nothing; `Traced` reports address, size and
// field to a sink and returns the same value. No algorithm and no layout holds a counter.
#pragma once

#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace edgewise {

enum class Field : std::uint8_t {
    vertex,          ///< coordinates
    voronoi_plane,   ///< vertex-edge and edge-face planes
    edge_direction,  ///< direction and length
    edge_ends,       ///< tail, head, left, right
    face_plane,
    vertex_ring,  ///< edges around a vertex, and where they start
    face_ring,    ///< edges around a face, and where they start
    neighbour,    ///< vertices around a vertex
    edge_made,    ///< bits that say which edges a lazy table has made
    seed,         ///< the start of a cold climb
};

struct Direct {
    template <class Value>
    static const Value& load(const Value& location, Field) {
        return location;
    }
    /// Loads a whole number of 1, 2 or 4 bytes, with at least 3 readable bytes in front of it. It takes the
    /// upper end of the four bytes that end with it, so there is no branch on the width.
    static std::uint32_t load_narrow(const std::byte* location, std::uint32_t width, Field) {
        static_assert(std::endian::native == std::endian::little);
        std::uint32_t last_four = 0;
        std::memcpy(&last_four, location + width - sizeof last_four, sizeof last_four);
        return last_four >> (8 * (sizeof last_four - width));
    }
};

/// Reports each read to a sink: void read(const void* address, std::size_t bytes, Field field).
template <class Sink>
struct Traced {
    Sink* sink = nullptr;

    template <class Value>
    const Value& load(const Value& location, Field field) const {
        assert(sink);
        // Nodes hold pointers, and then a pointer is read. NOLINTNEXTLINE(bugprone-sizeof-expression)
        sink->read(&location, sizeof(Value), field);
        return location;
    }
    std::uint32_t load_narrow(const std::byte* location, std::uint32_t width, Field field) const {
        assert(sink);
        sink->read(location, width, field);
        return Direct::load_narrow(location, width, field);
    }
};

/// True if every read of the table is reported: such a table is never timed.
template <class Table>
inline constexpr bool is_traced = false;
template <template <class, class> class Layout, class Precision, class Sink>
inline constexpr bool is_traced<Layout<Precision, Traced<Sink>>> = true;
template <template <class, class, int> class Layout, class Precision, class Sink, int number>
inline constexpr bool is_traced<Layout<Precision, Traced<Sink>, number>> = true;

}  // namespace edgewise
