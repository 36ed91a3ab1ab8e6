// SPDX-License-Identifier: MIT
#include "edgewise/cli/parts/chosen_body.hpp"

#include <utility>

#include "edgewise/cli/command.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise::cli {

CLI::Option* add_as_stored_option(CLI::App& command, bool& as_stored) {
    return command.add_flag("--as-stored", as_stored,
                            "leave out the turn and the scale that a COLLADA file names (up axis, unit)");
}

void add_body_options(CLI::App& command, BodyChoice& choice) {
    CLI::Option* const shape =
        command.add_option("--shape", choice.shape, "built-in shape")->capture_default_str();
    CLI::Option* const mesh =
        command.add_option("--mesh", choice.mesh, "mesh file instead of a built-in shape")->excludes(shape);
    add_as_stored_option(command, choice.as_stored)->needs(mesh);
}

scene::MeshBody chosen_body(const BodyChoice& choice) {
    if (choice.mesh.empty()) return {choice.shape, scene::make_shape(choice.shape).or_throw()};
    return mesh_body(choice.mesh, choice.as_stored);
}

scene::MeshBody mesh_body(const std::string& file, bool as_stored, bool takes_flat) {
    auto bodies = scene::read_mesh_file(file, {scene::MeshGrouping::one_hull, as_stored, takes_flat});
    if (!bodies.warning.empty()) warn(bodies.warning);
    return std::move(bodies).or_throw().front();
}

}  // namespace edgewise::cli
