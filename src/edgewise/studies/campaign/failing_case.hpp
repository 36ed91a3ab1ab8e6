// SPDX-License-Identifier: MIT
//
// A wrong answer as a line of a case file: what the corpus takes, and `edgewise query` answers.
#pragma once

#include <string>

#include "edgewise/scene/case_file.hpp"
#include "edgewise/studies/campaign/block_run.hpp"

namespace edgewise::studies::campaign {

/// The pair as its source made it.
[[nodiscard]] scene::Case case_of(const PairSource& source, std::uint64_t pair);

/// Why the cell's answer to the case is wrong; empty: it is right, or there is none.
[[nodiscard]] std::string what_is_wrong(const scene::Case& of, const Cell& cell);

/// The failing pair, minimised, as a line that says what was wrong with which answer to which pair.
[[nodiscard]] std::string failing_line(const PairSource& source, const Failure& failure, const Cell& cell);

}  // namespace edgewise::studies::campaign
