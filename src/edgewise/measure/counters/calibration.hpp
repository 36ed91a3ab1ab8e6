// SPDX-License-Identifier: MIT
//
// The cache model against this machine's counters: random chases through memory of half to eight times each
// level's size, misses per load, modelled and counted, and the ratio. Where nothing can be counted, that is
// said; the time a load takes shows the levels all the same.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "edgewise/measure/cache/cache_machine.hpp"
#include "edgewise/measure/machine/cpu.hpp"

namespace edgewise::measure {

struct CalibrationRow {
    std::string level;  ///< the level under test
    double times = 0;   ///< memory divided by the level's size
    std::uint64_t bytes = 0;
    double modelled = 0;            ///< misses of the level, per load
    std::optional<double> counted;  ///< the same by the processor
    std::string event, reason;      ///< what was counted, and why it was not
    double ns = 0;                  ///< per load
};

struct CalibrationOptions {
    std::vector<double> times = {0.5, 1, 2, 8};
    std::uint64_t loads = 1'000'000;  ///< per pass
    std::uint64_t most_bytes = std::uint64_t{1} << 31;
};

/// Calibrates the machine's levels in turn; leaves out memory beyond most_bytes. `cpu`: this machine's.
[[nodiscard]] std::vector<CalibrationRow> calibrate_model(const CacheMachine& machine, const Cpu& cpu,
                                                          const CalibrationOptions& options = {});

}  // namespace edgewise::measure
