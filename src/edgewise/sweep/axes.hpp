// SPDX-License-Identifier: MIT
//
// The further axes of a cell, beyond scene, shape, algorithm and table type: what a query may give away, how
// it is solved, and how tables are placed. As text, in plans, on the command line, in the store and in the
// report alike: "gap_tolerance=1e-06", several joined by '+'. A sweep takes them one at a time around the
// plain cell, not their product.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "edgewise/bench/runner_options.hpp"

namespace edgewise::sweep {

struct Axes : bench::RunnerOptions {
    bool starts_cold = false;  ///< every query as if its pair had not been asked before

    /// Canonical: what differs from the plain cell, in a fixed order; empty for the plain cell. needs=nearer
    /// always names its margin, which is a condition of all its figures.
    [[nodiscard]] std::string text() const;

    /// Whether a cell of this algorithm would differ from the plain one.
    [[nodiscard]] bool concerns(std::string_view algorithm) const;
};

/// Throws std::invalid_argument: what, where, what to do; an unknown axis gets the known ones.
[[nodiscard]] Axes parse_axes(std::string_view text);

/// Name, range and meaning of each axis, for help and lists.
struct AxisInfo {
    std::string_view name, values, summary;
};
[[nodiscard]] const std::vector<AxisInfo>& axes_known();

}  // namespace edgewise::sweep
