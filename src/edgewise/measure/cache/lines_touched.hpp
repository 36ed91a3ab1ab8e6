// SPDX-License-Identifier: MIT
//
// What queries read of their tables: distinct cache lines of 64 bytes, which is what a cache sees, beside the
// bytes that were asked for. Each side of a pair is a table of its own here, whether or not they share one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "edgewise/measure/cache/trace.hpp"

namespace edgewise::measure {

inline constexpr std::size_t cache_line = 64;

/// How many queries are traced: the first ones of a scene; enough for a mean to a few percent.
inline constexpr std::size_t traced_queries = 1000;

/// Sums over queries.
struct LinesTouched {
    std::uint64_t queries = 0, reads = 0, bytes = 0, lines = 0;
};

/// Counts the reads of tables; the scene's own memory is left out. Addresses should be small: memory is used up to the
/// largest.
class LineCounter final : public TraceListener {
  public:
    void on_access(const TracedAccess& access) override;
    void on_query_end(bool counts) override;

    [[nodiscard]] const LinesTouched& sums() const { return sums_; }

  private:
    LinesTouched sums_, query_;
    std::uint32_t query_number_ = 1;
    std::vector<std::uint32_t> last_query_;  ///< that read twice the line, and the side; 0: none did
};

}  // namespace edgewise::measure
