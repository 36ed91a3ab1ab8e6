// SPDX-License-Identifier: MIT
//
// How near the progress of a sweep came to the truth: what each of its pieces was expected to take, and took,
// kept in the store in the order in which they ran. A piece is a step of a group, or a run after the sweep.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace edgewise::sweep {

struct ProgressPiece {
    std::string what;
    double expected = 0;  ///< in any unit, the same for all
    double took = 0;      ///< s
};

/// Key of a store's meta for the pieces of one group or run: the place in order, then a name.
[[nodiscard]] std::string progress_key(std::size_t place, const std::string& name);

/// Their value: expected and taken, step by step.
[[nodiscard]] std::string progress_value(std::span<const ProgressPiece> pieces);

/// All pieces that a store's meta holds, in order; a value that cannot be read is left out.
[[nodiscard]] std::vector<ProgressPiece> progress_pieces(
    std::span<const std::pair<std::string, std::string>> meta);

/// The share of the work that was shown as done, beside the share of the time that was over then.
struct ProgressDeviation {
    double at = 0;        ///< share of the time
    double relative = 0;  ///< shown share / true share - 1
};

/// The largest from this share of the time on, at the ends of the pieces and at that share itself; between
/// them both shares are straight lines. Nothing where no piece took any time.
[[nodiscard]] ProgressDeviation worst_deviation(std::span<const ProgressPiece> pieces, double from);

}  // namespace edgewise::sweep
