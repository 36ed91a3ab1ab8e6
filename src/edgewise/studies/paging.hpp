// SPDX-License-Identifier: MIT
//
// What happens when memory is too small for a scene's tables: real major page faults of its queries under
// memory limits, beside what the page-granular reuse distance predicts. Tables stand in a file-backed mapping
// without read-ahead, so that pages are thrown out and come back one by one, without any swap; each limit is
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

/// One limit.
struct PagingRow {
    std::uint64_t limit_bytes = 0;
    /// Faults per query by reuse distance, were all of the limit for the tables; of all queries and by their
    /// start.
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
    bool keeps_recency = true;  ///< else the system may throw out any page, and a prediction by LRU is none
    std::vector<PagingRow> rows;
    std::string reason;  ///< why there are none
};

/// Of a page of this system.
[[nodiscard]] std::uint64_t page_bytes();

/// Limits in bytes, for tables of which so many bytes are touched; 0: none.
using PagingLimits = std::function<std::vector<std::uint64_t>(std::uint64_t touched_bytes)>;

/// The workload's tables, one for each instance, of one type. Each limit runs one pass over the workload to
/// fill memory, then three that are counted; figures are their means. `stop` is looked at between limits; the
/// rest of the rows is missing then.
[[nodiscard]] PagingResult measure_paging(const bench::TableType& type, const std::string& algorithm,
                                          const scene::Workload& workload, const PagingLimits& limits,
                                          const std::atomic<bool>& stop);

}  // namespace edgewise::studies
