// SPDX-License-Identifier: MIT
//
// The further axes of a cell, beyond scene, shape, algorithm and table type: the tolerances of a query, how
// it is solved, and how tables are placed. Plans, the command line, the store and the report use one text
// form: "gap_tolerance=1e-06", several joined by '+'. A sweep varies one axis at a time around the plain
// cell; it does not measure their product.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "edgewise/bench/runner_options.hpp"

namespace edgewise::sweep {

struct Axes : bench::RunnerOptions {
    bool starts_cold = false;    ///< no query uses the last answer of its pair
    bool default_build = false;  ///< the query loop as applications compile it (bench::has_default_build)

    /// Returns the settings that differ from the plain cell, in a fixed order; empty for the plain cell.
    /// needs=nearer always has its margin in the text, because all its figures depend on the margin.
    [[nodiscard]] std::string text() const;

    /// Returns true if a cell of this algorithm differs from the plain cell.
    [[nodiscard]] bool concerns(std::string_view algorithm) const;
};

/// Throws std::invalid_argument: what, where, what to do; for an unknown axis the text lists the known axes.
[[nodiscard]] Axes parse_axes(std::string_view text);

/// Name, range and meaning of each axis, for help and lists.
struct AxisInfo {
    std::string_view name, values, summary;
};
[[nodiscard]] const std::vector<AxisInfo>& axes_known();

}  // namespace edgewise::sweep
