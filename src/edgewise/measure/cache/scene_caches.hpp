// SPDX-License-Identifier: MIT
//
// Runs a trace through the caches of several machines, and through reuse distances, to model a scene's use
// of memory. Two passes over the same queries: the first finds every cache empty, the second finds what the
// first left. Misses of the second are those of the scene in its steady state. They are counted over all
// queries, and separately over cold and warm starts, which go through the same caches in the same pass.
//
// Why a line was missed (Hill and Smith, "Evaluating associativity in CPU caches", 1989): it never came
// before (compulsory); a fully associative LRU cache of the level's size would have missed it as well
// (capacity); or only the level's sets and policy did (conflict). An exclusive level's size is its own and
// that of the levels above.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/measure/cache/cache_machine.hpp"
#include "edgewise/measure/cache/reuse_distance.hpp"
#include "edgewise/measure/cache/trace.hpp"

namespace edgewise::measure {

/// Why lines were missed.
struct MissKinds {
    std::uint64_t compulsory = 0, capacity = 0, conflict = 0;

    [[nodiscard]] std::uint64_t all() const { return compulsory + capacity + conflict; }
};

/// Misses of one level of one machine in one pass.
struct LevelMisses {
    std::string level;
    std::uint64_t accesses = 0;
    std::uint64_t first_touches = 0;  ///< of units that were never touched before
    MissKinds misses;
    std::vector<std::uint64_t> by_field, by_step;
};

/// Misses of one machine in one pass.
struct MachineMisses {
    std::vector<LevelMisses> caches, tlbs;
    /// Bytes fetched into the first level, and bytes left there by the pass before. Known for all queries
    /// together only, because a query may use bytes that another query fetched.
    CacheModel::Fetched fetched;
    std::optional<double> memory_ns;  ///< modelled; nothing where latencies are not known
    bool proved = false;              ///< every latency in it is proved by its source
};

/// Reuse of lines of 64 bytes, or of pages of 4 KiB.
struct ReuseOf {
    std::uint64_t unit_bytes = 0;
    std::uint64_t distinct = 0;   ///< ever touched
    std::uint64_t of_tables = 0;  ///< distinct units with bytes of tables
    /// Distinct units of tables that a query touches, summed over the queries of the second pass.
    ByStart<std::uint64_t> touched;
    ByStart<std::uint64_t> with_scene;  ///< the same with the scene's own memory
    std::uint64_t in_frames = 0;        ///< distinct units of a frame, summed over the frames
    ByStart<MissCurve> steady;          ///< of the second pass
};

class SceneCaches final : public TraceListener {
  public:
    /// fields, steps: number of each. framed: true if the ends of frames will be reported.
    SceneCaches(std::span<const CacheMachine> machines, std::size_t fields, std::size_t steps,
                bool framed = false);
    ~SceneCaches() override;

    void on_query_start(QueryStart start) override { start_ = start; }
    void on_access(const TracedAccess& access) override;
    void on_query_end(bool counts) override;
    void on_frame_end() override;

    /// Starts the second pass; later accesses count for it.
    void start_steady();

    /// Queries of a pass.
    [[nodiscard]] const ByStart<std::uint64_t>& queries() const { return queries_; }
    /// Whole frames of a pass; 0 where the scene is not asked frame after frame.
    [[nodiscard]] std::uint64_t frames() const { return frames_; }
    /// Return the misses of the first and of the second pass, in the order of the machines.
    [[nodiscard]] const std::vector<MachineMisses>& first() const { return first_; }
    [[nodiscard]] std::vector<ByStart<MachineMisses>> steady() const;

    [[nodiscard]] ReuseOf lines() const;
    [[nodiscard]] ReuseOf pages() const;

  private:
    class Modelled;
    struct Machine;
    struct Stack;

    [[nodiscard]] ReuseOf reuse_of(std::uint32_t unit) const;

    std::vector<Machine> machines_;
    std::map<std::uint32_t, Stack> stacks_;  ///< by unit: lines of every size in question, and pages
    std::vector<MachineMisses> first_;
    ByStart<std::uint64_t> queries_;
    std::optional<QueryStart> start_;  ///< of the current query; nothing between queries
    std::uint64_t frames_ = 0;
    bool framed_;
};

/// A machine, or why it was not modelled.
struct ModelledMachine {
    std::string name, reason;
    MachineMisses first;                          ///< pass, of all queries
    ByStart<MachineMisses> steady;                ///< the second
    ByStart<std::vector<std::uint64_t>> emptied;  ///< by cache level: misses of queries from empty caches
};

/// What of the tables' memory the scene ever touched.
struct TouchedTables {
    std::uint64_t bytes = 0, of_bytes = 0;
    std::map<std::string, double> by_component;  ///< part of the component's bytes
    /// part of the table's elements that hold vertices, edges, faces; nothing: it has none of their own
    std::optional<double> vertices, edges, faces;
};

/// Accesses of both passes.
struct SceneHeat {
    ByStart<std::vector<std::uint64_t>> by_field;
    std::vector<std::uint64_t> by_step;
    ByStart<std::uint64_t> queries;
    ByStart<std::uint64_t> lines_of_queries;  ///< summed: distinct ones of tables of each
    std::uint64_t lines = 0;
    std::uint64_t lines_of_half = 0, lines_of_most = 0;  ///< hottest, of 50 % and of 90 % of accesses
    TouchedTables tables;
};

/// What a cell's traced passes gave.
struct SceneTrace {
    std::string reason = "this cell was not chosen for modelled caches",
                remedy = "edgewise sweep --caches";  ///< why there is nothing; empty: there is
    ByStart<std::uint64_t> queries;                  ///< of a pass
    std::uint64_t frames = 0, tables = 0;            ///< of a pass; in all
    std::vector<ModelledMachine> machines;
    std::vector<ModelledMachine> policies;  ///< one of the machines under other replacement policies
    ReuseOf lines, pages;
    SceneHeat heat;
    std::size_t answered = 0;  ///< queries of the second pass, cold first ones of pairs included
    double distances = 0;      ///< sum of its answers, in order
    std::span<const std::string_view> fields, steps;  ///< names by number

    [[nodiscard]] bool traced() const { return reason.empty(); }
};

/// Misses of queries that find every cache empty, whether they start cold or warm: lines of tables are
/// dropped from all levels after each query. There are more of them than distinct lines of a query only where
/// it needs more lines than a set holds.
class ColdCaches final : public TraceListener {
  public:
    explicit ColdCaches(std::span<const CacheMachine> machines);

    void on_query_start(QueryStart start) override { start_ = start; }
    void on_access(const TracedAccess& access) override;
    void on_query_end(bool counts) override;

    /// Misses of a machine's cache levels, summed over queries.
    [[nodiscard]] const ByStart<std::vector<std::uint64_t>>& misses(std::size_t machine) const {
        return machines_[machine].misses;
    }

  private:
    struct Cold {
        CacheModel model;
        ByStart<std::vector<std::uint64_t>> misses;
        std::vector<std::uint64_t> booked;  ///< misses of the model up to the last query's end
        std::vector<std::uint64_t> lines;   ///< brought in by the current query
    };

    std::vector<Cold> machines_;
    std::optional<QueryStart> start_;
};

}  // namespace edgewise::measure
