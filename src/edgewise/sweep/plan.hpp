// SPDX-License-Identifier: MIT
//
// What a sweep is to do: scenes x shapes x algorithms x table types, and how thoroughly. Plans are JSON:
// those that come with Edgewise (plans/, and reports/paper/plan.json) and a user's own files.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/scene/workload.hpp"

namespace edgewise::sweep {

/// A scene, and what of the plan it is for: of the plan's shapes, table types and algorithms only these, all
/// where none are named. A scene file has its own shapes, parameters and queries, and is for all table types
/// of the program that are named.
struct SceneChoice {
    std::string name;  ///< of a kind of scene or a scene file, or the path of one (.json)
    scene::SceneParameters parameters = {};  ///< those that differ from the scene's defaults
    std::vector<std::string> shapes = {}, layouts = {}, algorithms = {};
    std::vector<std::string> pairs =
        {};                   ///< "gjk lean_f32", "vclip aos": an algorithm on a layout or table type
    std::size_t queries = 0;  ///< per cell and round; 0: the plan's
    bool plain = false;       ///< no further axes: a group's cells stand side by side, and these are large
    std::vector<std::string> axes = {};    ///< instead of the plan's
    std::vector<std::string> caches = {};  ///< shapes whose cells have their caches modelled; "all" is all
};

struct Plan {
    std::string name;
    std::vector<SceneChoice> scenes;
    std::vector<std::string> shapes;      ///< built-in names
    std::vector<std::string> meshes;      ///< mesh files
    bool each_mesh = false;               ///< one body for each mesh of a file, instead of one for the file
    bool as_stored = false;               ///< COLLADA files without the turn and the scale that they name
    bool meshes_required = false;         ///< an unreadable mesh file ends the sweep before it starts
    bool bodies_for_files = false;        ///< scene files are of these bodies, too, in place of their own
    std::vector<std::string> layouts;     ///< as for select_table_types
    std::vector<std::string> algorithms;  ///< as for select_algorithms
    std::vector<std::string> peers;       ///< as for select_peer_types: other libraries beside these
    std::vector<std::string> axes;        ///< beside the plain cells, one at a time; as for parse_axes
    std::uint64_t seed = 1;
    std::size_t queries = 0;            ///< per cell and round
    std::size_t checked = 0;            ///< of them, against exact arithmetic
    bool control = false;               ///< of these, against Moore and Wilhelms too, the paper's control
    int rounds = 0;                     ///< timed, interleaved
    std::size_t traced = 0;             ///< queries per cell whose caches are modelled; 0: all
    std::size_t traced_steps = 0;       ///< and of scenes in time order as many whole steps at least
    std::vector<std::string> machines;  ///< to model the caches of; as for choose_machines
    std::vector<std::string> probes;    ///< these alone; none: all
    /// What each study is to do, by its name: queries, bodies, hard cases per family (sweep/study.hpp).
    std::map<std::string, std::size_t, std::less<>> studies;

    /// Returns 0 for a study that is not to run.
    [[nodiscard]] std::size_t count_of(std::string_view study) const {
        const auto found = studies.find(study);
        return found == studies.end() ? 0 : found->second;
    }
};

/// A plan in the program; its file is found wherever the program is installed.
struct PlanText {
    std::string_view name, json;
};
[[nodiscard]] std::span<const PlanText> plan_texts();

/// Names of the plans that come with Edgewise.
[[nodiscard]] std::vector<std::string> plan_names();

/// A named plan, of the layouts that the program was built with, or a JSON file with the members of Plan
/// (missing ones as in `quick`). Throws std::invalid_argument: what, where, what to do.
[[nodiscard]] Plan make_plan(const std::string& name_or_file);
/// Likewise from a file's text.
[[nodiscard]] Plan parse_plan(const std::string& file, const std::string& text);

}  // namespace edgewise::sweep
