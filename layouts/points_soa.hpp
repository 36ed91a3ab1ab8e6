// SPDX-License-Identifier: MIT
//
// Points alone: the coordinates of the vertices in three arrays, x, y and z, and nothing else. Without
// neighbours nobody can climb, so a support point is always found by a scan over all vertices, which three
// plain arrays let the compiler do several vertices at a time. For GJK only. The least a table can hold: 24
// bytes per vertex in double, 12 in single; no topology.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <limits>
#include <string_view>
#include <vector>

#include "edgewise/layout_parts/block_table.hpp"

namespace edgewise {

/// One array each of x, y and z.
template <class Stored>
struct PointArrays {
    std::array<Stored*, 3> axis{};

    void place(BlockPlan& plan, const BodyFacts& n) {
        for (Stored*& array : axis)
            plan.array(array, n.vertex_count, {{Component::vertex_coordinates, sizeof(Stored)}});
    }
};

template <Precision P, class Loader = Direct>
class points_soa : public BlockTable<P, Loader> {
    using Base = BlockTable<P, Loader>;
    using Base::load;

    using Coordinates = PointArrays<typename Base::Stored>;

  public:
    using typename Base::Compute;
    using typename Base::Stored;
    using typename Base::Vertex;

    static constexpr std::string_view name = "points_soa";
    static constexpr std::string_view stores = "vertex coordinates in three arrays, no neighbours";
    static constexpr std::string_view derives = "support points, by scans";

    /// Both kinds of parts are the same here: there is nothing to leave out.
    points_soa(const Polyhedron& body, Parts parts, Loader loader = {}) : Base(body, parts, loader) {
        this->make_block(coordinates_);
        write_geometry(*this, body);
    }

    template <class OtherLoader>
    points_soa(const points_soa<P, OtherLoader>& other, Loader loader)
        : Base(other, loader), coordinates_(other.coordinates_) {}

    [[nodiscard]] std::vector<Piece> pieces() const { return this->pieces_of(Coordinates()); }
    [[nodiscard]] Ledger ledger() const { return ledger_of(pieces()); }

    void write_vertex(Index v, const Vec3d& point) {
        for (int k = 0; k < 3; ++k) coordinates_.axis[k][v] = static_cast<Stored>(point[k]);
    }

    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const {
        assert(v < this->vertex_count());
        return {coordinate(0, v), coordinate(1, v), coordinate(2, v)};
    }

    struct Farthest {
        Vertex vertex;
        Vec3<Compute> point;
        Compute along;  ///< <point, direction>
    };

    /// The vertex farthest along the direction, the first of equals; every bit as a scan one by one finds it.
    [[nodiscard]] Farthest scan_support(const Vec3<Compute>& direction) const {
        Vertex best = this->first_vertex();
        Compute along = dot(vertex(best), direction);
        std::array<Compute, chunk> heights;
        for (std::size_t first = 0; first < this->vertex_count(); first += chunk) {
            const std::size_t count = std::min(chunk, this->vertex_count() - first);
            measure(first, count, direction, heights);
            const Compute top = highest(heights);
            if (!(top > along)) continue;
            const std::size_t at = std::find(heights.begin(), heights.end(), top) - heights.begin();
            best = static_cast<Vertex>(first + at);
            along = heights[at];  // not `top`: of two equal zeros it may have the other sign
        }
        return {best, vertex(best), along};
    }

  private:
    template <Precision, class>
    friend class points_soa;

    static constexpr std::size_t chunk = 64;

    Compute coordinate(int k, std::size_t v) const {
        return static_cast<Compute>(load(coordinates_.axis[k][v], Field::vertex));
    }

    /// Heights of `count` vertices; what is left of the chunk can never win. Positions have 64 bits here: a
    /// sum of 32-bit ones may wrap round, and g++ then gathers scalars one by one.
    void measure(std::size_t first, std::size_t count, const Vec3<Compute>& direction,
                 std::array<Compute, chunk>& heights) const {
        const Compute x = direction.x(), y = direction.y(), z = direction.z();
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t v = first + i;
            heights[i] = coordinate(0, v) * x + coordinate(1, v) * y + coordinate(2, v) * z;
        }
        std::fill(heights.begin() + count, heights.end(), -std::numeric_limits<Compute>::infinity());
    }

    /// Half against half: one running maximum would be a chain of comparisons that no compiler may reorder.
    template <std::size_t Size>
    static Compute highest(const std::array<Compute, Size>& heights) {
        if constexpr (Size == 1) {
            return heights[0];
        } else {
            std::array<Compute, Size / 2> higher;
            for (std::size_t i = 0; i < Size / 2; ++i) {
                const Compute a = heights[i], b = heights[i + Size / 2];
                higher[i] = b > a ? b : a;
            }
            return highest(higher);
        }
    }

    Coordinates coordinates_;
};

}  // namespace edgewise
