// SPDX-License-Identifier: MIT
//
// The contents of a store, sorted for showing: scenes have names for people, and the rows of other runs are
// separate.
#pragma once

#include <compare>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "edgewise/store/rows.hpp"

namespace edgewise::reports {

/// `axes` are part of `table` here, because cells with axes are shown next to the plain ones.
struct ReportCell : store::StoredCell {
    std::string scene_label;  ///< what the scene is called
    double others = 0;  ///< what others took of the processor while it was timed (measure::ShareOfOthers)

    /// The value of an axis; null where the cell has none of that name.
    [[nodiscard]] std::optional<std::string> axis(std::string_view name) const;
    /// V-Clip without its fallback: its errors are counted, and no claim is about it.
    [[nodiscard]] bool is_raw() const { return axis("hardening") == "off"; }
};

/// Returns the cells of these lists, one list after the other.
[[nodiscard]] std::vector<const ReportCell*> cells_in(
    std::initializer_list<const std::vector<ReportCell>*> lists);

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
    std::vector<ReportCell> again;  ///< cells that further processes of the sweep timed again; likewise
    std::vector<std::pair<std::string, std::string>> scene_files;  ///< name and text (JSON), by name

    /// The sweep's cells, of built-in scenes and of files, in this order; no peers, no rows of other runs.
    [[nodiscard]] std::vector<const ReportCell*> swept() const { return cells_in({&cells, &from_files}); }
    [[nodiscard]] std::size_t cell_count() const { return cells.size() + from_files.size(); }
    [[nodiscard]] std::size_t count(store::CellStatus status) const;  ///< of all cells
    /// The sweep's cells and the rows of all studies; no peers.
    [[nodiscard]] std::vector<const ReportCell*> rows() const;
    [[nodiscard]] std::vector<const ReportCell*> rows_and_peers() const;  ///< rows(), then peers; no `again`
    [[nodiscard]] bool any_failed() const;                                ///< of rows()
    /// Returns the value of `meta` for a key; null if there is none.
    [[nodiscard]] std::optional<std::string> meta_value(std::string_view key) const;
    /// Returns the names that follow a key (store/schema.hpp), with their values; by name.
    [[nodiscard]] std::vector<std::pair<std::string, std::string>> meta_with(std::string_view key) const;
};

/// Reads one build as store::read_build does.
[[nodiscard]] ReportData read_report(const std::string& store, const std::string& build = {},
                                     const store::OnCell& on_cell = {});

// Labels of scenes: the name, and the parameters that differ from those of the standard scene of its kind. A
// label depends on the cell alone, never on other contents of the store. Also gives a description of the
// scene in one sentence, how much a query has in common with the previous query of its pair, and how many
// tables the queries go through: the break-even map finds a winner by coherence, tables and vertices.

/// The text of scene/kinds/kinds.json: a label omits a parameter's standard value, unless it is always said.
extern const char* const scene_kind_texts;

/// Returns "tumble (rotation_step 0.1, bodies 100)"; for a scene file, given as its JSON, its name and the
/// value of what it varies: "more_bodies (bodies 200)".
[[nodiscard]] std::string scene_label(const store::CellRow& cell, const std::string& file_text = {});

/// Returns a number of the cell's scene parameters; null if none has that name.
[[nodiscard]] std::optional<double> parameter_of(const store::CellRow& cell, const std::string& name);

/// Returns the kind of scene of a scene file, else the scene itself.
[[nodiscard]] std::string scene_kind(const ReportCell& cell);

/// Returns true if every body has a table of its own, false if all share one.
[[nodiscard]] bool has_own_tables(const ReportCell& cell);

/// Returns true if every pair is placed at most a hundredth of the bodies' size apart.
[[nodiscard]] bool is_near_contact(const ReportCell& cell);

/// Returns "100 bodies drift and turn by 0.1 rad per step, followed from step to step; one shared table".
[[nodiscard]] std::string scene_sentence(const ReportCell& cell);

/// How each pair starts a query, ordered from the most coherent to the least.
struct Coherence {
    enum class Start { turned, random, fresh };  ///< by an angle; at random; a pair without an earlier query

    Start start = Start::fresh;
    double turn = 0;   ///< radians per step: 0, or a power of the root of ten
    std::string kind;  ///< kind of scene

    auto operator<=>(const Coherence&) const = default;

    /// Returns "tumble, 0.1 rad", "tumble, random turns", "cold, every pair new".
    [[nodiscard]] std::string text() const;
};

/// Returns the coherence of a cell's scene; null if the scene does not say it.
[[nodiscard]] std::optional<Coherence> coherence_of(const ReportCell& cell);

/// Returns the ratio, at least 1, of the scene's turn to the turn of its class; 1 for scenes without a turn.
[[nodiscard]] double distance_from_class(const ReportCell& cell, const Coherence& coherence);

/// Returns the class of the number of tables: its power of ten; -1 if all bodies share one table.
/// Null if the bodies have tables of their own and the scene does not say how many.
[[nodiscard]] std::optional<int> tables_class(const ReportCell& cell);
/// Returns "one shared table", "2 to 9 tables", "100 to 999 tables".
[[nodiscard]] std::string tables_class_text(int of);

}  // namespace edgewise::reports
