// SPDX-License-Identifier: MIT
//
// The rows of the store as plain structs: for those who write them and for those who read them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "edgewise/measure/figure.hpp"

namespace edgewise::store {

/// What built and what ran: the provenance of every figure. `id` hashes the rest, seed and time aside.
struct BuildRow {
    std::string id;
    std::string git_revision, compiler, flags, build_type;
    std::string machine_json;  ///< what `edgewise machine --json` prints
};

/// The `run` of a sweep's rows; those of a study have the study's name.
inline constexpr const char* sweep_run = "sweep";

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

struct FigureRow : measure::Figure {
    std::string probe;
};

}  // namespace edgewise::store
