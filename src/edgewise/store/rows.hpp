// SPDX-License-Identifier: MIT
//
// The rows of a store as plain structs, and the functions that read them. Files are opened for reading alone;
// a sweep may be writing them.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "edgewise/measure/expected.hpp"
#include "edgewise/measure/round.hpp"
#include "edgewise/store/sqlite.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::store {

/// Program and machine that a figure comes from. `id` is a hash of the other members.
struct BuildRow {
    std::string id;
    std::string git_revision, compiler, flags, build_type;
    std::string machine_json;  ///< what `edgewise machine --json` prints
};

/// The `run` of a sweep's rows; those of a study have the study's name.
inline constexpr const char* sweep_run = "sweep";
/// The `run` of cells that a further process of a sweep timed again begins so: "process 2".
inline constexpr std::string_view process_run = "process ";

/// Cells of another library, and of raw V-Clip, are judged: their errors are counted and fail nothing.
enum class CellStatus { unavailable, verified, failed, judged };
inline constexpr std::string_view status_names[] = {"unavailable", "verified", "failed", "judged"};
[[nodiscard]] constexpr std::string_view to_string(CellStatus status) {
    return status_names[static_cast<int>(status)];
}

/// One cell: scene x shape x algorithm x layout x precision x further axes.
struct CellRow {
    std::string hash;  ///< of everything below that names the cell, and of the bodies and the seed
    std::string scene, scene_parameters;  ///< name, and its numbers as canonical JSON
    std::string shape, shape_source;      ///< name, and "built-in" or the mesh file's name
    std::string algorithm, layout, precision, table;
    std::int64_t vertices = 0, edges = 0, faces = 0;
    std::uint64_t seed = 0;
    std::int64_t queries = 0;
    CellStatus status = CellStatus::unavailable;
    std::string reason;           ///< why failed or unavailable; of a judged one, what is wrong with it
    std::string axes;             ///< further axes, as in sweep/axes.hpp; empty for the plain cell
    std::string run = sweep_run;  ///< what measured it
    std::string scene_kind = {};  ///< of a scene file: part of the hash, and no column

    [[nodiscard]] bool verified() const { return status == CellStatus::verified; }
    [[nodiscard]] bool judged() const { return status == CellStatus::judged; }
    [[nodiscard]] bool failed() const { return status == CellStatus::failed; }
    [[nodiscard]] bool is_timed() const { return verified() || judged(); }
};

/// A cell is fast if its time is at most this factor times that of the fastest cell it is compared with.
inline constexpr double fast_ratio = 1.25;

struct FigureRow : measure::Figure {
    std::string probe;
};

/// Columns in the order in which rows are written and copied; a table may have further ones.
inline constexpr const char *build_columns = "id, git_revision, compiler, flags, build_type, machine_json",
                            *cell_columns =
                                "build, hash, scene, scene_parameters, shape, shape_source, "
                                "algorithm, layout, precision, table_type, vertices, edges, "
                                "faces, seed, queries, status, reason, axes, run",
                            *figure_columns = "build, hash, probe, name, value, unit, reason, remedy",
                            *round_columns =
                                "build, hash, number, separated_queries, separated_ns, overlapping_queries, "
                                "overlapping_ns, baseline_separated_queries, baseline_separated_ns, "
                                "baseline_overlapping_queries, baseline_overlapping_ns, either_queries, "
                                "either_ns, first_queries, first_ns";
/// An SQL statement, as "insert or ignore into build(id, ...) values(?,...)" with a ? for each column.
[[nodiscard]] std::string insertion(const char* or_what, const char* table, std::string_view columns);

/// Throws std::runtime_error with one line (what, where, what to do) if this program cannot read the store. A
/// store of schema version 5 is then read as if it had today's columns.
void check_schema(const sqlite::Database& database);
/// Converts a store of schema version 5 to today's; call it inside a transaction.
void take_runs_from_old_names(const sqlite::Database& database);

/// The key of `meta` for what others took while a cell was timed; the same for all cells of a scene and
/// shape.
[[nodiscard]] std::string others_key_of(const std::string& build, const CellRow& cell);

/// Keys and values of the table `meta`, by key.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> meta_of(const sqlite::Database& database);

[[nodiscard]] std::optional<BuildRow> find_build(const sqlite::Database& database, const std::string& id);
[[nodiscard]] std::optional<CellRow> find_cell(const sqlite::Database& database, const std::string& build,
                                               const std::string& hash);
/// Figures of one cell, by probe, then by name.
[[nodiscard]] std::vector<FigureRow> figures_of(const sqlite::Database& database, const std::string& build,
                                                const std::string& hash);
/// Rounds of one cell, by number.
[[nodiscard]] std::vector<measure::Round> rounds_of(const sqlite::Database& database,
                                                    const std::string& build, const std::string& hash);

struct StoredCell : CellRow {
    std::vector<FigureRow> figures = {};      ///< in order of probe and name
    std::vector<measure::Round> rounds = {};  ///< in order of number

    /// The stored figure; if it is not stored, a figure without a value that says so.
    [[nodiscard]] measure::Figure figure(const std::string& probe, const std::string& name) const;
    [[nodiscard]] measure::Figure figure(const FigureName& name) const {
        return figure(name.probe(), name.name());
    }
};

struct StoredBuild {
    std::vector<std::pair<std::string, std::string>> meta;  ///< in order of key
    BuildRow build;
    std::vector<std::string> other_builds;  ///< ids of the other builds in the store
    std::vector<StoredCell> cells;          ///< by hash
};

/// Called with the number of cells read and of all cells.
using OnCell = std::function<void(std::size_t done, std::size_t all)>;

/// Reads one build; an empty `build` means the latest: the one that the key `build` of `meta` names, else the
/// one with the most cells (ties: the smallest id). `on_cell` is called after every cell. Throws
/// std::runtime_error with one line: what, where, what to do.
[[nodiscard]] StoredBuild read_build(const std::string& store, const std::string& build = {},
                                     const OnCell& on_cell = {});

}  // namespace edgewise::store
