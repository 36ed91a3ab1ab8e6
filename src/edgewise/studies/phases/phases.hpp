// SPDX-License-Identifier: MIT
//
// The phases of a query, in the words of GJK (Gilbert, Johnson, Keerthi 1988; Cameron 1997) and V-Clip
// (Mirtich, TR-97-05), and which functions of the source belong to which. Arithmetic and helpers belong to
// the function that they are inlined into: a dot product in a climb is the climb's, in a state the state's.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/measure/process/callgrind.hpp"

namespace edgewise::studies {

/// Phase of code that no rule knows: our source files that are not in the table, or without line tables.
inline constexpr std::string_view other_phase = "other";

/// How often code runs.
enum class Recurrence { once, step };  ///< per query, or per V-Clip state or GJK iteration

/// Phase and recurrence by the frames of one instruction; nothing if they leave it to the caller.
struct PhaseOfFrames {
    std::optional<std::string_view> phase;
    std::optional<Recurrence> recurrence;
    std::string place;  ///< of `other`: the file that is not in the table, or a function without one
};

/// Searches from the innermost frame outwards for the first with a phase, and for the first that is known
/// to run once or each step.
[[nodiscard]] PhaseOfFrames phase_of(const std::vector<measure::InlineFrame>& frames);

}  // namespace edgewise::studies
