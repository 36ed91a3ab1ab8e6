// SPDX-License-Identifier: MIT
//
// A plan says what a sweep measures (scenes x shapes x algorithms x table types), and how thoroughly. Plans
// are JSON: the plans that come with Edgewise (plans/, and reports/paper/plan.json) and a user's own files.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/scene/recording.hpp"
#include "edgewise/scene/workload.hpp"

namespace edgewise::sweep {

/// A scene, with the shapes, table types and algorithms of the plan that it uses; an empty list means all. A
/// scene file has its own shapes, parameters and queries, and may name any table type of the program, also
/// one that is not in the plan.
struct SceneChoice {
    std::string name;  ///< a kind of scene, a scene file, or the path of a scene file (.json)
    scene::SceneParameters parameters = {};  ///< parameters that differ from the scene's defaults
    std::vector<std::string> shapes = {}, layouts = {}, algorithms = {};
    std::vector<std::string> pairs =
        {};                   ///< "gjk lean_f32", "vclip aos": an algorithm on a layout or table type
    std::size_t queries = 0;  ///< per cell and round; 0: the plan's number
    bool plain = false;       ///< no further axes: all cells of a group are in memory, and these are large
    std::vector<std::string> axes = {};    ///< instead of the plan's
    std::vector<std::string> caches = {};  ///< shapes with modelled caches; "all": every shape
    bool optional = false;  ///< a recording that is left out where its file is missing, or bodies are named
    std::shared_ptr<const scene::Recording> recording = {};  ///< of a scene file; not a member of plans
};

struct Plan {
    std::string name;
    std::vector<SceneChoice> scenes;
    std::vector<std::string> shapes;      ///< built-in names
    std::vector<std::string> meshes;      ///< mesh files
    bool each_mesh = false;               ///< one body for each mesh of a file, instead of one for the file
    bool as_stored = false;               ///< COLLADA files without the turn and the scale that they name
    bool meshes_required = false;         ///< an unreadable mesh file ends the sweep before it starts
    bool bodies_for_files = false;        ///< scene files use the plan's bodies instead of their own
    std::vector<std::string> layouts;     ///< as for select_table_types
    std::vector<std::string> algorithms;  ///< as for select_algorithms
    std::vector<std::string> peers;       ///< other libraries to measure, too; as for select_peer_types
    std::vector<std::string> axes;        ///< cells next to the plain ones, an axis each; as for parse_axes
    std::uint64_t seed = 1;
    std::size_t queries = 0;            ///< per cell and round
    std::size_t checked = 0;            ///< queries per cell that are checked with exact arithmetic
    bool control = false;               ///< checked queries also ask the paper's control, Moore and Wilhelms
    int rounds = 0;                     ///< timed, interleaved
    int processes = 1;                  ///< that time the fastest cells, one after the other
    int process = 1;                    ///< which of them this is; not a member of plans
    std::size_t traced = 0;             ///< queries per cell that the cache model traces; 0: all
    std::size_t traced_steps = 0;       ///< least number of whole steps traced in a scene in time order
    std::vector<std::string> machines;  ///< machines with modelled caches; as for choose_machines
    std::vector<std::string> probes;    ///< probes to run; empty: all
    /// Amount of work of each study, by its name: queries, bodies, hard cases per family (sweep/study.hpp).
    std::map<std::string, std::size_t, std::less<>> studies;

    /// Returns 0 for a study that is not to run.
    [[nodiscard]] std::size_t count_of(std::string_view study) const {
        const auto found = studies.find(study);
        return found == studies.end() ? 0 : found->second;
    }
};

/// A plan that is compiled into the program, so that it needs no file where the program is installed.
struct PlanText {
    std::string_view name, json;
};
[[nodiscard]] std::span<const PlanText> plan_texts();

/// Returns the path of a file next to the build folders: build/meshes/NAME for build/release/edgewise.
[[nodiscard]] std::string file_beside_builds(const char* folder, const std::string& name);

/// Names of the plans that come with Edgewise.
[[nodiscard]] std::vector<std::string> plan_names();

/// Returns a named plan, for the layouts of this program, or reads a JSON file with the members of Plan;
/// missing members are as in `quick`, except `processes`, which is 1. Throws std::invalid_argument: what,
/// where, what to do.
[[nodiscard]] Plan make_plan(const std::string& name_or_file);
/// Returns the plan of a file's text. Throws like make_plan.
[[nodiscard]] Plan parse_plan(const std::string& file, const std::string& text);

}  // namespace edgewise::sweep
