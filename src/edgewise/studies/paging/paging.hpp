// SPDX-License-Identifier: MIT
//
// Major page faults of a scene's queries when memory is too small for its tables: real faults under memory
// limits, next to the prediction by page-granular reuse distance. Tables lie in a file-backed mapping
// without read-ahead, so that pages are evicted and read one by one, without any swap; each limit is
// a process of its own in a memory control group.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "edgewise/bench/registry.hpp"
#include "edgewise/measure/expected.hpp"
#include "edgewise/scene/workload.hpp"

namespace edgewise::studies {

/// Result under one limit.
struct PagingRow {
    std::uint64_t limit_bytes = 0;
    /// Faults per query by reuse distance, if all of the limit were for the tables; of all queries and by
    /// their start.
    measure::ByStart<std::optional<double>> predicted_at_limit;
    std::optional<std::uint64_t> table_pages_held;  ///< in memory after a pass: what the limit left them
    double predicted_at_held = 0;                   ///< the same prediction in that memory
    double faults_per_query = 0;                    ///< major, measured
    double ns_per_query = 0;
    std::string reason;  ///< why there is no measurement
};

struct PagingResult {
    std::string table, algorithm;
    std::uint64_t table_bytes = 0, pages_touched = 0, queries = 0;  ///< of one pass
    bool keeps_recency = true;  ///< else the system may evict any page, and LRU predicts nothing
    std::vector<PagingRow> rows;
    std::string reason;  ///< why there are none
};

/// Returns the size of a page of this system.
[[nodiscard]] std::uint64_t page_bytes();

/// Returns the limits in bytes for tables with `touched_bytes` touched bytes; 0: no limit.
using PagingLimits = std::function<std::vector<std::uint64_t>(std::uint64_t touched_bytes)>;

/// Measures one table per instance of the workload, of one type. Each limit runs one pass to fill memory,
/// then three that are counted; figures are their means. `stop` is checked between limits; the rows after
/// it are then missing.
[[nodiscard]] PagingResult measure_paging(const bench::TableType& type, const std::string& algorithm,
                                          const scene::Workload& workload, const PagingLimits& limits,
                                          const std::atomic<bool>& stop);

}  // namespace edgewise::studies
