// SPDX-License-Identifier: MIT
//
// The interface of a probe: it is given a cell, measures, and names the figures it makes of that. A probe is
// one file and one line in probes/CMakeLists.txt.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "edgewise/bench/probed_cell.hpp"
#include "edgewise/measure/figure.hpp"

namespace edgewise::bench {

struct Findings {
    std::vector<measure::Figure> figures;
    /// Of a pass over the queries that the probe made: the cell fails if it gave other answers.
    std::optional<PassSum> passed = {};
};

struct Probe {
    std::string_view name, summary;
    /// Every figure is a number, or none with a reason and a remedy.
    Findings (*measure)(const ProbedCell& cell);
    /// Whether it may measure while others do: nothing of it is a time. To be measured first.
    bool beside_others;
};

/// The probe of a type with a summary, measure and, if it is true, beside_others.
template <class Measuring>
constexpr Probe probe_of(std::string_view name) {
    constexpr bool beside_others = requires { Measuring::beside_others; };
    return {name, Measuring::summary, Measuring::measure, beside_others};
}

/// Every probe of this program, in the order of the manifest probes/CMakeLists.txt.
[[nodiscard]] std::span<const Probe> registered_probes();

}  // namespace edgewise::bench
