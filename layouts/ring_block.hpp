// SPDX-License-Identifier: MIT
//
// A vertex's ring as coordinates side by side: x, y and z of eight neighbours, then their indices. One step
// of a climb measures the whole ring in three rows, and then has the next vertex's coordinates; the layout of
// `points_neighbours` transposed, for lanes (not published elsewhere). For GJK only. A block is 128 bytes in
// single, two cache lines, and 256 in double. The vertices' own coordinates lie before the blocks, where
// scans and starts of climbs read them.
//
// Lanes that a ring leaves free repeat its last neighbour's coordinates, which never come first, and the
// first free index is the vertex itself: there the ring ends. A ring of more than eight continues: the eighth
// lane then repeats the seventh, and its index has the highest bit set and says which block is next. Such
// blocks lie behind the others. The price: lanes are full at degree eight, and the usual degree is six.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "edgewise/layout_parts/block_table.hpp"

namespace edgewise {

template <class Stored>
struct RingLanes {
    static constexpr Index lanes = 8;

    alignas(BlockPlan::alignment) Stored axis[3][lanes];  ///< x of all, y of all, z of all
    Index vertex[lanes];

    /// Number of lanes of a block that hold neighbours, if `left` neighbours of the ring are left.
    [[nodiscard]] static std::size_t used_of(std::size_t left) { return left <= lanes ? left : lanes - 1; }

    /// Adds one block, for a ring with `left` neighbours left.
    static void append(BlockPlan& plan, std::size_t left) {
        const std::size_t used = used_of(left) * sizeof(Stored), row = lanes * sizeof(Stored);
        const std::size_t indices = std::min<std::size_t>(left + 1, lanes) * sizeof(Index);
        plan.append(sizeof(RingLanes), {{Component::vertex_coordinates, used},
                                        {Component::padding, row - used},
                                        {Component::vertex_coordinates, used},
                                        {Component::padding, row - used},
                                        {Component::vertex_coordinates, used},
                                        {Component::padding, row - used},
                                        {Component::topology, indices}});
    }
};

/// Eight neighbours of a vertex, some of them twice where there are fewer, in the form that a climb needs
/// (table/contract.hpp).
template <class Compute, class Stored, class Loader>
class RingLanesView {
  public:
    RingLanesView(const RingLanes<Stored>& at, const Loader& loader) : at_(&at), loader_(&loader) {}

    [[nodiscard]] std::array<Compute, 8> heights(const Vec3<Compute>& direction) const {
        const Compute x = direction.x(), y = direction.y(), z = direction.z();
        std::array<Compute, 8> along;
        for (std::size_t i = 0; i < 8; ++i)
            along[i] = coordinate(0, i) * x + coordinate(1, i) * y + coordinate(2, i) * z;
        return along;
    }
    [[nodiscard]] Index vertex(std::size_t lane) const {
        return loader_->load(at_->vertex[lane], Field::neighbour);
    }
    [[nodiscard]] Vec3<Compute> point(std::size_t lane) const {
        return {coordinate(0, lane), coordinate(1, lane), coordinate(2, lane)};
    }

  private:
    [[nodiscard]] Compute coordinate(std::size_t k, std::size_t lane) const {
        return static_cast<Compute>(loader_->load(at_->axis[k][lane], Field::vertex));
    }

    const RingLanes<Stored>* at_;
    const Loader* loader_;
};

template <Precision P, class Loader = Direct>
class ring_block : public BlockTable<P, Loader> {
    using Base = BlockTable<P, Loader>;
    using Base::block_, Base::facts_, Base::load, Base::loader_;

  public:
    using typename Base::Compute, typename Base::Stored, typename Base::Vertex;

    static constexpr std::string_view name = "ring_block";
    static constexpr std::string_view stores =
        "coordinates, and per vertex its ring's coordinates and indices in blocks of eight lanes";
    static constexpr std::string_view derives = "nothing";

    /// Both kinds of parts are the same here: nothing can be left out.
    ring_block(const Polyhedron& body, Parts parts, Loader loader = {}) : Base(body, parts, loader) {
        const auto degree_of = [&](Index v) { return static_cast<Index>(body.ring_of_vertex(v).size()); };
        block_ = Block([&](BlockPlan& plan) { blocks_at_ = place(plan, degree_of); });
        Index next = facts_.vertex_count;
        for (Index v = 0; v < facts_.vertex_count; ++v) link(body, v, next);
        goes_on_ = next > facts_.vertex_count;
        write_body(body);
    }

    template <class OtherLoader>
    ring_block(const ring_block<P, OtherLoader>& other, Loader loader)
        : Base(other, loader), blocks_at_(other.blocks_at_), goes_on_(other.goes_on_) {}

