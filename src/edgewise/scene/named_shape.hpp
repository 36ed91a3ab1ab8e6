// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "edgewise/geometry/polyhedron.hpp"

namespace edgewise::scene {

/// A body and where it came from.
struct NamedShape {
    std::string name, source;  ///< source: "built-in", or the mesh file's name
    Polyhedron body;
    std::string error;  ///< why there is no body; its cells are unavailable
};

}  // namespace edgewise::scene
