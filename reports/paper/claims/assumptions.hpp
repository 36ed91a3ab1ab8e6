// SPDX-License-Identifier: MIT
//
// What the paper leaves open and we had to assume, each varied alone around figures 6 to 8 in the middle of
// their common axis, 4 rad/s (the tolerance, which it names, at 1 rad/s): what the findings on V-Clip against
// GJK and on 386 vertices against 38 are under each value.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "edgewise/reports/paper/claims/claim_rules.hpp"
#include "edgewise/reports/reader.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

struct AssumedValue {
    std::string assumption;  ///< "time step"
    std::string value;       ///< "1/60 s"
    bool ours = false;       ///< the value that the paper's scenes have
    /// Time per query over GJK's, by size: angular_sizes (claim_cells.hpp).
    std::array<Evidence, 3> vclip_over_gjk;
    Evidence vclip_growth, gjk_growth;  ///< time at 386 vertices over that at 38
};

/// Returns all values in a fixed order; a value without stored cells gives a reason.
[[nodiscard]] std::vector<AssumedValue> assumed_values(const ReportData& data);

/// One row per value, those of one assumption side by side; no rows where none of the scenes is stored.
[[nodiscard]] TextGrid assumptions_grid(const ReportData& data);

/// Says which findings hold under every value, and under which values the rest hold; empty if nothing is
/// stored.
[[nodiscard]] std::string assumptions_paragraph(const ReportData& data);

}  // namespace edgewise::reports
