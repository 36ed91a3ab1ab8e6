// SPDX-License-Identifier: MIT
//
// Merges stores: the shards of a sweep that several processes or machines ran. Cells are copied with their
// figures and rounds; each machine has a build of its own. If two stores have the same cell, every figure
// that repeats exactly must be equal, and the cell with more rounds is kept. Merging a merged store again
// changes nothing.
#pragma once

#include <cstddef>
#include <map>
#include <set>
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

/// Writes the merged store to a file next to `out`, which is renamed to `out` when it is complete: if the
/// program is killed, the old file is unchanged. Throws std::runtime_error with one line if a store cannot be
/// read, if `out` exists and is not a merged store, if two stores disagree, and, unless `mixed`, if they are
/// of several plans, seeds or revisions.
[[nodiscard]] MergeSummary merge_stores(const std::vector<std::string>& stores, const std::string& out,
                                        bool mixed);

/// The description of a store that is to be merged: its path, meta and revisions.
struct MergeSource {
    std::string path;
    std::map<std::string, std::string> meta;
    std::set<std::string> revisions;  ///< of builds that have cells

    /// Throws std::runtime_error if the file is no store of this version.
    explicit MergeSource(const std::string& path);

    [[nodiscard]] std::string value(const std::string& key) const;
};

}  // namespace edgewise::store
