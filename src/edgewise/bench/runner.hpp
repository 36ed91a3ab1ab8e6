// SPDX-License-Identifier: MIT
//
// An algorithm on a table type, with both types erased: what the sweep, `edgewise query` and the tests drive.
// Answers and times come from the same query code; only a whole pass is behind the virtual call.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "edgewise/algorithms/distance.hpp"
#include "edgewise/bench/named_answer.hpp"
#include "edgewise/bench/near_margins.hpp"
#include "edgewise/bench/prepared_workload.hpp"
#include "edgewise/bench/runner_options.hpp"
#include "edgewise/bench/support_times.hpp"
#include "edgewise/bench/trace/trace_extent.hpp"
#include "edgewise/measure/cache/trace.hpp"
#include "edgewise/measure/round.hpp"
#include "edgewise/scene/workload.hpp"
#include "edgewise/table/field_map.hpp"
#include "edgewise/table/pieces.hpp"

namespace edgewise::bench {

/// Memory of a cell's tables, and their build time.
struct MemoryUse {
    std::uint64_t tables = 0;
    double requested = 0;            ///< bytes asked of the allocator: the sum of the tables
    double taken = 0;                ///< bytes that these take there: headers, size classes, gaps
    std::optional<double> resident;  ///< bytes of pages in memory; nothing where the allocator has no figure
    double materialised = 1;         ///< part of the tables' bytes that was ever made; below 1 in lazy tables
};

struct BuildTimes {
    std::vector<double> build_ns;  ///< a table of the body, from scratch
    std::vector<double> refit_ns;  ///< the same table, in place, for the body deformed; empty: it cannot
};

/// One table's memory, and how many features of each kind its body has.
struct TableMap {
    std::vector<MappedPiece> pieces;  ///< offsets from the allocator's base, where it has one
    std::size_t vertices = 0, edges = 0, faces = 0;
};

/// What was measured of one table at many scales (scales/scale_study.hpp).
struct ScaleTimes {
    std::size_t scales = 0;                   ///< 0: the layout is not measured so
    std::vector<double> shared_ns, own_ns;    ///< of each repetition, per query
    std::vector<double> build_ns, refit_ns;   ///< of a table of a stretched body, from scratch and in place
    double shared_bytes = 0, own_bytes = 0;   ///< of tables, and of the objects that hold or view them
    std::size_t queries = 0, other_bits = 0;  ///< asked of both once; distances that differ
    std::size_t checked = 0;                  ///< of them, against exact ones
    double error = 0;                         ///< the worst, over the size of the problem
};

/// A pass over a workload's queries as an engine with threads makes it: frame after frame, each frame one
/// batch that the threads share.
class ThreadedPass {
  public:
    ThreadedPass() = default;
    ThreadedPass(const ThreadedPass&) = delete;
    ThreadedPass& operator=(const ThreadedPass&) = delete;
    virtual ~ThreadedPass() = default;

    /// Pairs know nothing any more, as before the first frame.
    virtual void set_back() = 0;

    /// Answers every query once, in at most `threads` threads including the caller's; returns after the last.
    virtual void run(int threads) = 0;

    /// Sum of the last run's distances in the order of the workload's queries, in the runner's unit: the bits
    /// of a RangePass over all of them.
    [[nodiscard]] virtual double sum() const = 0;

    /// Batches of a run.
    [[nodiscard]] virtual std::size_t frames() const = 0;
};

class Runner {
  public:
    /// in_single: what the precision computes in.
    explicit Runner(bool in_single) : in_single_(in_single) {}
    Runner(const Runner&) = delete;
    Runner& operator=(const Runner&) = delete;
    virtual ~Runner() = default;

    /// Sets the options for later loads.
    void configure(const RunnerOptions& options);

    /// Builds one table for each body (rounded to what the table stores), for single queries. An error line
    /// when a body cannot be stored.
    [[nodiscard]] std::string load(std::span<const Polyhedron> bodies);

    /// Builds the workload's tables, one for each body or for each instance as the options and the workload
    /// say, and prepares its queries: passes are over these. The workload must stay where it is.
    [[nodiscard]] std::string load(const scene::Workload& workload);

    /// The bodies that the tables really hold, in the given bodies' unit and order.
    [[nodiscard]] std::span<const Polyhedron> stored_bodies() const { return prepared_.unscaled_bodies(); }

    /// Margin of a query of loaded bodies, where needs have one, or the sum of the two bodies' radii; else 0.
    /// In the given bodies' unit.
    [[nodiscard]] double margin(const scene::Query& query) const;

    /// Answers every loaded query in order, from cold pairs; points in A's frame. For bodies farther from
    /// each other than the precision can compute with: status failed, here and below. Where
    /// needs have a margin, answers that give no distance are in the form of near_answer, in all passes.
    [[nodiscard]] std::vector<Distance> answer() const;

    /// Answers any query of the loaded bodies from a cold start, with features and, in contact, the depth,
    /// which also separates touching from overlapping.
    [[nodiscard]] virtual NamedAnswer answer(const scene::Query& query) const = 0;

    /// Times the loaded queries, after untimed passes over them: the caches hold what such a pass leaves
    /// there, whatever else is measured between two calls. `in_contact[i]` != 0 books query i under
    /// overlapping, else under separated; if it is empty, all are booked under either. The clock is read
    /// where the class changes, and its cost is subtracted; batches are asked class by class, until a pair
    /// comes again. In a warm scene a pair's first query, cold by nature, is booked apart, timed by itself:
    /// its accuracy is limited by the accuracy of the clock's cost.
    [[nodiscard]] measure::Timing time(std::span<const std::uint8_t> in_contact, double clock_cost_ns) const;

