// SPDX-License-Identifier: MIT
//
// One query, step by step: the features at which V-Clip stands, or the corners of GJK's simplex, and the
// cache lines of the query's tables that each step reads. Features are those of a run on the canonical body,
// lines those of a table's trace. A walk is kept only if the table takes the same steps.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include "edgewise/bench/runner.hpp"
#include "edgewise/bench/trace/trace_names.hpp"
#include "edgewise/measure/cache/trace.hpp"

namespace edgewise::bench {

struct WalkStep {
    TraceStep state;
    std::vector<Index> a = {}, b = {};  ///< vertices of a feature of each body, or of the simplex
    std::set<std::uint64_t> lines = {};

    [[nodiscard]] bool operator==(const WalkStep&) const = default;
};

struct Walk {
    std::size_t query = 0;              ///< of the workload
    std::vector<std::uint64_t> tables;  ///< lines of each table that is read: of both bodies, or one each
    std::vector<WalkStep> steps;        ///< lines count from the first table's start, through both tables
};

/// Follows one query through a trace.
class WalkTrace final : public measure::TraceListener {
  public:
    /// Chooses among the cold ones of the workload's first `within` queries, up to 200, for which V-Clip
    /// takes the same way over derived planes and over planes of unit normals: the one with the median number
    /// of steps of those with four or more; if there is none, the one with the most steps.
    WalkTrace(std::string_view algorithm, std::span<const Polyhedron> stored, const scene::Workload& workload,
              std::size_t within);

    void on_query_start(measure::QueryStart /*start*/) override { follows_ = next_++ == walk_.query; }
    void on_step_start(std::uint8_t step) override;
    void on_access(const measure::TracedAccess& access) override;
    void on_query_end(bool /*counts*/) override { follows_ = false; }

    /// Returns the walk, which begins with what is read before the first state, if anything is. Nothing if no
    /// query was chosen or the table took other steps. `maps`: of all tables.
    [[nodiscard]] std::optional<Walk> walk(std::span<const TableMap> maps) const;

  private:
    Walk walk_;
    std::vector<WalkStep> traced_;  ///< states and lines, by address
    std::size_t next_ = 0;
    bool follows_ = false;
};

}  // namespace edgewise::bench
