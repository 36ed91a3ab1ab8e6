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
    std::vector<std::string> probes;  ///< whose figures, in order
    std::size_t figures = 0;
};

struct Gaps {
    std::size_t measured = 0, missing = 0;
    std::vector<Gap> gaps;  ///< the most figures first

    [[nodiscard]] std::size_t figures() const { return measured + missing; }
};

/// Of every cell and row of the store. Reasons that differ in numbers alone are one, with # for each number.
[[nodiscard]] Gaps gaps_of(const ReportData& data);

}  // namespace edgewise::reports