    /// Notifies of the accesses of loaded queries, from cold pairs, as far as the extent says; of a warm
    /// scene, those that start warm count. Answers, in the runner's unit, are written from answers[0] on
    /// unless it is null; those of queries that are not followed are left as they are.
    virtual PassSum trace(const TraceExtent& extent, measure::TraceListener& listener,
                          Distance* answers) const = 0;
    PassSum trace(const TraceExtent& extent, measure::TraceListener& listener) const {
        return trace(extent, listener, nullptr);
    }

    /// A pass over the loaded queries from cold pairs, ready to run as often as wanted, with nothing around
    /// the queries but setting the pairs back; for counters that are read outside. Narrow phase only: no
    /// broad phase. Not to outlive the runner.
    [[nodiscard]] std::function<PassSum()> prepared_pass() const;

    /// Runs queries first .. last - 1 as prepared_pass does, any number of times and in any ranges: pairs go
    /// on where the last call left them, and are reset where first is 0. Returns the sum of distances in the
    /// runner's unit; answers, in that unit too, are written from answers[first] on unless it is null.
    using RangePass = std::function<double(std::size_t first, std::size_t last, Distance* answers)>;
    [[nodiscard]] virtual RangePass prepared_range() const = 0;

    /// A pass in batches, over other queries of the loaded bodies, in the runner's unit; it must not outlive
    /// them. Null: the runner asks one after the other.
    [[nodiscard]] virtual RangePass batches_of(const scene::Workload& /*queries*/) const { return nullptr; }

    /// The loaded queries as batches over threads; not to outlive the runner. Of what passes ask of every
    /// answer it knows verdicts, distances and witnesses. Null: the runner cannot, as a library's, or its
    /// tables serve one thread at a time.
    [[nodiscard]] virtual std::unique_ptr<ThreadedPass> prepared_frames() const { return nullptr; }

    /// Bytes of the first table's block, and of the object that holds it.
    [[nodiscard]] virtual Ledger ledger() const = 0;
    [[nodiscard]] virtual std::size_t object_bytes() const = 0;

    /// Memory of all tables.
    [[nodiscard]] MemoryUse memory() const;

    /// The memory of every table.
    [[nodiscard]] virtual std::vector<TableMap> memory_maps() const = 0;

    /// Maps of every table's fields, by offset from the allocator's base; empty where the layout does not
    /// declare them.
    [[nodiscard]] virtual std::vector<FieldMap> field_maps() const { return {}; }

    /// Allocator of the tables' memory. Only after load().
    [[nodiscard]] const TableAllocator& table_allocator() const { return *memory_; }

    /// Times of building a table of the first body again, and of refitting one in place to the body deformed
    /// (twice as large and back, with the topology kept). Each is repeated `repetitions` times, alternating:
    /// neighbours in time are affected equally by changes in machine speed.
    [[nodiscard]] virtual BuildTimes build_times(int repetitions) const = 0;

    /// Support queries of the tables by themselves. Empty: the runner has no support points of its own.
    [[nodiscard]] virtual SupportTimes support_times(int /*repetitions*/) const { return {}; }

    /// The first body at many scales, over one table and over a table for each. Empty: the runner cannot.
    [[nodiscard]] virtual ScaleTimes scale_times(int /*repetitions*/) const { return {}; }

    /// Bytes of one pair's cache.
    [[nodiscard]] virtual std::size_t pair_bytes() const = 0;

  protected:
    [[nodiscard]] virtual Result<Polyhedron> store(const Polyhedron& body) const = 0;
    /// Builds a table for each body, in that order, and drops the present ones.
    virtual void build_tables(const std::vector<const Polyhedron*>& bodies) = 0;
    [[nodiscard]] virtual std::size_t table_count() const = 0;
    /// Mean part of the tables' bytes that was ever made.
    [[nodiscard]] virtual double materialised() const = 0;

    [[nodiscard]] const PreparedWorkload& prepared() const { return prepared_; }
    [[nodiscard]] const RunnerOptions& options() const { return options_; }  ///< in the runner's unit
    [[nodiscard]] bool asks_nearness() const { return has_margin(options_.needs); }
    [[nodiscard]] const NearMargins& margins() const { return margins_; }
    /// Radii of the workload's instances, in the runner's unit; empty if they have none.
    [[nodiscard]] std::span<const double> radii() const { return radii_; }
    [[nodiscard]] std::size_t table_a(const scene::Query& query) const {
        return table_each_ ? query.instance_a : query.body_a;
    }
    [[nodiscard]] std::size_t table_b(const scene::Query& query) const {
        return table_each_ ? query.instance_b : query.body_b;
    }
    [[nodiscard]] bool in_range(const scene::Query& query) const {
        return prepared_.in_range(query, in_single_);
    }

  private:
    [[nodiscard]] std::string load_tables(std::span<const Polyhedron> bodies,
                                          std::span<const std::uint32_t> instances);
    [[nodiscard]] std::string take_radii(const scene::Workload& workload);

    bool in_single_;
    RunnerOptions given_options_, options_;  ///< in the given bodies' unit, and in the runner's
    PreparedWorkload prepared_;
    NearMargins margins_;                     ///< where needs have a margin
    std::vector<double> radii_;               ///< where the options give bodies one
    std::unique_ptr<TableAllocator> memory_;  ///< allocator of the tables
    bool table_each_ = false;                 ///< one for each instance, not for each body
};

}  // namespace edgewise::bench
