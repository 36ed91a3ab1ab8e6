// SPDX-License-Identifier: MIT
#include "edgewise/scene/mesh/mesh_shapes.hpp"

#include <filesystem>

#include "edgewise/geometry/hull.hpp"

namespace edgewise::scene {

Result<std::vector<NamedShape>> mesh_shapes(const std::string& file, const MeshReading& reading) {
    using Shapes = Result<std::vector<NamedShape>>;
    auto bodies = read_mesh_file(file, reading);
    if (!bodies) return Shapes::failure(bodies.error);
    const std::string source = std::filesystem::path(file).filename().string() +
                               (reading.as_stored ? ", as stored" : "") + ", scaled by 4/3";
    std::vector<NamedShape> shapes;
    for (MeshBody& mesh : *bodies) {
        for (Vec3d& v : mesh.body.vertices) v *= mesh_scale;
        auto hull = convex_hull(mesh.body.vertices);  // rounding moved the vertices: faces anew
        if (!hull) return Shapes::failure(file + ": " + hull.error);
        shapes.push_back({mesh.name, source, *std::move(hull), {}});
    }
    return Shapes::success(std::move(shapes), bodies.warning);
}

}  // namespace edgewise::scene
