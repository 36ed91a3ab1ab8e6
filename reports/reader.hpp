// SPDX-License-Identifier: MIT
//
// The contents of a store, sorted for showing: scenes have names for people, and the rows of other runs are
// separate.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "edgewise/store/rows.hpp"

namespace edgewise::reports {

/// `axes` are part of `table` here, because cells with axes are shown next to the plain ones.
struct ReportCell : store::StoredCell {
    std::string scene_label;  ///< what the scene is called (scene_label.hpp)

    /// The value of an axis; null where the cell has none of that name.
    [[nodiscard]] std::optional<std::string> axis(std::string_view name) const;
    /// V-Clip without its fallback: its errors are counted, and no claim is about it.
    [[nodiscard]] bool is_raw() const { return axis("hardening") == "off"; }
};

struct ReportData {
    std::vector<std::pair<std::string, std::string>> meta;  ///< in order of key
    store::BuildRow build;                                  ///< the build that measured the cells
    std::vector<std::string> other_builds;                  ///< ids of builds in the store that are not shown
    std::vector<ReportCell> cells;  ///< by scene, parameters, vertices, shape, algorithm, table type, hash
    std::vector<ReportCell> from_files;  ///< cells of scenes that are files, which vary a number; likewise
    std::vector<ReportCell>
        stability;                   ///< rows of the stability run: the shape is the family; order likewise
    std::vector<ReportCell> paging;  ///< rows of the paging run; likewise
    std::vector<ReportCell> thrash;  ///< rows of the study of figure 8, and of its realised cells; likewise
    std::vector<ReportCell> effort;  ///< rows of the effort run, ours and peers'; likewise
    std::vector<ReportCell> fields;  ///< rows of the fields run; likewise
    std::vector<ReportCell> other_studies;  ///< rows of studies without a chapter of their own; likewise
    std::vector<ReportCell> peers;  ///< cells of other libraries, in the scenes of `cells`; order likewise
    std::vector<std::pair<std::string, std::string>> scene_files;  ///< name and text (JSON), by name

    /// The sweep's cells, of built-in scenes and of files, in this order; no peers, no rows of other runs.
    [[nodiscard]] std::vector<const ReportCell*> swept() const;
    [[nodiscard]] std::size_t cell_count() const { return cells.size() + from_files.size(); }
    [[nodiscard]] std::size_t count(store::CellStatus status) const;  ///< of all cells
    [[nodiscard]] bool any_failed() const;                            ///< cell or stability row
    /// Returns the value of `meta` for a key; null if there is none.
    [[nodiscard]] std::optional<std::string> meta_value(std::string_view key) const;
};

/// Reads one build as store::read_build does.
[[nodiscard]] ReportData read_report(const std::string& store, const std::string& build = {},
                                     const store::OnCell& on_cell = {});

}  // namespace edgewise::reports
