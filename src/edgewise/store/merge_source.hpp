// SPDX-License-Identifier: MIT
//
// One store among those to be merged: what it says of itself, and whether they belong together.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "edgewise/store/sqlite.hpp"

namespace edgewise::store {

/// Part `index` of `count`, from "3/8"; nothing for other texts.
struct PartOf {
    std::size_t index = 0, count = 1;
};
[[nodiscard]] std::optional<PartOf> part_from(const std::string& text);

struct MergeSource {
    std::string path;
    std::map<std::string, std::string> meta;
    std::set<std::string> revisions;  ///< of builds that have cells

    /// Throws where it is no store of this version.
    explicit MergeSource(const std::string& path);

    [[nodiscard]] std::string value(const std::string& key) const;
    [[nodiscard]] std::optional<PartOf> part() const;
    [[nodiscard]] bool is_complete() const;
};

/// Throws std::runtime_error that names the files where they are of several plans, seeds or revisions.
void check_same_campaign(const std::vector<MergeSource>& sources);

/// Throws std::runtime_error that names both where two have scene files of one name that differ.
void check_scene_files(const std::vector<MergeSource>& sources);

/// A line for each part of the campaign that no store holds or that was stopped before its end. Throws where
/// they are parts of differently many.
[[nodiscard]] std::vector<std::string> missing_parts(const std::vector<MergeSource>& sources);

}  // namespace edgewise::store
