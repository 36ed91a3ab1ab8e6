// SPDX-License-Identifier: MIT
//
// A layout's lock: its deterministic figures in a file that is kept under version control next to the layout,
// so that a change of the layout shows as a change of that file. Nothing in it depends on addresses, on a
// clock or on the machine that made it. A lock is a record of kind "lock" (record/record.hpp) without slack.
#pragma once

#include "edgewise/measure/lock/layout_facts.hpp"
#include "edgewise/measure/record/record.hpp"

namespace edgewise::measure {

/// Figures: bytes by component and in all; per population queries, lines per query, the knee in bytes, and
/// misses per query by machine and level, TLBs among them, and of the first level where queries find all
/// caches empty. `of`: whatever must be the same for figures to be comparable.
[[nodiscard]] FigureRecord lock_of(const LayoutFacts& facts, Conditions of = {});

/// The whole of a test that holds a lock: `tree_lock > tree.lock.json` writes it, `tree_lock --check
/// tree.lock.json` compares, as `edgewise lock` does for the tables of Edgewise. Exit codes: 0 written, or
/// the lock holds; 1 it does not, each difference is a line on stdout; 2 there is nothing to compare, or
/// other arguments (one line on stderr).
[[nodiscard]] int lock_program(int argc, const char* const* argv, const Expected<LayoutFacts>& facts,
                               Conditions of = {});

}  // namespace edgewise::measure
