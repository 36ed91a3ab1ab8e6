// SPDX-License-Identifier: MIT
//
// Recorded motion of an engine: files in the format convex-motion (docs/your_engine.md), and the scene that
// replays them. Every shape is a convex core and a radius: the axis radius=recorded asks the rounded
// bodies, all other cells ask the cores, and the note says so. Shapes with a core without vertices (plane,
// cylinder, ellipsoid, unknown types) are left out with their pairs, and counted.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/algorithms/sweep_and_prune.hpp"
#include "edgewise/geometry/result.hpp"
#include "edgewise/scene/workload.hpp"

namespace edgewise::scene {

inline constexpr std::string_view recorded_kind = "recorded";

struct RecordedBody {
    std::uint32_t core = 0;  ///< index into Recording::cores
    std::uint32_t link = 0;
    Pose in_link;
    double radius = 0;  ///< around the core
    std::optional<std::uint32_t> parent;
    std::uint32_t group = 1, mask = ~0U;
    bool fixed = false;
};

struct RecordedStep {
    double time = 0;  ///< s
    std::vector<Pose> links;
    std::vector<bool> asleep;     ///< a flag per link; empty: all awake
    std::vector<BodyPair> pairs;  ///< of the file: each once, without bodies that were left out
    bool jump = false;            ///< does not follow from the step before
};

struct Recording {
    std::string name;               ///< of the file, without its endings
    std::vector<Polyhedron> cores;  ///< one for each shape and scale; those with most vertices first
    std::vector<RecordedBody> bodies;
    std::vector<BodyPair> excluded;  ///< links that are never asked with each other, sorted
    std::vector<RecordedStep> steps;
    bool has_pairs = false;      ///< the steps have the engine's own pairs
    std::uint32_t checksum = 0;  ///< of the file's text and the cores
    std::string note;            ///< on mesh files, radii left off, shapes left out; empty if there are none
};

/// Returns true if the path ends like that of a recording: .jsonl, or .jsonl.gz.
[[nodiscard]] bool names_recording(std::string_view path);

/// Reads a file, plain or gzip; `as_stored`: its mesh files (MeshReading). Fails with one line: file:line,
/// what is wrong, what to do.
[[nodiscard]] Result<Recording> read_recording(const std::string& path, bool as_stored = false);

/// The queries of the steps in time order, with the pair caches that an engine keeps: a pair that was near in
/// the step before starts warm, unless the step is a jump. If the steps have more queries than `query_count`,
/// whole segments of steps are kept, spread evenly. The warning says how many, and has the recording's note.
/// Fails if no pair is near.
[[nodiscard]] Result<Workload> recorded_workload(const Recording& recording,
                                                 const SceneParameters& parameters, std::size_t query_count);

}  // namespace edgewise::scene
