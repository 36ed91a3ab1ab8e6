// SPDX-License-Identifier: MIT
//
// Counts what queries read of their tables: distinct cache lines of 64 bytes, as a cache sees them, and the
// bytes that were accessed. Each side of a pair is a table of its own here, whether or not they share one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_set>

#include "edgewise/measure/cache/trace.hpp"

namespace edgewise::measure {

inline constexpr std::size_t cache_line = 64;

/// How many queries are traced: the first ones of a scene; enough for a mean to a few percent.
inline constexpr std::size_t traced_queries = 1000;

/// Sums over queries.
struct LinesTouched {
    std::uint64_t queries = 0, reads = 0, bytes = 0, lines = 0;

    LinesTouched& operator+=(const LinesTouched& other);
};

/// Counts the reads of tables; the scene's own memory is left out.
class LineCounter final : public TraceListener {
  public:
    void on_query_start(QueryStart start) override { start_ = start; }
    void on_access(const TracedAccess& access) override;
    void on_query_end(bool counts) override;

    [[nodiscard]] const ByStart<LinesTouched>& sums() const { return sums_; }

  private:
    ByStart<LinesTouched> sums_;
    LinesTouched query_;
    std::optional<QueryStart> start_;
    std::unordered_set<std::uint64_t> lines_;  ///< of the current query: twice the line, and the side
};

}  // namespace edgewise::measure
