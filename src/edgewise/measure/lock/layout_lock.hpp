// SPDX-License-Identifier: MIT
//
// A layout's lock: its deterministic figures in a file that is kept under version control beside the layout,
// so that a change of the layout shows as a change of that file. Nothing in it depends on addresses, on a
// clock or on the machine that made it. The form:
//
//     {"edgewise_lock": 1, "of": {"points": "1000"},
//      "figures": {"bytes.nodes.point": 12000, "lines_per_query.cold": 14.25,
//                  "misses_per_query.zen5.L1D.cold": 0.5, ...}}
//
// `of` says what was measured: whatever must be the same for figures to be comparable.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "edgewise/measure/lock/layout_facts.hpp"

namespace edgewise::measure {

struct LayoutLock {
    std::vector<std::pair<std::string, std::string>> of;
    std::vector<std::pair<std::string, double>> figures;

    /// Of `of`; throws std::runtime_error that names the file when it is not there.
    [[nodiscard]] const std::string& condition(std::string_view name, const std::string& file) const;
};

/// Figures: bytes by component and in all; per population queries, lines per query, the knee in bytes, and
/// misses per query by machine and level, TLBs among them, and of the first level where queries find all
/// caches empty.
[[nodiscard]] LayoutLock lock_of(const LayoutFacts& facts,
                                 std::vector<std::pair<std::string, std::string>> of = {});

/// Ends with a newline.
[[nodiscard]] std::string to_json(const LayoutLock& lock);

/// Throws std::runtime_error with one line: file, field, what is wanted.
[[nodiscard]] LayoutLock parse_lock(const std::string& json, const std::string& file);
/// From a file; throws as parse_lock does.
[[nodiscard]] LayoutLock read_lock(const std::string& file);

/// A member whose value changed, came or went.
struct LockDifference {
    std::string member, was, is;  ///< "nothing" where it is not there
};

/// Numbers are compared exactly.
[[nodiscard]] std::vector<LockDifference> differences(const LayoutLock& was, const LayoutLock& is);

/// One line.
[[nodiscard]] std::string to_text(const LockDifference& difference);

}  // namespace edgewise::measure
