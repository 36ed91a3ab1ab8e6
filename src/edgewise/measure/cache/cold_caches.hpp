// SPDX-License-Identifier: MIT
//
// What queries miss that find every cache empty, whether they start cold or warm: lines of tables are dropped
// from all levels after each query. More than the distinct lines of a query only where it needs more of them
// than a set holds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "edgewise/measure/cache/cache_machine.hpp"
#include "edgewise/measure/cache/trace.hpp"

namespace edgewise::measure {

class ColdCaches final : public TraceListener {
  public:
    explicit ColdCaches(std::span<const CacheMachine> machines);

    void on_query_start(QueryStart start) override { start_ = start; }
    void on_access(const TracedAccess& access) override;
    void on_query_end(bool counts) override;

    /// Of a machine's cache levels, summed over queries.
    [[nodiscard]] const ByStart<std::vector<std::uint64_t>>& misses(std::size_t machine) const {
        return machines_[machine].misses;
    }

  private:
    struct Cold {
        CacheModel model;
        ByStart<std::vector<std::uint64_t>> misses;
        std::vector<std::uint64_t> booked;  ///< misses of the model up to the last query's end
        std::vector<std::uint64_t> lines;   ///< brought in by the query at hand
    };

    std::vector<Cold> machines_;
    std::optional<QueryStart> start_;
};

}  // namespace edgewise::measure
