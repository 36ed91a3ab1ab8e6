// SPDX-License-Identifier: MIT
//
// The work of a plan in this program: its names are looked up and its bodies are made. Every error of a plan
// is found here, before a store is opened.
#pragma once

#include <atomic>
#include <deque>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "edgewise/bench/registry.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/store/store.hpp"
#include "edgewise/sweep/axes.hpp"
#include "edgewise/sweep/plan.hpp"
#include "edgewise/sweep/prepared_cell.hpp"

namespace edgewise::sweep {

class TimeLeft;

/// The baseline of every ratio: the paper's algorithm on the paper's layout.
inline const std::string baseline_algorithm = "vclip", baseline_table = "aos_f64";

/// A scene of the plan, or one point of a scene file, with the shapes, types and algorithms that it uses.
struct SceneWork {
    SceneChoice choice;            ///< with every parameter
    std::string kind, json, path;  ///< of a scene file: its kind of scene, its JSON and its path
    std::size_t queries = 0;
    std::vector<const scene::NamedShape*> shapes;
    std::vector<const bench::TableType*> types;
    std::vector<std::string> algorithms;
    std::vector<Axes> axes;  ///< the plain cell first

    /// Returns true if the caches of this shape's cells are modelled.
    [[nodiscard]] bool models_caches(const scene::NamedShape& shape) const;
};

struct SweepWork {
    Plan plan;
    std::vector<const bench::TableType*> types, peers;
    std::vector<std::string> algorithms;
    std::vector<measure::MachineChoice> machines;  ///< machines with modelled caches
    std::vector<scene::NamedShape> shapes;
    std::deque<scene::NamedShape> file_shapes;  ///< of scene files
    std::vector<SceneWork> scenes;
    std::set<std::string> parts_elsewhere;  ///< units of studies that other shards run

    SweepWork() = default;
    SweepWork(SweepWork&&) = default;  ///< not copyable: scenes point at the shapes

    /// Calls `use` once for each cell of a scene on one shape. Peers have plain cells only, in every scene.
    void each_cell(const SceneWork& scene,
                   const std::function<void(const bench::TableType&, const std::string& algorithm,
                                            const Axes&)>& use) const;
    [[nodiscard]] std::size_t cells() const;
};

/// Returns the name of a comparison: all cells of a scene on a shape. Every plan and process uses this name.
[[nodiscard]] std::string comparison_name(const SceneWork& scene, const scene::NamedShape& shape);

/// The bodies of a plan: built-in shapes and hulls of mesh files. A mesh file that cannot be read becomes a
/// shape with an error, so that its cells appear in the report as unavailable, with the reason. Throws
/// std::invalid_argument for an unknown built-in name (a slip of the user, not of the data).
[[nodiscard]] std::vector<scene::NamedShape> shapes_of(
    const Plan& plan, const std::function<void(const std::string& line)>& warn);

/// Throws std::invalid_argument: what, where, what to do. `warn` is notified of non-fatal problems.
[[nodiscard]] SweepWork prepare_sweep(const Plan& plan,
                                      const std::function<void(const std::string& line)>& warn);

// The names of a plan's scene files. A scene is named after its file, and so are its charts, its table of
// results and its rows in the store. Two scenes of one name would be shown as one scene, and a scene with the
// name of a built-in scene would replace it.

/// Throws std::invalid_argument with both names if two scenes of the plan have one name, or if a file has the
/// name of a kind of scene or of a built-in scene file.
void check_scene_names(const Plan& plan);

/// Throws std::invalid_argument with both file names if the store has another scene with the name of one of
/// the work's scene files.
void check_scene_files(const SweepWork& work, const store::Store& store);

struct SweepSummary {
    std::size_t cells = 0, verified = 0, failed = 0, unavailable = 0;
    std::size_t judged = 0;  ///< cells of other libraries, and of raw V-Clip
    bool stopped = false;    ///< ended early; stored results are kept
};

/// Functions that a sweep calls while it runs.
struct SweepListener {
    /// Called when more work is done; `cells` is 0 until their group ends. Without `what`: an earlier run did
    /// it.
    std::function<void(std::size_t cells, const std::string& what)> on_done;
    std::function<void(const std::string& line)> on_warning;
};

/// What all cells of a scene on a shape have in common: a row without algorithm, table and hash.
[[nodiscard]] store::CellRow row_of(const Plan& plan, const SceneWork& scene, const scene::NamedShape& shape);
/// The queries that all cells of a scene on a shape answer. Throws std::invalid_argument when the scene
/// cannot be made.
[[nodiscard]] SharedQueries queries_of(Plan plan, const SceneWork& scene, const scene::NamedShape& shape);

/// `left` receives the expected work and the time that each part took. `stop` is read between rounds.
[[nodiscard]] SweepSummary run_sweep(const SweepWork& work, store::Store& store, TimeLeft& left,
                                     const SweepListener& listener, const std::atomic<bool>& stop);

}  // namespace edgewise::sweep
