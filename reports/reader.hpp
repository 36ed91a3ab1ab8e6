// SPDX-License-Identifier: MIT
//
// Reads a store into plain structs. The report knows the sweep through the store's schema only
// (edgewise/store/schema.hpp): no type of the measuring program appears here. The store is opened read-only.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace edgewise::reports {

/// One stored number, or the reason why there is none.
struct StoredFigure {
    std::string probe, name;
    std::optional<double> value;  ///< null: not measured
    std::string unit, reason, remedy;
};

/// Ratios of one round: nanoseconds a query of the cell over those of the baseline timed beside it.
struct StoredRound {
    std::optional<double> separated_ratio, overlapping_ratio;  ///< null: no such query in this round
    std::optional<double> all_ratio = {};                      ///< both kinds together, as they come
};

struct ReportCell {
    std::string hash, scene, scene_parameters;
    std::string scene_label;  ///< scene, and the parameters that tell it from its namesakes
    std::string shape, shape_source, algorithm, layout, precision, table;
    std::int64_t vertices = 0, edges = 0, faces = 0, queries = 0;
    std::uint64_t seed = 0;
    std::string status, reason;
    std::string
        axes;  ///< further axes; they are part of `table` too, since their cells stand beside the plain
    std::vector<StoredFigure> figures;  ///< in order of probe and name
    std::vector<StoredRound> rounds;    ///< in order of number

    [[nodiscard]] bool verified() const { return status == "verified"; }
    /// The stored figure; where none is stored, a null one whose reason says so.
    [[nodiscard]] StoredFigure figure(const std::string& probe, const std::string& name) const;
};

struct ReportBuild {
    std::string id, git_revision, compiler, flags, build_type, machine_json;
};

struct ReportData {
    std::vector<std::pair<std::string, std::string>> meta;  ///< in order of key
    ReportBuild build;                                      ///< whose cells these are
    std::vector<std::string> other_builds;                  ///< ids of builds in the store that are not shown
    std::vector<ReportCell> cells;  ///< by scene, parameters, vertices, shape, algorithm, table type, hash
    std::vector<ReportCell> from_files;  ///< cells of scenes that are files, which vary a number; likewise
    std::vector<ReportCell>
        stability;                   ///< rows of the stability run: the shape is the family; order likewise
    std::vector<ReportCell> paging;  ///< rows of the paging run; likewise
    std::vector<std::pair<std::string, std::string>> scene_files;  ///< name and text (JSON), by name

    [[nodiscard]] std::size_t cell_count() const { return cells.size() + from_files.size(); }
    [[nodiscard]] std::size_t count(const std::string& status) const;  ///< of all cells
    [[nodiscard]] bool any_failed() const;                             ///< cell or stability row
};

/// Reads one build; an empty `build` means the latest: the one that the key `build` of `meta` names, else the
/// one with the most cells (ties: the smallest id). Throws std::runtime_error with one line: what, where,
/// what to do.
[[nodiscard]] ReportData read_report(const std::string& store, const std::string& build = {});

}  // namespace edgewise::reports
