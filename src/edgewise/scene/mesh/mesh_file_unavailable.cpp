// SPDX-License-Identifier: MIT
//
// Stands in for mesh_file.cpp where Assimp was not there to build with.
#include "edgewise/scene/mesh/mesh_file.hpp"

namespace edgewise::scene {

Result<std::vector<MeshBody>> read_mesh_file(const std::string& path, MeshGrouping) {
    return Result<std::vector<MeshBody>>::failure(
        path + ": this build cannot read mesh files; install Assimp (Debian: libassimp-dev) and build again");
}

}  // namespace edgewise::scene
