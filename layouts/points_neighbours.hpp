// SPDX-License-Identifier: MIT
//
// A vertex and its neighbours in one record: its coordinates, then those of all its neighbours, then the
// places of their records. A hill-climbing step reads only the record of its vertex: two cache lines in
// single for a vertex of six neighbours, four in double. A step up goes straight to the next record. For GJK
// only.
//
// Records start on cache lines and have the length that they need. Per record 20 bytes in single (32 in
// double): coordinates, the vertex's own index and the number of neighbours; and 16 (28) per neighbour: a
// copy of its coordinates and the line where its record starts. The price: every vertex is kept once for
// itself and once for each neighbour, ten times the bytes of coordinates alone.
#pragma once

#include <cassert>
#include <cstddef>
#include <new>
#include <string_view>
#include <vector>

#include "edgewise/layout_parts/block_table.hpp"

namespace edgewise {

/// A handle of a vertex: the line where its record starts, and the byte where coordinates of it are, its own
/// or the copy in a neighbour's record.
struct PointHandle {
    Index record, at;
    [[nodiscard]] bool operator==(const PointHandle& other) const { return record == other.record; }
};

/// The start of a record; the coordinates of `count` neighbours follow, then the lines of their records.
template <class Stored>
struct PointRecord {
    Vec3<Stored> point;
    Index index;  ///< in the canonical body
    Index count;

    static constexpr std::size_t line = BlockPlan::alignment;

    [[nodiscard]] Vec3<Stored>* around() { return reinterpret_cast<Vec3<Stored>*>(this + 1); }
    [[nodiscard]] Index* starts() { return reinterpret_cast<Index*>(around() + count); }
    /// Number of lines from one record to the next.
    [[nodiscard]] static Index length(std::size_t count) {
        const std::size_t bytes = sizeof(PointRecord) + count * (sizeof(Vec3<Stored>) + sizeof(Index));
        return static_cast<Index>((bytes + line - 1) / line);
    }
};

template <Precision P, class Loader = Direct>
class points_neighbours : public BlockTable<P, Loader> {
    using Base = BlockTable<P, Loader>;
    using Base::block_, Base::load;

  public:
    using typename Base::Compute, typename Base::Stored;
    using Vertex = PointHandle;

    static constexpr std::string_view name = "points_neighbours";
    static constexpr std::string_view stores =
        "one record per vertex, on lines of its own: its coordinates and its neighbours'";
    static constexpr std::string_view derives = "nothing";

    /// Both kinds of parts are the same here: nothing can be left out.
    points_neighbours(const Polyhedron& body, Parts parts, Loader loader = {}) : Base(body, parts, loader) {
        block_ = Block([&](BlockPlan& plan) {
            for (Index v = 0; v < body.vertex_count(); ++v) append(plan, body.ring_of_vertex(v).size());
        });
        std::vector<Index> start;
        for (Index v = 0; v < body.vertex_count(); ++v) {
            start.push_back(end_);
            end_ += Record::length(body.ring_of_vertex(v).size());
        }
        for (Index v = 0; v < body.vertex_count(); ++v) {
            const auto ring = body.ring_of_vertex(v);
            Record& to = *new (&record(start[v])) Record;
            to.index = v;
            to.count = static_cast<Index>(ring.size());
            for (std::size_t i = 0; i < ring.size(); ++i) to.starts()[i] = start[body.head(ring[i])];
        }
        write_body(body);
    }

    template <class OtherLoader>
    points_neighbours(const points_neighbours<P, OtherLoader>& other, Loader loader)
        : Base(other, loader), end_(other.end_) {}

    [[nodiscard]] std::vector<Piece> pieces() const {
        BlockPlan plan;
        for (Index at = 0; at < end_; at += Record::length(record(at).count)) append(plan, record(at).count);
        return plan.pieces(block_.base());
    }
    [[nodiscard]] Ledger ledger() const { return ledger_of(pieces()); }

    [[nodiscard]] Vertex first_vertex() const { return own(0); }
    [[nodiscard]] Index index_of(Vertex v) const { return load(record(v.record).index, Field::vertex); }
    [[nodiscard]] auto all_vertices() const {
        const auto after = [this](Index start) { return next(start); };
        return Chain(
            Index{0}, end_, [](Index start) { return own(start); }, after);
    }
    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const {
        assert(v.record < end_ && v.at < block_.size());
        const auto* const point = reinterpret_cast<const Vec3<Stored>*>(block_.base() + v.at);
        return cast<Compute>(load(*point, Field::vertex));
    }
    [[nodiscard]] auto neighbours(Vertex v) const {
        Record& from = record(v.record);
        const auto around = static_cast<Index>(reinterpret_cast<std::byte*>(from.around()) - block_.base());
        const Index count = load(from.count, Field::neighbour);
        return IndexedRing(0, count, [this, around, starts = from.starts()](Index i) {
            const Index start = load(starts[i], Field::neighbour);
            return PointHandle{start, around + i * static_cast<Index>(sizeof(Vec3<Stored>))};
        });
    }

    /// Writes records in the order of the body's vertices.
    void write_body(const Polyhedron& body) {
        Index start = 0;
        for (Index v = 0; v < body.vertex_count(); ++v) {
            Record& to = record(start);
            to.point = cast<Stored>(body.vertices[v]);
            const auto ring = body.ring_of_vertex(v);
            for (std::size_t i = 0; i < ring.size(); ++i)
                to.around()[i] = cast<Stored>(body.vertices[body.head(ring[i])]);
            start += Record::length(ring.size());
        }
    }

  private:
    template <Precision, class>
    friend class points_neighbours;

    using Record = PointRecord<Stored>;

    static void append(BlockPlan& plan, std::size_t count) {
        plan.append(Record::length(count) * Record::line,
                    {{Component::vertex_coordinates, sizeof(Vec3<Stored>)},
                     {Component::topology, 2 * sizeof(Index)},
                     {Component::vertex_coordinates, count * sizeof(Vec3<Stored>)},
                     {Component::topology, count * sizeof(Index)}});
    }

    [[nodiscard]] Record& record(Index start) const {
        assert(start < end_);
        return *reinterpret_cast<Record*>(block_.base() + std::size_t{start} * Record::line);
    }
    /// Handle of a vertex by its own coordinates, with which a record starts.
    [[nodiscard]] static Vertex own(Index start) { return {start, start * static_cast<Index>(Record::line)}; }
    [[nodiscard]] Index next(Index start) const {
        return start + Record::length(load(record(start).count, Field::neighbour));
    }

    Index end_ = 0;  // end of the last record, in lines
};

}  // namespace edgewise
