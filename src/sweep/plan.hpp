// SPDX-License-Identifier: MIT
//
// What a sweep is to do: scenes x shapes x algorithms x table types, and how thoroughly. Named plans are
// written here in code; a plan file is the same as JSON.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "edgewise/scene/workload.hpp"

namespace edgewise {

struct SceneChoice {
    std::string name;
    SceneParameters parameters;  ///< those that differ from the scene's defaults
};

struct Plan {
    std::string name;
    std::vector<SceneChoice> scenes;
    std::vector<std::string> shapes;      ///< built-in names
    std::vector<std::string> meshes;      ///< mesh files
    bool each_mesh = false;               ///< one body for each mesh of a file, instead of one for the file
    bool meshes_required = false;         ///< an unreadable mesh file ends the sweep before it starts
    std::vector<std::string> layouts;     ///< as for select_table_types
    std::vector<std::string> algorithms;  ///< as for select_algorithms
    std::vector<std::string> axes;        ///< beside the plain cells, one at a time; as for parse_axes
    std::uint64_t seed = 1;
    std::size_t queries = 0;    ///< a cell and round
    std::size_t checked = 0;    ///< of them, against exact arithmetic
    int rounds = 0;             ///< timed, interleaved
    std::size_t stability = 0;  ///< hard cases a family; 0: no stability run
};

/// Names of the plans written in code.
[[nodiscard]] std::vector<std::string> plan_names();

/// A named plan, or a JSON file with the members of Plan (missing ones as in `quick`). Throws
/// std::invalid_argument: what, where, what to do.
[[nodiscard]] Plan make_plan(const std::string& name_or_file);

/// Mesh files of real objects that the set-up unpacked; may be empty.
[[nodiscard]] std::vector<std::string> default_meshes();

}  // namespace edgewise
