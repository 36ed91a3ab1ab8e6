// SPDX-License-Identifier: MIT
//
// What queries miss that find every cache empty: lines of tables are dropped from all levels after each
// query. More than the distinct lines of a query only where it needs more of them than a set holds.
#pragma once

#include <span>
#include <vector>

#include "edgewise/measure/cache/cache_machine.hpp"
#include "edgewise/measure/cache/trace.hpp"

namespace edgewise::measure {

class ColdCaches final : public TraceListener {
  public:
    explicit ColdCaches(std::span<const CacheMachine> machines);

    void on_access(const TracedAccess& access) override;
    void on_query_end(bool counts) override;

    /// Of a machine's cache levels, summed over queries.
    [[nodiscard]] std::vector<std::uint64_t> misses(std::size_t machine) const;

  private:
    struct Cold {
        CacheModel model;
        std::vector<std::uint64_t> lines;  ///< brought in by the query at hand
    };

    std::vector<Cold> machines_;
};

}  // namespace edgewise::measure
