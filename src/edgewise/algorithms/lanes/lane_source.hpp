// SPDX-License-Identifier: MIT
//
// The source of the lanes' queries and the sink of their answers: knowledge of tables stays on that side, so
// that the loop over lanes is compiled once, not per table type.
#pragma once

#include <cstddef>
#include <cstdint>

#include "edgewise/geometry/pose.hpp"
#include "edgewise/geometry/vec.hpp"
#include "edgewise/table/small_array.hpp"

namespace edgewise {

/// Bodies with more vertices are not scanned side by side: they fill the first-level cache.
inline constexpr std::size_t most_lane_vertices = 64;

/// One query as a lane receives it; it starts cold.
template <class Scalar>
struct LaneQuery {
    Transform<Scalar> a_from_b;
    /// The tables' addresses, and their numbers of vertices. Vertices of a table that the lane holds already
    /// are not written again.
    const void *table_a = nullptr, *table_b = nullptr;
    int vertices_a = 0, vertices_b = 0;
};

/// A separated pair's answer: the simplex, by vertices' places in their tables, below most_lane_vertices, the
/// weights of its points and the difference's closest point.
template <class Scalar>
struct LaneAnswer {
    int count = 0;
    SmallArray<std::uint32_t, 4> vertex_a, vertex_b;
    SmallArray<Scalar, 4> weight;
    Vec3<Scalar> closest;
    int steps = 0;
};

/// Writes a body's vertices: each coordinate lies next to those of the other lanes.
template <class Scalar>
class LaneVertices {
  public:
    /// Starts at the first vertex's x of this lane, of `lanes` lanes.
    LaneVertices(Scalar* first, std::ptrdiff_t lanes) : at_(first), lanes_(lanes) {}

    void push(const Vec3<Scalar>& point) {
        at_[0] = point.x();
        at_[lanes_] = point.y();
        at_[2 * lanes_] = point.z();
        at_ += 3 * lanes_;
    }

  private:
    Scalar* at_;
    std::ptrdiff_t lanes_;
};

template <class Scalar>
class LaneSource {
  public:
    LaneSource() = default;
    LaneSource(const LaneSource&) = delete;
    LaneSource& operator=(const LaneSource&) = delete;
    virtual ~LaneSource() = default;

    /// The lane's next query; false if none is left.
    [[nodiscard]] virtual bool next(int lane, LaneQuery<Scalar>& query) = 0;
    /// Writes the vertices of the query's body A, in order; write_b those of B.
    virtual void write_a(int lane, LaneVertices<Scalar> vertices) = 0;
    virtual void write_b(int lane, LaneVertices<Scalar> vertices) = 0;
    /// Takes the answer of the lane's query: to the bit the answer of the single query.
    virtual void take(int lane, const LaneAnswer<Scalar>& answer) = 0;
    /// Called when the lane's query needs more than lanes can do: contact, wider arithmetic, another start.
    virtual void ask_singly(int lane) = 0;
};

}  // namespace edgewise
