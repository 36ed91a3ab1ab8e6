// SPDX-License-Identifier: MIT
//
// What Callgrind counted of some passes, divided by phase (phases.hpp). Nothing is dropped: what no rule
// knows is `other`, so the phases add up to the run's total.
//
// A function that is called, not inlined, and whose frames leave a question open is answered by its calls:
// its phase is that of all who call it, where they agree; and it runs once or each step in the proportion of
// the instructions that its calls of either kind cost in the end.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/measure/process/callgrind_lines.hpp"

namespace edgewise::studies {

/// Arithmetic in functions that several phases call, and code of the C library.
inline constexpr std::string_view arithmetic_phase = "arithmetic, shared", library_phase = "C library";

struct PhaseCost {
    measure::InstructionCost cost;
    double in_steps = 0;  ///< of the instructions
};

struct PhaseCounts {
    std::map<std::string, PhaseCost> phases;
    std::map<std::string, std::uint64_t> others;  ///< instructions of `other`, by file or function
};

/// Addresses of what was counted in this object, each once.
[[nodiscard]] std::vector<std::uint64_t> addresses_in(const measure::CallgrindLines& lines,
                                                      const std::string& object);

/// `program`: the object that the frames are of; all others are libraries.
[[nodiscard]] PhaseCounts divide_by_phase(const measure::CallgrindLines& lines,
                                          const measure::InlineFrames& frames, const std::string& program);

/// Empty, or how the phases' sum differs from the run's own total.
[[nodiscard]] std::string check_sum(const PhaseCounts& counts, const measure::InstructionCost& total);

}  // namespace edgewise::studies
