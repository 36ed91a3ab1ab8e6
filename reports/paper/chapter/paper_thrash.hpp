// SPDX-License-Identifier: MIT
//
// The part of the chapter on the thrash at 386 vertices: what the paper saw in its figure 8 and explained in
// two ways. The answer is computed from the store, by rules (thrash_evidence.hpp).
#pragma once

#include <string>

#include "edgewise/reports/reader.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

/// Cache, paging or both; from what size, speed, number of bodies and memory on; what each layout does to it;
/// and which sentence of the paper holds. What the store lacks is said to be missing, and why.
[[nodiscard]] std::string thrash_paragraph(const ReportData& data);
/// Its sentence on the machine that measured: V-Clip's time at 386 vertices over that at 38, at the fastest
/// rotation, with a table for every body and with one for all; GJK's beside it.
[[nodiscard]] std::string thrash_here(const ReportData& data);
/// What each layout and sharing does to it at 386 vertices: knees, misses and memory time.
[[nodiscard]] TextGrid thrash_grid(const ReportData& data);
/// Every limit of the paging run: page faults measured and predicted.
[[nodiscard]] TextGrid paging_grid(const ReportData& data);

}  // namespace edgewise::reports
