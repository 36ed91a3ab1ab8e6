// SPDX-License-Identifier: MIT
//
// A trace from elsewhere through the caches of several machines at once, and through reuse distances. Sets
// are found by the addresses as the file has them; caches are empty at its beginning. It knows no queries, so
// the trace as a whole is what the knee is of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "edgewise/measure/cache/cache_machine.hpp"
#include "edgewise/measure/cache/reuse_distance.hpp"
#include "edgewise/measure/traces/trace_file.hpp"

namespace edgewise::measure {

class TraceCaches {
  public:
    /// One level, of caches or TLBs.
    struct Level {
        std::string name;
        LevelCounts counts;
    };

    explicit TraceCaches(std::span<const CacheMachine> machines);

    void access(const FileAccess& access);

    /// Of machine number `machine`: caches from the first level on, then TLBs.
    [[nodiscard]] std::vector<Level> levels(std::size_t machine) const;

    /// Of 64 bytes.
    [[nodiscard]] std::uint64_t distinct_lines() const { return reuse_.lines(); }
    /// The smallest fully associative cache, in bytes, that brings in again at most a tenth as many lines as
    /// the trace has distinct ones; 0: none is ever needed again.
    [[nodiscard]] std::uint64_t knee_bytes() const;
    /// Lines that fully associative caches of so many bytes bring in.
    [[nodiscard]] std::uint64_t misses(std::uint64_t bytes) const;

  private:
    std::vector<std::vector<CacheModel>> machines_;  ///< of each, caches and, where they are known, TLBs
    std::unordered_map<std::uint64_t, std::uint64_t> numbers_;  ///< of lines, as they first came
    std::uint64_t last_line_ = 0, last_number_ = 0;             ///< of the last access
    ReuseDistance reuse_;
};

}  // namespace edgewise::measure
