// SPDX-License-Identifier: MIT
//
// A vertex and its neighbours in one record: coordinates, then who is around. A hill-climbing step reads the
// record it stands on and the coordinates of the records around it, and nothing else: no offsets, no rows in
// another array. A neighbour is named by where its record starts, so a step goes straight there. Records are
// as long as they need to be, one behind the other, in units of a stored scalar's alignment; a vertex of six
// neighbours takes 56 bytes in double, 44 in single. For GJK only. The bytes: coordinates, and as topology
// the vertex's own index, the number of neighbours and four bytes each; where their number is odd, a record
// in double ends in four bytes of padding.
#pragma once

#include <vector>

#include "edgewise/table/block_table.hpp"

namespace edgewise {

/// The start of a record; `count` neighbours follow, each the start of its record in units.
template <class Stored>
struct PointRecord {
    Vec3<Stored> point;
    Index index;  ///< in the canonical body
    Index count;

    static constexpr std::size_t unit = alignof(Stored);

    [[nodiscard]] const Index* neighbours() const { return reinterpret_cast<const Index*>(this + 1); }
    [[nodiscard]] Index* neighbours() { return reinterpret_cast<Index*>(this + 1); }
    /// Units from one record to the next.
    [[nodiscard]] static Index length(std::size_t count) {
        return static_cast<Index>((sizeof(PointRecord) + count * sizeof(Index) + unit - 1) / unit);
    }
};

/// The records of a table one after another, by where they start.
template <class Table>
class RecordWalk {
  public:
    class Iterator {
      public:
        Iterator(const Table& table, Index at) : table_(&table), at_(at) {}
        Index operator*() const { return at_; }
        Iterator& operator++() {
            at_ = table_->next(at_);
            return *this;
        }
        bool operator!=(const Iterator& other) const { return at_ != other.at_; }

      private:
        const Table* table_;
        Index at_;
    };

    RecordWalk(const Table& table, Index end) : table_(&table), end_(end) {}
    [[nodiscard]] Iterator begin() const { return {*table_, 0}; }
    [[nodiscard]] Iterator end() const { return {*table_, end_}; }

  private:
    const Table* table_;
    Index end_;
};

template <Precision P, class Loader = Direct>
class points_neighbours : public BlockTable<P, Loader> {
    using Base = BlockTable<P, Loader>;
    using Base::block_;
    using Base::load;

  public:
    using typename Base::Compute;
    using typename Base::Stored;
    using typename Base::Vertex;  // where the record starts, in units

    static constexpr std::string_view name = "points_neighbours";
    static constexpr std::string_view relative_of = "points_soa";
    static constexpr std::string_view stores =
        "one record a vertex: coordinates and where its neighbours are";
    static constexpr std::string_view derives = "nothing";

    /// Both kinds of parts are the same here: there is nothing to leave out.
    points_neighbours(const Polyhedron& body, Parts parts, Loader loader = {}) : Base(loader) {
        BlockPlan plan;
        std::vector<Index> start;
        for (Index v = 0; v < body.vertex_count(); ++v) {
            const std::size_t count = body.ring_of_vertex(v).size();
            start.push_back(
                static_cast<Index>(plan.append(Record::length(count) * Record::unit,
                                               {{Component::vertex_coordinates, sizeof(Vec3<Stored>)},
                                                {Component::topology, (2 + count) * sizeof(Index)}}) /
                                   Record::unit));
        }
        end_ = static_cast<Index>(plan.size() / Record::unit);
        this->allocate(std::move(plan), body, parts);
        for (Index v = 0; v < body.vertex_count(); ++v) {
            const auto ring = body.ring_of_vertex(v);
            Record& to = *new (&record(start[v])) Record;
            to.index = v;
            to.count = static_cast<Index>(ring.size());
            for (std::size_t i = 0; i < ring.size(); ++i) to.neighbours()[i] = start[body.head(ring[i])];
        }
        write_body(body);
    }

    /// The same memory seen through another loader.
    template <class OtherLoader>
    points_neighbours(const points_neighbours<P, OtherLoader>& other, Loader loader)
        : Base(other, loader), end_(other.end_) {}

    [[nodiscard]] Index index_of(Vertex v) const { return load(record(v).index, Field::vertex); }
    [[nodiscard]] auto all_vertices() const { return RecordWalk<points_neighbours>(*this, end_); }
    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const {
        return cast<Compute>(load(record(v).point, Field::vertex));
    }
    [[nodiscard]] auto neighbours(Vertex v) const {
        const Record& at = record(v);
        return IndexedRing(0, count(at), [this, around = at.neighbours()](Index i) {
            return load(around[i], Field::neighbour);
        });
    }

    /// Records lie in the order of the body's vertices.
    void write_body(const Polyhedron& body) {
        Vertex at = 0;
        for (const Vec3d& point : body.vertices) {
            record(at).point = cast<Stored>(point);
            at += Record::length(record(at).count);
        }
    }

  private:
    template <Precision, class>
    friend class points_neighbours;
    friend class RecordWalk<points_neighbours>;

    using Record = PointRecord<Stored>;

    [[nodiscard]] Record& record(Vertex v) const {
        return *reinterpret_cast<Record*>(block_.base() + std::size_t{v} * Record::unit);
    }
    [[nodiscard]] Index count(const Record& at) const { return load(at.count, Field::neighbour); }
    [[nodiscard]] Vertex next(Vertex v) const { return v + Record::length(count(record(v))); }

    Index end_ = 0;  // of the last record
};

}  // namespace edgewise
