// SPDX-License-Identifier: MIT
//
// Points alone: the coordinates of the vertices in three arrays, x, y and z, and nothing else. Without
// neighbours no climb is possible, so a scan over all vertices finds each support point. Three plain arrays
// let the compiler scan several vertices at a time. For GJK only. No table of plain coordinates is smaller:
// 24 bytes per vertex in double, 12 in single; no topology.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <type_traits>

#include "edgewise/geometry/pack.hpp"
#include "edgewise/layout_parts/block_table.hpp"
#include "edgewise/table/loader.hpp"
#include "edgewise/table/small_array.hpp"

namespace edgewise {

/// The start of the arrays of x, y and z, in bytes from the block's start.
template <class Stored>
struct PointArrays {
    SmallArray<std::uint32_t, 3> at{};

    void place(BlockPlan& plan, const BodyFacts& n) {
        for (std::uint32_t& start : at)
            start = plan.array_at<Stored>(n.vertex_count, {{Component::vertex_coordinates, sizeof(Stored)}});
    }
};

template <Precision P, class Loader = Direct>
class points_soa : public PlacedTable<PointArrays<typename P::Stored>, P, Loader> {
    using Base = PlacedTable<PointArrays<typename P::Stored>, P, Loader>;
    using Base::load;

  public:
    using typename Base::Compute, typename Base::Stored, typename Base::Vertex;

    static constexpr std::string_view name = "points_soa";
    static constexpr std::string_view stores = "vertex coordinates in three arrays, no neighbours";
    static constexpr std::string_view derives = "support points, by scans";

    /// Both kinds of parts are the same here: nothing can be left out.
    points_soa(const Polyhedron& body, Parts parts, Loader loader = {}) : Base(body, parts, loader) {
        write_geometry(*this, body);
    }
    using Base::Base;

    void write_vertex(Index v, const Vec3d& point) {
        for (int k = 0; k < 3; ++k) axis(k)[v] = static_cast<Stored>(point[k]);
    }

    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const {
        assert(v < this->vertex_count());
        return {coordinate(0, v), coordinate(1, v), coordinate(2, v)};
    }

    /// Returns the vertex farthest along the direction, the first of equals.
    [[nodiscard]] Vertex scan_support(const Vec3<Compute>& direction) const {
        if constexpr (std::is_same_v<Loader, Direct> && pack_bytes > 0) {
            if (may_scan_wider<Compute>()) return scan_wider(direction);
            if (this->vertex_count() >= Pack<Compute>::size) return scan_packs<Pack<Compute>>(direction);
        }
        return scan_one_by_one(direction);
    }

    /// Returns the height of the farthest vertex along the direction.
    template <class Number>
    [[nodiscard]] Number scan_height(const Vec3<Number>& direction) const {
        if constexpr (std::is_same_v<Loader, Direct> && pack_bytes > 0) {
            if (may_scan_wider<Number>()) return height_wider(direction);
            if (this->vertex_count() >= Pack<Number>::size) return height_by_packs<Pack<Number>>(direction);
        }
        Number greatest = -std::numeric_limits<Number>::infinity();
        for (const Vertex v : this->all_vertices())
            greatest = std::max(greatest, dot(cast<Number>(vertex(v)), direction));
        return greatest;
    }

  private:
    /// True for bodies of at least four packs of 32 bytes where the build's flags allow 16 and the processor
    /// 32: there a call with wider packs is faster than a loop with the narrow ones.
    template <class Number>
    [[nodiscard]] bool may_scan_wider() const {
        return pack_bytes < 32 && this->vertex_count() >= 4 * Pack<Number, 32>::size && has_wider_packs();
    }

#ifdef __x86_64__
    [[nodiscard]] [[gnu::target("avx2")]] Vertex scan_wider(const Vec3<Compute>& direction) const {
        return scan_packs<Pack<Compute, 32>>(direction);
    }
    template <class Number>
    [[nodiscard]] [[gnu::target("avx2")]] Number height_wider(const Vec3<Number>& direction) const {
        return height_by_packs<Pack<Number, 32>>(direction);
    }
#else
    [[nodiscard]] Vertex scan_wider(const Vec3<Compute>&) const { return {}; }
    template <class Number>
    [[nodiscard]] Number height_wider(const Vec3<Number>&) const {
        return {};
    }
#endif

    /// Scans a pack of vertices at a time, the last ones perhaps twice: each lane keeps its highest, and at
    /// the end the first vertex with the highest value of all wins. No branch except the loop's.
    template <class Of>
    [[nodiscard]] [[gnu::always_inline]] Vertex scan_packs(const Vec3<Compute>& direction) const {
        const std::size_t count = this->vertex_count();
        typename Of::Numbers heights;
        heights_from<Of>(0, direction, heights);
        HighestOfPacks<Of> highest(heights);
        for (std::size_t next = Of::size; next < count; next += Of::size) {
            const std::size_t first = std::min(next, count - Of::size);
            heights_from<Of>(first, direction, heights);
            highest.take(heights, first);
        }
        return static_cast<Vertex>(highest.first_highest(count - 1));
    }

    template <class Of, class Number>
    [[nodiscard]] [[gnu::always_inline]] Number height_by_packs(const Vec3<Number>& direction) const {
        const std::size_t count = this->vertex_count();
        typename Of::Numbers highest, heights;
        heights_from<Of>(0, direction, highest);
        for (std::size_t next = Of::size; next < count; next += Of::size) {
            heights_from<Of>(std::min(next, count - Of::size), direction, heights);
            highest = heights > highest ? heights : highest;
        }
        return Of::greatest(highest);
    }

    template <class Of, class Number>
    [[gnu::always_inline]] void heights_from(std::size_t first, const Vec3<Number>& direction,
                                             typename Of::Numbers& heights) const {
        typename Of::Numbers x, y, z;
        Of::load(axis(0) + first, x);
        Of::load(axis(1) + first, y);
        Of::load(axis(2) + first, z);
        heights = x * direction.x() + y * direction.y() + z * direction.z();
    }

    [[nodiscard]] Vertex scan_one_by_one(const Vec3<Compute>& direction) const {
        Vertex best = this->first_vertex();
        Compute most = dot(vertex(best), direction);
        for (const Vertex v : this->all_vertices()) {
            const Compute along = dot(vertex(v), direction);
            if (!(along > most)) continue;
            most = along;
            best = v;
        }
        return best;
    }

    Compute coordinate(int k, std::size_t v) const {
        return static_cast<Compute>(load(axis(k)[v], Field::vertex));
    }
    [[nodiscard]] Stored* axis(int k) const { return this->template array<Stored>(this->places_.at[k]); }
};

}  // namespace edgewise
