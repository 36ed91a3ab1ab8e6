// SPDX-License-Identifier: MIT
//
// Writes a wrong answer as a line of a case file, which the corpus takes and `edgewise query` answers.
#pragma once

#include <string>

#include "edgewise/scene/case_file.hpp"
#include "edgewise/studies/campaign/block_run.hpp"

namespace edgewise::studies::campaign {

/// Returns the pair as its source made it.
[[nodiscard]] scene::Case case_of(const PairSource& source, std::uint64_t pair);

/// Returns why the cell's answer to the case is wrong; empty if it is right or there is none.
[[nodiscard]] std::string what_is_wrong(const scene::Case& of, const Cell& cell);

/// Minimises the failing pair; returns a line that says which answer to which pair was wrong, and how.
[[nodiscard]] std::string failing_line(const PairSource& source, const Failure& failure, const Cell& cell);

}  // namespace edgewise::studies::campaign
