// SPDX-License-Identifier: MIT
//
// An algorithm on a table type, with both types erased: what the sweep, `edgewise query` and the tests drive.
// Answers and times come from the same query code; only a whole pass is behind the virtual call.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "edgewise/algorithms/distance.hpp"
#include "edgewise/algorithms/query_options.hpp"
#include "edgewise/bench/table_options.hpp"
#include "edgewise/geometry/feature.hpp"
#include "edgewise/geometry/result.hpp"
#include "edgewise/measure/cache/trace.hpp"
#include "edgewise/measure/memory_use.hpp"
#include "edgewise/measure/round.hpp"
#include "edgewise/scene/workload.hpp"
#include "edgewise/table/ledger.hpp"
#include "edgewise/table/memory_map.hpp"
#include "edgewise/table/needs.hpp"

namespace edgewise::bench {

/// An answer with everything a user may ask for, in world coordinates. In contact the witness points are
/// those of the penetration: each body's point deepest in the other.
struct NamedAnswer {
    Distance distance;
    NamedFeature feature_a, feature_b;
    double depth = 0;              ///< 0 unless in contact
    bool depth_cut_short = false;  ///< EPA's work space was full: the depth is an upper bound
    Vec3d normal = Vec3d::Zero();  ///< in contact: B moved by depth * normal only touches A
    std::vector<Index> proof_a,
        proof_b;  ///< in contact: stored vertices whose hulls hold a common point, or nearly
};

/// What a pass beside the timed one answered, to be held against the answers: how many of the workload's
/// first queries, and the sum of their distances in order, which is the same bits if they are.
struct PassSum {
    std::size_t queries = 0;
    double distances = 0;
};

/// One table's memory, and how many features of each kind its body has.
struct TableMap {
    std::vector<MappedPiece> pieces;  ///< offsets from the allocator's base, where it has one
    std::size_t vertices = 0, edges = 0, faces = 0;
};

class Runner {
  public:
    Runner() = default;
    Runner(const Runner&) = delete;
    Runner& operator=(const Runner&) = delete;
    virtual ~Runner() = default;

    /// What later answers may give away; contact_tolerance in the given bodies' unit.
    virtual void set_options(const QueryOptions& options) = 0;

    /// What later passes and timings ask of every answer, and pay for; witnesses at first, which comes with
    /// the distance. Answers themselves stay as they are, but for the verdict alone: query_options.hpp.
    virtual void set_needs(Needs needs) = 0;

    /// How tables loaded later are placed.
    virtual void place_tables(const TableOptions& options) = 0;

    /// Builds one table for each body (rounded to what the table stores); with `instances`, one for each of
    /// these, of the body that it says. An error line when a body cannot be stored.
    [[nodiscard]] virtual std::string load(std::span<const Polyhedron> bodies,
                                           std::span<const std::uint32_t> instances) = 0;
    [[nodiscard]] std::string load(std::span<const Polyhedron> bodies) { return load(bodies, {}); }

    /// The bodies that the tables really hold, in the tables' order.
    [[nodiscard]] virtual std::span<const Polyhedron> stored_bodies() const = 0;

    /// Every query of the workload in order, from cold pairs; points in A's frame. Bodies farther apart than
    /// the precision can compute with: status failed, here and below.
    [[nodiscard]] virtual std::vector<Distance> answer(const scene::Workload& workload) const = 0;

    /// One query from a cold start, with features and, in contact, the depth, which also tells touching from
    /// overlapping.
    [[nodiscard]] virtual NamedAnswer answer(const scene::Query& query) const = 0;

    /// Times the whole workload; `in_contact[i]` != 0 books query i under overlapping, else under separated.
    /// The clock is read where the class changes, and its cost is subtracted. In a warm scene a pair's first
    /// query, cold by nature, is answered outside the clock: the scene `cold` is for those.
    [[nodiscard]] virtual measure::Timing time(const scene::Workload& workload,
                                               std::span<const std::uint8_t> in_contact,
                                               double clock_cost_ns) const = 0;

    /// Bytes of the first table.
    [[nodiscard]] virtual Ledger ledger() const = 0;

    /// What all tables take.
    [[nodiscard]] virtual measure::MemoryUse memory() const = 0;

    /// Times of building a table of the first body anew, and of refitting one in place to the body deformed,
    /// so often each, in turn.
    [[nodiscard]] virtual measure::BuildTimes build_times(int repetitions) const = 0;

    /// Tells of the accesses of the first queries of the workload, from cold pairs, until so many have
    /// counted; of a warm scene, those that start warm count.
    virtual PassSum trace(const scene::Workload& workload, std::size_t limit,
                          measure::TraceListener& listener) const = 0;

    /// A pass over the whole workload from cold pairs, ready to run as often as wanted, with nothing around
    /// the queries but setting the pairs back; for counters that are read outside. Narrow phase only: no
    /// broad phase. Not to outlive the runner nor the workload.
    [[nodiscard]] virtual std::function<PassSum()> prepared_pass(const scene::Workload& workload) const = 0;

    /// As prepared_pass, but for queries first .. last - 1, as often and far as the caller goes: pairs go on
    /// where the last call left them, and are set back where first is 0. Returns the sum of distances.
    using RangePass = std::function<double(std::size_t first, std::size_t last)>;
    [[nodiscard]] virtual RangePass prepared_range(const scene::Workload& workload) const = 0;

    /// Bytes of one pair's cache.
    [[nodiscard]] virtual std::size_t pair_bytes() const = 0;

    /// What the tables stand in. Only after load().
    [[nodiscard]] virtual const TableAllocator& table_allocator() const = 0;

    /// The memory of every table.
    [[nodiscard]] virtual std::vector<TableMap> memory_maps() const = 0;
};

}  // namespace edgewise::bench
