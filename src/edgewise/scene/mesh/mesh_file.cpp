// SPDX-License-Identifier: MIT
//
// From the parts of a mesh file to convex bodies; every message starts with the file's name.
#include "edgewise/scene/mesh/mesh_file.hpp"

#include <filesystem>

#include "edgewise/geometry/hull.hpp"
#include "edgewise/geometry/message.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/scene/mesh/mesh_parts.hpp"
#include "edgewise/scene/mesh/mesh_volume.hpp"

namespace edgewise::scene {
namespace {

using Bodies = Result<std::vector<MeshBody>>;

/// All parts as one, so that a surface that is split by material counts as closed.
MeshPart joined(const std::vector<MeshPart>& parts) {
    MeshPart all;
    for (const MeshPart& part : parts) {
        const auto start = static_cast<Index>(all.points.size());
        all.points.insert(all.points.end(), part.points.begin(), part.points.end());
        for (const auto& [a, b, c] : part.triangles)
            all.triangles.push_back({start + a, start + b, start + c});
    }
    return all;
}

/// What the hull adds to the mesh; empty when the mesh is convex or has no faces.
std::string hull_warning(const MeshPart& part, const Polyhedron& hull) {
    if (part.triangles.empty()) return {};
    const std::optional<double> inside = mesh_volume(part.points, part.triangles);
    if (!inside) return "the mesh is not closed; its hull is used, hull volume / mesh volume is unknown";
    const double whole = volume(hull);
    if (*inside >= convex_volume_share * whole) return {};
    return message("the mesh is concave; its hull is used, hull volume / mesh volume = ",
                   rounded(whole / *inside, 5));
}

}  // namespace

Bodies read_mesh_file(const std::string& path, MeshGrouping grouping) {
    Result<std::vector<MeshPart>> parts = read_mesh_parts(path);
    if (!parts) return Bodies::failure(path + ": " + parts.error);
    if (grouping == MeshGrouping::one_hull) *parts = {joined(*parts)};
    const std::string stem = std::filesystem::path(path).stem().string();
    const bool several = parts->size() > 1;
    std::vector<MeshBody> bodies;
    std::string warnings;
    for (std::size_t k = 0; k < parts->size(); ++k) {
        const MeshPart& part = (*parts)[k];
        std::string where = path;
        if (several) where += message(" (mesh ", k + 1, part.name.empty() ? "" : " '" + part.name + "'", ")");
        Result<Polyhedron> hull = convex_hull(part.points);
        if (!hull) return Bodies::failure(where + ": " + hull.error);
        const std::string warning = hull_warning(part, *hull);
        if (!warning.empty()) warnings += message(warnings.empty() ? "" : "; ", where, ": ", warning);
        bodies.push_back({several ? message(stem, "#", k + 1) : stem, std::move(*hull)});
    }
    return Bodies::success(std::move(bodies), std::move(warnings));
}

}  // namespace edgewise::scene
