// SPDX-License-Identifier: MIT
//
// What a plan comes to in this program: its names looked up, its bodies made. All that can be wrong with a
// plan is wrong here, before a store is opened.
#pragma once

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

namespace edgewise::sweep {

/// A scene of the plan, with what of the plan it is for; of a scene file one of its points.
struct SceneWork {
    SceneChoice choice;            ///< with every parameter
    std::string kind, json, path;  ///< of a scene file: its kind of scene, its JSON, and where it lies
    std::size_t queries = 0;
    std::vector<const scene::NamedShape*> shapes;
    std::vector<const bench::TableType*> types;
    std::vector<std::string> algorithms;
    std::vector<Axes> axes;  ///< the plain cell first

    /// Whether the caches of this shape's cells are modelled.
    [[nodiscard]] bool models_caches(const scene::NamedShape& shape) const;
};

struct SweepWork {
    Plan plan;
    std::vector<const bench::TableType*> types, peers;
    std::vector<std::string> algorithms;
    std::vector<measure::MachineChoice> machines;  ///< to model the caches of
    std::vector<scene::NamedShape> shapes;
    std::deque<scene::NamedShape> file_shapes;  ///< of scene files
    std::vector<SceneWork> scenes;
    std::set<std::string> parts_elsewhere;  ///< units of studies that other shards run

    SweepWork() = default;
    SweepWork(SweepWork&&) = default;  ///< and no copy: scenes point at shapes, which stay where they are

    /// The cells of a scene and any of its shapes, each once; peers, in every scene, have plain cells alone.
    void each_cell(const SceneWork& scene,
                   const std::function<void(const bench::TableType&, const std::string& algorithm,
                                            const Axes&)>& use) const;
    [[nodiscard]] std::size_t cells() const;
};

/// A scene on a shape, whose cells are compared with each other: the same in every plan and process.
[[nodiscard]] std::string comparison_name(const SceneWork& scene, const scene::NamedShape& shape);

/// The bodies of a plan: built-in shapes and hulls of mesh files. A mesh file that cannot be read becomes a
/// shape with an error, so that its cells appear in the report as unavailable, with the reason. Throws
/// std::invalid_argument for an unknown built-in name (a slip of the user, not of the data).
[[nodiscard]] std::vector<scene::NamedShape> shapes_of(
    const Plan& plan, const std::function<void(const std::string& line)>& warn);

/// Throws std::invalid_argument: what, where, what to do. `warn` is notified of non-fatal problems.
[[nodiscard]] SweepWork prepare_sweep(const Plan& plan,
                                      const std::function<void(const std::string& line)>& warn);

// The names of a plan's scene files. A scene's name is its file's, and its charts, its table of results and
// its rows in the store go by it: two scenes of one name would be shown as one, and one named like a scene
// that comes along would stand in its place.

/// Throws std::invalid_argument that names both when two scenes of the plan would go by one name, or a file's
/// name is that of a kind of scene or of a scene file that comes along.
void check_scene_names(const Plan& plan);

/// What files and charts of a scene are called: letters, digits, _ and -.
[[nodiscard]] std::string scene_id(std::string name);

/// Empty, or whose name it is that a user's scene file may not have.
[[nodiscard]] std::string owner_of_scene_name(const std::string& name);

/// Throws std::invalid_argument that names both files when the store holds another scene of the name of one
/// of the work's scene files.
void check_scene_files(const SweepWork& work, const store::Store& store);

}  // namespace edgewise::sweep
