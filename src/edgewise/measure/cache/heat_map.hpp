// SPDX-License-Identifier: MIT
//
// Where accesses go: by field, by step, by line of 64 bytes, and which bytes were ever touched. What a scene
// needs of its tables, against what they hold.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "edgewise/measure/cache/trace.hpp"

namespace edgewise::measure {

/// Bytes of a stretch of memory that were ever touched: a bit per byte.
class TouchedBytes {
  public:
    void touch(std::uint64_t from, std::uint64_t bytes);

    /// Returns how many of the bytes from .. from + bytes - 1 were touched.
    [[nodiscard]] std::uint64_t count(std::uint64_t from, std::uint64_t bytes) const;
    [[nodiscard]] std::uint64_t count() const { return count(0, bytes_.size()); }

  private:
    std::vector<bool> bytes_;
};

class HeatMap final : public TraceListener {
  public:
    /// fields, steps: how many there are.
    HeatMap(std::size_t fields, std::size_t steps);

    void on_query_start(QueryStart start) override { start_ = start; }
    void on_access(const TracedAccess& access) override;
    void on_query_end(bool counts) override;

    [[nodiscard]] const ByStart<std::uint64_t>& queries() const { return queries_; }
    /// Returns the number of distinct lines of tables that a query accesses, summed over queries.
    [[nodiscard]] const ByStart<std::uint64_t>& lines_of_queries() const { return lines_of_queries_; }
    [[nodiscard]] const ByStart<std::vector<std::uint64_t>>& accesses_by_field() const { return by_field_; }
    [[nodiscard]] const std::vector<std::uint64_t>& accesses_by_step() const { return by_step_; }
    /// Returns the accesses of each line, from address 0 on.
    [[nodiscard]] const std::vector<std::uint32_t>& accesses_by_line() const { return by_line_; }
    [[nodiscard]] const TouchedBytes& touched() const { return touched_; }

    /// Returns the smallest number of lines that take this part of all accesses to lines.
    [[nodiscard]] std::uint64_t lines_taking(double part) const;
    /// Returns the number of lines that were accessed at least once.
    [[nodiscard]] std::uint64_t lines() const;

  private:
    ByStart<std::vector<std::uint64_t>> by_field_;
    std::vector<std::uint64_t> by_step_;
    std::vector<std::uint32_t> by_line_;
    std::vector<std::uint64_t> last_query_;  ///< by line: number of the query that accessed it last
    TouchedBytes touched_;
    ByStart<std::uint64_t> queries_, lines_of_queries_;
    std::optional<QueryStart> start_;  ///< of the current query; nothing between queries
};

}  // namespace edgewise::measure
