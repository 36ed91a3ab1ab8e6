// SPDX-License-Identifier: MIT
//
// A scene as a small JSON file that users can write: the kind of scene, its bodies, how they move, and
// what each answer must contain. One number may be varied: each of its values is a point of the scene.
//
//     {"scene": "tumble", "shapes": ["sphere386"], "time_step": 0.0166667,
//      "needs": "distance", "sharing": "per_instance",
//      "parameters": {"bodies": 200, "occupancy": 0.1, "angular_velocity": 1.0},
//      "vary": {"angular_velocity": [0.5, 1, 2, 4, "random"]}, "queries": 30000, "note": "what it is for"}
//
// Only the inputs of detection are modelled: no gravity, no contact response, no solver. Parameters are the
// kind's own (`edgewise list scenes`). Scenes that move bodies also take these two, which the time step turns
// into the kind's: angular_velocity (rad/s), linear_velocity (m/s). "random" as a turn: every body is turned
// at random in every step, which leaves no coherence. "needs": "nearer" allows a "margin", relative to the
// larger body's extent. A shape with a dot in its name is a mesh file, searched from the scene file's folder
// ("shapes": ["my_link.stl"]); its body is called after it (my_link).
//
// Motion of an engine: {"scene": "recorded", "recording": "heap.jsonl.gz"}. A recording is a scene file, too.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/geometry/result.hpp"
#include "edgewise/scene/recording.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/scene/workload.hpp"
#include "edgewise/table/needs.hpp"

namespace edgewise::scene {

/// One point of a scene file: a scene on a body.
struct ScenePoint {
    std::string shape;
    SceneParameters parameters;  ///< complete
};

struct SceneFile {
    std::string name;                ///< of the file, without its ending
    std::string kind;                ///< static, tumble ...
    std::vector<NamedShape> shapes;  ///< built-in, and of mesh files
    double time_step = 0;            ///< s
    Needs needs = Needs::witnesses;
    double margin = 0;        ///< where needs have one, over the larger body's extent; 0: the usual one
    std::size_t queries = 0;  ///< of every point; 0: as the plan says
    std::string note;
    std::vector<ScenePoint> points;                   ///< shapes x varied values
    std::string text;                                 ///< the file as JSON in one line, for the store
    std::shared_ptr<const Recording> recording = {};  ///< of the kind `recorded`; its shape is the first core
};

/// Settings of a scene file that its text does not contain.
struct SceneFileContext {
    std::filesystem::path folder = {};    ///< where the file lies; empty: the working folder
    std::vector<NamedShape> bodies = {};  ///< replace the file's own shapes; none: its own
    bool as_stored = false;               ///< of its mesh files (MeshReading)
};

/// Fails with one line: the file, the place in it, what is allowed there. The warning is about its meshes.
/// The folder of the context is that of the path.
[[nodiscard]] Result<SceneFile> read_scene_file(const std::string& path, SceneFileContext context = {});
/// Reads a scene from its text and a name; fails like read_scene_file.
[[nodiscard]] Result<SceneFile> parse_scene_file(const std::string& name, const std::string& text,
                                                 const SceneFileContext& context = {});

/// Figures are kept by the names of shapes. Empty, or one line that names a shape that is there twice.
[[nodiscard]] std::string shape_given_twice(std::span<const NamedShape> shapes);

struct SceneText {
    std::string_view name, json;
};

/// The scene files that come with Edgewise: the scenes of "New Metrics for Evaluation of Collision Detection
/// Techniques", one for each of its tests and figures (reports/paper/scenes). Sweeps and files name them like
/// kinds of scenes.
[[nodiscard]] std::span<const SceneText> scene_texts();

/// Returns true if the name is that of a supplied scene file, or a path that ends in .json or like a
/// recording.
[[nodiscard]] bool is_scene_file(const std::string& name_or_path);

/// Name of the scene in the file at a path: the file's, without its endings.
[[nodiscard]] std::string scene_name_at(const std::filesystem::path& file);

/// The scene file of that name, or at that path if it ends like a scene file; nothing for any other name.
[[nodiscard]] std::optional<Result<SceneFile>> find_scene_file(const std::string& name_or_path,
                                                               const SceneFileContext& context = {});

}  // namespace edgewise::scene
