// SPDX-License-Identifier: MIT
//
// The whole of a test that holds a lock: `tree_lock > tree.lock.json` writes it, `tree_lock --check
// tree.lock.json` compares, as `edgewise lock` does for the tables of Edgewise.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "edgewise/measure/lock/layout_lock.hpp"

namespace edgewise::measure {

/// Exit codes: 0 written, or the lock holds; 1 it does not, each difference is a line on stdout; 2 there is
/// nothing to compare (one line on stderr). `of` as in lock_of. Other arguments: how it is used, and 2.
[[nodiscard]] int lock_program(int argc, const char* const* argv, const Expected<LayoutFacts>& facts,
                               std::vector<std::pair<std::string, std::string>> of = {});

/// The same comparison: prints the differences, or that there are none; returns 0 or 1.
[[nodiscard]] int report_differences(const std::vector<LockDifference>& found, const std::string& file);

}  // namespace edgewise::measure
