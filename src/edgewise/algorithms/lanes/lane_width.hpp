// SPDX-License-Identifier: MIT
//
// The loop over lanes, compiled for each width of register, and chosen at run time: an installed library
// carries no machine flags.
#pragma once

#include <cstdint>

#include "edgewise/algorithms/lanes/lane_source.hpp"
#include "edgewise/algorithms/query_options.hpp"

namespace edgewise {

/// Bits of a register; none: one query after the other.
enum class LaneWidth : std::uint16_t { none = 0, bits_128 = 128, bits_256 = 256 };

/// The best width on this processor: AVX2's, or none. Measured on a Zen 4, time over that of single queries,
/// cold, bodies of 8 vertices, f64 and f32: 128 bits 1.8 and 0.7 (SSE2 cannot compare whole numbers of 64
/// bits), 256 bits 0.65 and 0.45. Registers of 512 bits took 0.8 of that where all of the program was
/// compiled for them, and twice that in a library that was not. Only x86 was measured.
[[nodiscard]] LaneWidth best_lanes();

/// Answers all of the source's queries with GJK, side by side, at a width that the processor has.
void run_lanes(LaneSource<double>& source, const QueryOptions& options, LaneWidth width);
void run_lanes(LaneSource<float>& source, const QueryOptions& options, LaneWidth width);

}  // namespace edgewise
