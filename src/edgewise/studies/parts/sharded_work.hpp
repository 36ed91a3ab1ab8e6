// SPDX-License-Identifier: MIT
//
// One shard of a sweep: of its comparisons, of the hard families, and of the other runs of its plan.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "edgewise/studies/stability.hpp"
#include "edgewise/sweep/shard.hpp"
#include "edgewise/sweep/work.hpp"

namespace edgewise::studies {

/// Names of runs, also used for a store's seconds (store::took_key).
inline constexpr const char *paging_unit = "paging", *thrash_unit = "thrash", *effort_unit = "effort",
                            *fields_unit = "fields";
[[nodiscard]] std::string stability_unit(const std::string& family);

/// Keeps only the shard's part of the work. seconds: of an earlier run, or none.
void keep_shard(sweep::SweepWork& work, const sweep::Shard& shard,
                const std::map<std::string, double>& seconds);

/// Keeps only the shard's families of a stability run; returns false if it has none.
[[nodiscard]] bool keep_shard(StabilityPlan& plan, const sweep::Shard& shard,
                              const std::map<std::string, double>& seconds);

/// Returns the seconds that a store's runs took, by unit.
[[nodiscard]] std::map<std::string, double> seconds_in(const std::string& store);

}  // namespace edgewise::studies
