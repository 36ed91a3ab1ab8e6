// SPDX-License-Identifier: MIT
//
// Where the lanes' queries come from and their answers go: what is known of tables stays on that side, so
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

/// One query as a lane is given it, which starts cold.
template <class Scalar>
struct LaneQuery {
    Transform<Scalar> a_from_b;
    /// The tables' addresses, and how many vertices they have. Vertices of a table that the lane holds
    /// already are not written again.
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

/// Where a body's vertices go: each coordinate lies beside those of the other lanes.
template <class Scalar>
class LaneVertices {
  public:
    /// At the first vertex's x of this lane, of so many.
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
    /// The vertices of its body A, in order; of B.
    virtual void write_a(int lane, LaneVertices<Scalar> vertices) = 0;
    virtual void write_b(int lane, LaneVertices<Scalar> vertices) = 0;
    /// Of the lane's query, to the bit what it is asked by itself.
    virtual void take(int lane, const LaneAnswer<Scalar>& answer) = 0;
    /// The lane's query needs more than lanes can do: contact, wider arithmetic, another start.
    virtual void ask_singly(int lane) = 0;
};

}  // namespace edgewise
