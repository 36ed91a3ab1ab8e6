// SPDX-License-Identifier: MIT
//
// The interface of a probe: it is given a cell, measures, and names the figures it makes of that. A probe is
// one file and one line in probes/CMakeLists.txt.
#pragma once

#include <memory>
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

class Probe {
  public:
    Probe() = default;
    Probe(const Probe&) = delete;
    Probe& operator=(const Probe&) = delete;
    virtual ~Probe() = default;

    [[nodiscard]] virtual std::string_view name() const = 0;
    [[nodiscard]] virtual std::string_view summary() const = 0;

    /// Whether it may measure while others do: nothing of it is a time. To be measured first.
    [[nodiscard]] virtual bool beside_others() const { return false; }

    /// Every figure is a number, or none with a reason and a remedy.
    [[nodiscard]] virtual Findings measure(const ProbedCell& cell) const = 0;
};

/// Every probe of this program, in the order of the manifest probes/CMakeLists.txt.
[[nodiscard]] std::span<const std::unique_ptr<Probe>> registered_probes();

}  // namespace edgewise::bench
