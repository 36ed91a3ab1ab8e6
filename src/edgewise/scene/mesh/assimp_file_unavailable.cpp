// SPDX-License-Identifier: MIT
//
// Stands in for assimp_file.cpp where Assimp was not there to build with.
#include "edgewise/scene/mesh/mesh_parts.hpp"

namespace edgewise::scene {

Result<std::vector<MeshPart>> assimp_parts(const std::string&, bool, const input::GuardLimits&) {
    return Result<std::vector<MeshPart>>::failure(
        ": this build reads OBJ and STL files alone; install Assimp (Debian: libassimp-dev) and build again");
}

}  // namespace edgewise::scene
