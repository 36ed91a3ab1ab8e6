// SPDX-License-Identifier: MIT
//
// What the paper claims (Levey, Peters and O'Sullivan, 2001), sentence by sentence where a sentence can be
// measured, with a verdict that a rule computes from the results store. Rules and their thresholds are
// in claims.json; nothing is judged by hand.
#pragma once

#include <string>
#include <vector>

#include "edgewise/measure/record/record.hpp"
#include "edgewise/reports/reader.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

/// "reproduced": every part of the evidence meets the rule with its whole interval. "consistent, not
/// identifiable": the same, where other causes than the paper's would meet it too. "not reproduced": some
/// part misses it with its whole interval. "depends on: time step": two readings of the paper differ.
/// "inconclusive": an interval straddles the rule. "not measured": some part is missing, and none refutes.
struct Claim {
    std::string id;         ///< "bytes_per_edge_double"
    std::string kind;       ///< "primary" finding, "mechanism" that explains one, or "background"
    std::string section;    ///< of the paper
    std::string claim;      ///< what it says, in our words
    std::string paper;      ///< its figure
    std::string ours = {};  ///< values, each with its 95 % interval in brackets where there is one
    std::string unit;       ///< of the values that bear no other; "1": a ratio or a share
    std::string verdict = {};
    std::string reason = {};      ///< of every verdict but "reproduced"
    std::string conditions = {};  ///< where the verdict holds: seeds, and the machine where times decide
    std::string not_identifiable = {};  ///< what else would meet the rule; empty: nothing that we know of
    std::string rule;                   ///< in words, with what is wanted of each part
    bool deterministic = false;  ///< the evidence depends on no time and on no kernel: same in every run
};

/// All claims: primary findings, then mechanisms, then background, each in the order of the paper's criteria;
/// the same ones for every store.
[[nodiscard]] std::vector<Claim> judge_claims(const ReportData& data);

/// Primary findings by verdict, by name: a number of claims would be no result, since they weigh differently.
[[nodiscard]] std::string claims_summary(const std::vector<Claim>& claims);

/// Returns the output of `edgewise report claims`. A claim that is not reproduced is a finding, not an error.
[[nodiscard]] std::string claims_text(const ReportData& data, bool json);

/// One verdict per claim, with its figures as a note: to be compared with another store's. Every difference
/// counts.
[[nodiscard]] measure::FigureRecord claims_record(const ReportData& data);

/// One row per claim.
[[nodiscard]] TextGrid claims_grid(const ReportData& data);

// Where a verdict holds. Counts hold wherever the same seeds are drawn; times hold on the machine that took
// them, and what its caches keep may decide them.

/// "for seed 1, on any machine"; where times decide also the processor, its caches from the second level on,
/// and the compiler: "for seed 1, on this machine: Intel Xeon, L2 2 MiB, L3 480 MiB; c++ 12.2".
[[nodiscard]] std::string claim_conditions(const ReportData& data, bool deterministic);

}  // namespace edgewise::reports
