// SPDX-License-Identifier: MIT
//
// Callgrind, an independent simulator of two levels of caches and of a branch predictor: how it is called
// with a given geometry, and what its output says. Its predictor is no processor's: two-bit counters by
// address and recent history, and the last target of an indirect jump.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "edgewise/measure/cache/cache_machine.hpp"
#include "edgewise/measure/expected.hpp"

namespace edgewise::measure {

struct CallgrindCounts {
    double instructions = 0, accesses = 0, d1_misses = 0, ll_misses = 0;
    /// Modelled mispredictions of conditional and indirect branches; no value if no branches were simulated.
    std::optional<double> mispredictions = {};
};

/// The machine's first two levels as Callgrind simulates them: LRU, an access across lines as one. Unknown:
/// it has one level only, or its sets are no power of two.
[[nodiscard]] Expected<CacheGeometry> callgrind_geometry(const CacheMachine& machine);

/// The command line; the program collects where it says so (callgrind_region.hpp).
[[nodiscard]] std::vector<std::string> callgrind_command(const CacheGeometry& geometry,
                                                         const std::filesystem::path& output,
                                                         const std::vector<std::string>& program);

/// From the text of its output file.
[[nodiscard]] Expected<CallgrindCounts> parse_callgrind(const std::string& text);

}  // namespace edgewise::measure
