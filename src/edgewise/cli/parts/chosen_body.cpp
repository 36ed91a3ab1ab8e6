// SPDX-License-Identifier: MIT
#include "edgewise/cli/parts/chosen_body.hpp"

#include <utility>

#include "edgewise/cli/command.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise::cli {

scene::MeshBody chosen_body(const std::string& shape, const std::string& mesh) {
    if (mesh.empty()) return {shape, scene::make_shape(shape).or_throw()};
    auto bodies = scene::read_mesh_file(mesh, scene::MeshGrouping::one_hull);
    if (bodies && !bodies.warning.empty()) warn(bodies.warning);
    return std::move(bodies).or_throw().front();
}

}  // namespace edgewise::cli
