// SPDX-License-Identifier: MIT
//
// One record of figures: of a layout (a lock), of a build's speed (a baseline), of a machine or of a store.
// A later record is compared with it row by row (comparison.hpp). As JSON:
//
//     {"edgewise_record": "speed",
//      "of": {"queries": "1000"},
//      "with": {"compiler": "GNU 12.2"},
//      "slack": 0.1,
//      "limits": {"bytes.*": {"soft": 0.02, "hard": 16000}},
//      "figures": {"bytes.nodes.point": 12000},
//      "cells": {"gjk lean_f64 cold cube8": {"time over reference": [0.51, 0.52, 0.55]}}}
//
// Every member but the first is optional. Locks in the form that version 0.1 wrote are read too.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgewise::measure {

/// One figure of one cell.
struct RecordRow {
    std::string cell =
        {};  ///< algorithm, table type, scene and shape; empty where a record has one cell alone
    std::string figure = {};  ///< "bytes.topology"
    double value = 0;
    double low = value, high = value;  ///< the ends of its 95 % interval
    bool has_interval = false;         ///< else it is exact: every run gives the same value
    std::string text = {};             ///< a word to compare instead of numbers; empty: numbers
    std::string note = {};             ///< shown next to a difference, not compared and not kept in files
};

/// A bound of the figures whose names match a pattern such as "misses_per_query.zen5.*" (man 7 glob). Of
/// several limits for one figure the first counts, for soft and hard separately.
struct Limit {
    std::string figures = {};
    std::optional<double> soft = {};  ///< the part of itself by which a figure may grow before it is worse
    std::optional<double> hard = {};  ///< the value above which a figure is over the limit
};

using Conditions = std::vector<std::pair<std::string, std::string>>;

struct FigureRecord {
    std::string kind;  ///< "lock", "speed", "machine"
    Conditions of;     ///< what was measured; figures of something else are not comparable
    Conditions with;   ///< machine and build: where they differ, they may be the cause of other differences
    /// A figure with an interval may grow by this part of itself, and an exact figure may shrink. No value:
    /// every figure must stay the same.
    std::optional<double> slack;
    std::vector<RecordRow> rows;
    /// A figure with a limit may also shrink; with only a hard one it may grow up to that.
    std::vector<Limit> limits = {};

    /// Returns the bound that counts for a figure; null if no limit has one.
    [[nodiscard]] std::optional<double> bound_of(const std::string& figure,
                                                 std::optional<double> Limit::*bound) const;
    /// A member of `of`; throws std::runtime_error that names the file when it is not there.
    [[nodiscard]] const std::string& condition(std::string_view name, const std::string& file) const;
};

/// Ends with a newline.
[[nodiscard]] std::string to_json(const FigureRecord& record);

/// Throws std::runtime_error with one line: file, member, what it needs; and that it needs a record of this
/// kind, where one is given.
[[nodiscard]] FigureRecord parse_record(const std::string& json, const std::string& file,
                                        std::string_view kind = {});
/// Reads a file; throws as parse_record does.
[[nodiscard]] FigureRecord read_record(const std::string& file, std::string_view kind = {});

}  // namespace edgewise::measure
