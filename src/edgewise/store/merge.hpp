// SPDX-License-Identifier: MIT
//
// Several stores as one: the parts of a campaign that was dealt over processes or machines. Cells are copied
// with their figures and rounds, each machine's under a build of its own. A cell that two stores have must be
// the same in every figure that repeats exactly; the one with more rounds is kept. Merging what was merged
// changes nothing.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace edgewise::store {

struct MergedBuild {
    std::string id, git_revision;
    std::size_t cells = 0;
};

struct MergeSummary {
    std::size_t stores = 0, cells = 0;
    std::size_t twice = 0;             ///< cells that several stores had
    std::vector<MergedBuild> builds;   ///< with the most cells first
    std::vector<std::string> missing;  ///< a line for each part that is not there or not complete
};

/// Writes the merged store to `out`: to a file beside it, which takes its name when it is whole, so that an
/// end at any moment leaves what was there before. Throws std::runtime_error, one line, where a store cannot
/// be read, where `out` is there and no merged store, where two stores disagree, and, unless `mixed`, where
/// they are of several plans, seeds or revisions.
[[nodiscard]] MergeSummary merge_stores(const std::vector<std::string>& stores, const std::string& out,
                                        bool mixed);

}  // namespace edgewise::store
