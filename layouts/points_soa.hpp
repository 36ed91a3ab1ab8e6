// SPDX-License-Identifier: MIT
//
// Points alone: the coordinates of the vertices in three arrays, x, y and z, and nothing else. Without
// neighbours nobody can climb, so a support point is always found by a scan over all vertices, which three
// plain arrays let the compiler do several vertices at a time. For GJK only. The least a table can hold: 24
// bytes per vertex in double, 12 in single; no topology.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include "edgewise/layout_parts/block_table.hpp"

namespace edgewise {

/// One array each of x, y and z: where they start, in bytes from the block's start.
template <class Stored>
struct PointArrays {
    std::array<std::uint32_t, 3> at{};

    void place(BlockPlan& plan, const BodyFacts& n) {
        for (std::uint32_t& start : at)
            start = plan.array_at<Stored>(n.vertex_count, {{Component::vertex_coordinates, sizeof(Stored)}});
    }
    [[nodiscard]] Stored* axis(int k, std::byte* base) const {
        return reinterpret_cast<Stored*>(base + at[k]);
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
        for (int k = 0; k < 3; ++k) axis(k)[v] = static_cast<Stored>(point[k]);
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
        const Vertex start = this->first_vertex();
        Highest best{start, dot(vertex(start), direction)};
        std::size_t first = 0, rest = this->vertex_count();
        for (; rest >= 64; first += 64, rest -= 64) scan_chunk<64>(first, 64, direction, best);
        // The smallest chunk that the rest fits in: a box is eight numbers, not sixty-four, and with the
        // count known when compiled nothing is filled up.
        if (rest == 8) {
            scan_chunk<8>(first, 8, direction, best);
        } else if (rest > 0 && rest < 8) {
            scan_chunk<8>(first, rest, direction, best);
        } else if (rest > 8 && rest <= 16) {
            scan_chunk<16>(first, rest, direction, best);
        } else if (rest > 16) {
            scan_chunk<64>(first, rest, direction, best);
        }
        return {best.vertex, vertex(best.vertex), best.along};
    }

  private:
    template <Precision, class>
    friend class points_soa;

    struct Highest {
        Vertex vertex;
        Compute along;
    };

    /// The highest of up to `Size` vertices, if it is above the best.
    template <std::size_t Size>
    [[gnu::always_inline]] void scan_chunk(std::size_t first, std::size_t count,
                                           const Vec3<Compute>& direction, Highest& best) const {
        std::array<Compute, Size> heights;
        measure(first, count, direction, heights);
        const Compute top = highest(heights);
        if (!(top > best.along)) return;
        const std::size_t at = first_of(top, heights);
        // Not `top`: of two equal zeros it may have the other sign.
        best = {static_cast<Vertex>(first + at), heights[at]};
    }

    /// Where the first of these is. Of few, without a loop whose end no processor can predict.
    template <std::size_t Size>
    [[nodiscard]] [[gnu::always_inline]] static std::size_t first_of(
        Compute top, const std::array<Compute, Size>& heights) {
        if constexpr (Size > 16) {
            return static_cast<std::size_t>(std::find(heights.begin(), heights.end(), top) - heights.begin());
        } else {
            unsigned equal = 0;
#pragma GCC unroll 16
            for (unsigned i = 0; i < Size; ++i) equal |= static_cast<unsigned>(heights[i] == top) << i;
            return static_cast<std::size_t>(std::countr_zero(equal));
        }
    }

    Compute coordinate(int k, std::size_t v) const {
        return static_cast<Compute>(load(axis(k)[v], Field::vertex));
    }
    [[nodiscard]] Stored* axis(int k) const { return coordinates_.axis(k, this->block_.base()); }

    /// Heights of `count` vertices; what is left of the chunk can never win. Positions have 64 bits here: a
    /// sum of 32-bit ones may wrap round, and g++ then gathers scalars one by one.
    template <std::size_t Size>
    [[gnu::always_inline]] void measure(std::size_t first, std::size_t count, const Vec3<Compute>& direction,
                                        std::array<Compute, Size>& heights) const {
        const Compute x = direction.x(), y = direction.y(), z = direction.z();
        const Stored *const xs = axis(0) + first, *const ys = axis(1) + first, *const zs = axis(2) + first;
        const auto read = [this](const Stored& location) {
            return static_cast<Compute>(load(location, Field::vertex));
        };
        for (std::size_t i = 0; i < count; ++i)
            heights[i] = read(xs[i]) * x + read(ys[i]) * y + read(zs[i]) * z;
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
