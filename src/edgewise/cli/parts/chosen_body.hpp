// SPDX-License-Identifier: MIT
//
// The options that name bodies, and the one body of a command that takes a built-in shape or a mesh file.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "edgewise/scene/mesh/mesh_file.hpp"

namespace edgewise::cli {

struct BodyChoice {
    std::string shape = "sphere386";
    std::string mesh;        ///< a file, in place of the shape
    bool as_stored = false;  ///< of the file (scene::MeshReading)
};

/// --shape, --mesh and --as-stored.
void add_body_options(CLI::App& command, BodyChoice& choice);

/// --as-stored, which every command that reads mesh files has.
CLI::Option* add_as_stored_option(CLI::App& command, bool& as_stored);

/// The hull of the mesh file, or the shape where no file is named. Warns of what is odd about a file; throws
/// std::invalid_argument: what, where, what to do.
[[nodiscard]] scene::MeshBody chosen_body(const BodyChoice& choice);
/// The hull of a mesh file, with the same warnings and errors; a flat one where `takes_flat` says so.
[[nodiscard]] scene::MeshBody mesh_body(const std::string& file, bool as_stored, bool takes_flat = false);

}  // namespace edgewise::cli
