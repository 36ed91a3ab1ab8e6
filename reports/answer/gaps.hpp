// SPDX-License-Identifier: MIT
//
// How many of a store's figures were measured, and why the others were not.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

struct Gap {
    std::string reason, remedy;
    std::vector<std::string> probes;  ///< the probes of these figures, in order
    std::size_t figures = 0;
};

struct Gaps {
    std::size_t measured = 0, missing = 0;
    std::vector<Gap> gaps;  ///< the most figures first

    [[nodiscard]] std::size_t figures() const { return measured + missing; }
};

/// Counts the gaps of a store's cells and rows. Reasons that differ in numbers only are one, each number a #.
[[nodiscard]] Gaps gaps_of(const ReportData& data);

}  // namespace edgewise::reports
