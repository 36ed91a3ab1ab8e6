// SPDX-License-Identifier: MIT
//
// A machine to model: its caches and TLBs and how long each takes to answer. From a small JSON file; those
// that come with Edgewise are in machines/, one per file, with a source for every number. A number that its
// source does not prove is named in `unverified`, and what is computed of it is marked.
//
//     {"what": "...", "clock_mhz": 733, "line_bytes": 32,
//      "levels": [{"name": "L1D", "bytes": 16384, "ways": 4, "latency_cycles": 3, "source": "..."}, ...],
//      "memory": {"latency_cycles": 121, "source": "..."},
//      "tlb": {"page_bytes": 4096, "levels": [{"name": "dTLB", "entries": 64, "ways": 4, "source": "..."}]}}
//
// Levels may add "inclusion" (non_inclusive, inclusive, exclusive), "replacement" (lru, tree_plru, random)
// and "unverified" (a list of the level's own fields). Needed are "line_bytes" and of each level name, bytes
// and ways; bytes may be a size, as "48K". Other members are refused. Without clock, latencies or memory no
// time is computed of misses; "tlb" may be left out.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/measure/cache/cache_model.hpp"

namespace edgewise::measure {

/// The source of a level's numbers.
struct LevelOrigin {
    double latency_cycles = 0;  ///< to an answer from here; 0 for TLBs
    std::string source;
    std::vector<std::string> unverified;  ///< fields that the source does not prove

    [[nodiscard]] bool proves(std::string_view field) const;
};

struct CacheMachine {
    std::string name, what;
    double clock_mhz = 0;  ///< 0: not known
    CacheGeometry caches;
    std::vector<LevelOrigin> origins;  ///< of each cache level
    LevelOrigin memory;
    CacheGeometry tlbs;  ///< lines are pages; without levels if nothing is known
    std::vector<LevelOrigin> tlb_origins;

    /// Returns the modelled time of accesses beyond the first level: every access waits for the level that
    /// answers it, and no accesses overlap. `counts`: one for each level of `caches`.
    [[nodiscard]] double memory_ns(std::span<const LevelCounts> counts) const;
    /// Returns true if the clock is known, and every level and memory have a latency.
    [[nodiscard]] bool latencies_known() const;
    /// Returns true if every latency in memory_ns is proved.
    [[nodiscard]] bool latencies_proved() const;
};

/// Throws std::runtime_error with one line: file, field, what is wanted.
[[nodiscard]] CacheMachine parse_cache_machine(const std::string& json, const std::string& name);

/// Returns the machine as the JSON that parse_cache_machine reads, on one line.
[[nodiscard]] std::string cache_machine_json(const CacheMachine& machine);

/// Returns the machines that come with Edgewise, oldest first.
[[nodiscard]] const std::vector<CacheMachine>& cache_machines();

}  // namespace edgewise::measure
