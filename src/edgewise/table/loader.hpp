// SPDX-License-Identifier: MIT
//
// Every read of a table goes through its loader. `Direct` costs nothing; `Traced` reports address, size and
// field to a sink and returns the same value. No algorithm and no layout holds a counter.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>

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
    edge_made,    ///< whether a lazy table has made an edge
    seed,         ///< where a cold climb begins
};

struct Direct {
    template <class Value>
    static const Value& load(const Value& location, Field) {
        return location;
    }
};

/// Sink: void read(const void* address, std::size_t bytes, Field field).
template <class Sink>
struct Traced {
    Sink* sink = nullptr;

    template <class Value>
    const Value& load(const Value& location, Field field) const {
        assert(sink);
        // Where nodes hold pointers, a pointer is what is read. NOLINTNEXTLINE(bugprone-sizeof-expression)
        sink->read(&location, sizeof(Value), field);
        return location;
    }
};

/// Whether every read of the table is reported: such a table is never timed.
template <class Table>
inline constexpr bool is_traced = false;
template <template <class, class> class Layout, class Precision, class Sink>
inline constexpr bool is_traced<Layout<Precision, Traced<Sink>>> = true;

}  // namespace edgewise