    [[nodiscard]] std::vector<Piece> pieces() const {
        BlockPlan plan;
        static_cast<void>(place(plan, [this](Index v) { return degree(v); }));
        return plan.pieces(block_.base());
    }
    [[nodiscard]] Ledger ledger() const { return ledger_of(pieces()); }

    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const {
        assert(v < facts_.vertex_count);
        return cast<Compute>(load(points()[v], Field::vertex));
    }
    [[nodiscard]] auto neighbours(Vertex v) const {
        const auto after = [this, v](const Place& place) {
            return place.lane + 1 == lanes ? Place{0, 0, v} : at(place.block, place.lane + 1);
        };
        return Chain(
            at(v, 0), Place{0, 0, v}, [](const Place& place) { return place.vertex; }, after);
    }

    /// Blocks of a vertex's ring; the vertex must have neighbours.
    [[nodiscard]] auto ring_blocks(Vertex v) const {
        const auto after = [this](Index block) {
            const Index last = goes_on_ ? load(blocks()[block].vertex[lanes - 1], Field::neighbour) : 0;
            return last & more ? last & ~more : none;
        };
        return Chain(
            v, none, [this](Index block) { return View(blocks()[block], loader_); }, after);
    }

    void write_body(const Polyhedron& body) {
        for (Index v = 0; v < facts_.vertex_count; ++v) {
            points()[v] = cast<Stored>(body.vertices[v]);
            const auto ring = body.ring_of_vertex(v);
            Index block = v;
            for (std::size_t first = 0;;) {
                const std::size_t used = Lanes::used_of(ring.size() - first);
                for (std::size_t lane = 0; lane < lanes; ++lane) {
                    const Index from = used == 0 ? v : body.head(ring[first + std::min(lane, used - 1)]);
                    for (int k = 0; k < 3; ++k)
                        blocks()[block].axis[k][lane] = static_cast<Stored>(body.vertices[from][k]);
                }
                first += used;
                if (first == ring.size()) break;
                block = blocks()[block].vertex[lanes - 1] & ~more;
            }
        }
    }

  private:
    template <Precision, class>
    friend class ring_block;

    using Lanes = RingLanes<Stored>;
    using View = RingLanesView<Compute, Stored, Loader>;
    static constexpr Index lanes = Lanes::lanes, more = 1U << 31, none = 0xffffffff;

    /// Place of one neighbour; past the last one, the vertex itself.
    struct Place {
        Index block, lane, vertex;
        [[nodiscard]] bool operator==(const Place& other) const { return vertex == other.vertex; }
    };

    /// Returns the start of the blocks. degree_of(v): number of neighbours of each vertex of the body.
    template <class DegreeOf>
    [[nodiscard]] std::uint32_t place(BlockPlan& plan, const DegreeOf& degree_of) const {
        using Point = Vec3<Stored>;
        plan.template array_at<Point>(facts_.vertex_count, {{Component::vertex_coordinates, sizeof(Point)}});
        plan.append((BlockPlan::alignment - plan.size() % BlockPlan::alignment) % BlockPlan::alignment, {});
        const std::size_t start = plan.size();
        std::vector<std::size_t> rest;
        for (Index v = 0; v < facts_.vertex_count; ++v) {
            const std::size_t degree = degree_of(v);
            Lanes::append(plan, degree);
            if (degree > lanes) rest.push_back(degree);
        }
        for (std::size_t left : rest) {
            while (left > lanes) Lanes::append(plan, left -= lanes - 1);
        }
        return static_cast<std::uint32_t>(start);
    }
    /// Writes the indices of a vertex's ring; `next` is the first free block behind the vertices' own.
    void link(const Polyhedron& body, Index v, Index& next) const {
        const auto ring = body.ring_of_vertex(v);
        Index block = v;
        for (std::size_t first = 0;;) {
            const std::size_t used = Lanes::used_of(ring.size() - first);
            Lanes& to = blocks()[block];
            for (std::size_t i = 0; i < lanes; ++i) to.vertex[i] = i < used ? body.head(ring[first + i]) : v;
            first += used;
            if (first == ring.size()) return;
            block = next++;
            to.vertex[lanes - 1] = block | more;
        }
    }

    [[nodiscard]] Place at(Index block, Index lane) const {
        const Index vertex = load(blocks()[block].vertex[lane], Field::neighbour);
        return vertex & more ? at(vertex & ~more, 0) : Place{block, lane, vertex};
    }
    [[nodiscard]] Index degree(Index v) const {
        Index count = 0;
        for (const Index w : neighbours(v)) count += w != v;
        return count;
    }

    [[nodiscard]] auto* points() const { return reinterpret_cast<Vec3<Stored>*>(block_.base()); }
    [[nodiscard]] Lanes* blocks() const { return reinterpret_cast<Lanes*>(block_.base() + blocks_at_); }

    std::uint32_t blocks_at_ = 0;
    bool goes_on_ = false;  ///< a ring has more than eight neighbours
};

}  // namespace edgewise
