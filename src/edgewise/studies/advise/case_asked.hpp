// SPDX-License-Identifier: MIT
//
// The case that advice is asked for: which body, in which scene, how tables are shared, and how exact answers
// have to be.
#pragma once

#include <cstdint>
#include <string>

#include "edgewise/scene/shapes.hpp"
#include "edgewise/sweep/plan.hpp"
#include "edgewise/table/needs.hpp"

namespace edgewise::studies::advise {

struct CaseAsked {
    scene::NamedShape shape;
    std::string mesh;          ///< the file that the shape is of; empty: built-in
    bool as_stored = false;    ///< of the mesh (scene::MeshReading)
    sweep::SceneChoice scene;  ///< a kind of scene with its parameters
    bool own_tables = false;   ///< a table for each body; else one for all
    Needs needs = Needs::distance;
    double error_limit = 1e-6;  ///< of a distance, divided by the scale of the pair
    std::uint64_t seed = 1;
};

/// Returns the scene `tumble` with this number of bodies, frame after frame as an engine asks; each body
/// turns by `rotation_step` rad per step.
[[nodiscard]] sweep::SceneChoice tumbling(std::size_t bodies, double rotation_step);

/// Returns true if the kind of scene can be run both with a shared table and with a table for each body.
[[nodiscard]] bool can_share(const CaseAsked& asked);

/// Returns the scene with the tables shared as asked.
[[nodiscard]] sweep::SceneChoice scene_of(const CaseAsked& asked);

/// Returns "tumble, bodies 300, 386 vertices (sphere386), a table each, distance, error <= 1e-06".
[[nodiscard]] std::string sentence_of(const CaseAsked& asked);

}  // namespace edgewise::studies::advise
