// SPDX-License-Identifier: MIT
//
// Whether a run is slower than its baseline. Pure: two records in, a report out.
//
// An entry is slower where its ratio's whole interval lies above the baseline's ratio times (1 + slack):
// noise widens the interval, and what the interval holds is no slowdown. The baseline's own interval decides
// nothing; its median is what later runs are held to. Of a thousand intervals of 95 % a few lie beside the
// truth: what seems slower is measured again, on new tables, and fails only if every measurement says so.
#pragma once

#include <string>
#include <vector>

#include "edgewise/studies/gate/entry.hpp"

namespace edgewise::studies {

enum class GateVerdict : std::uint8_t {
    slower,  ///< fails
    same,
    faster,  ///< its whole interval lies below the baseline over (1 + slack): worth a new baseline
};

[[nodiscard]] const char* to_string(GateVerdict verdict);

struct GateRow {
    GateEntry now;
    GateRatio baseline;
    GateVerdict verdict = GateVerdict::same;

    [[nodiscard]] double change() const { return now.ratio.value / baseline.value; }
    /// Change that even the lower end of the interval shows.
    [[nodiscard]] double least_change() const { return now.ratio.low / baseline.value; }
};

struct GateReport {
    std::vector<GateRow> rows;         ///< worst first: by least_change
    std::vector<std::string> missing;  ///< entries of the baseline that were not measured
    std::vector<std::string> added;    ///< measured entries that the baseline lacks
    std::vector<std::string> notes;    ///< what makes the comparison worth less, one line each

    [[nodiscard]] std::size_t count(GateVerdict verdict) const;
    /// Nothing is slower, and something was compared at all.
    [[nodiscard]] bool passed() const { return !rows.empty() && count(GateVerdict::slower) == 0; }
};

/// `slack` (not negative): in place of the baseline's.
[[nodiscard]] GateReport compare_gate(const GateRecord& baseline, const GateRecord& now, double slack);

/// Groups (gate_group_name) with an entry that seems slower, each once, in the report's order.
[[nodiscard]] std::vector<std::string> suspect_groups(const GateReport& report);

/// Entries that seem slower in `report` take the ratio of `again` where that one's interval begins lower;
/// all others keep theirs, so that a second look can acquit and never accuse.
void look_again(GateRecord& now, const GateReport& report, const GateRecord& again);

}  // namespace edgewise::studies
