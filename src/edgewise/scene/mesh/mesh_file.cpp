// SPDX-License-Identifier: MIT
//
// From the parts of a mesh file to convex bodies; every message starts with the file's name.
#include "edgewise/scene/mesh/mesh_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>

#include "edgewise/geometry/hull.hpp"
#include "edgewise/geometry/hull/point_set.hpp"
#include "edgewise/geometry/message.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/scene/mesh/mesh_parts.hpp"

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

/// After equal points are welded, every edge is run as often in one direction as in the other, so that sums
/// of tetrahedra depend on no origin.
bool is_closed(std::span<const std::array<Index, 3>> triangles, std::span<const Index> weld) {
    std::map<std::pair<Index, Index>, long> balance;  // of an edge, by its lower and higher vertex
    for (const std::array<Index, 3>& triangle : triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Index from = weld[triangle[k]], to = weld[triangle[(k + 1) % 3]];
            if (from < to) ++balance[{from, to}];
            if (to < from) --balance[{to, from}];
        }
    }
    return std::all_of(balance.begin(), balance.end(), [](const auto& edge) { return edge.second == 0; });
}

/// Sum of signed tetrahedra from the first point, without its sign; nothing when the mesh is not closed.
std::optional<double> mesh_volume(const MeshPart& part) {
    if (part.triangles.empty() || !is_closed(part.triangles, first_of_equals(part.points)))
        return std::nullopt;
    const Vec3d& origin = part.points[part.triangles.front()[0]];
    double six_volumes = 0;
    for (const auto& [first, second, third] : part.triangles) {
        const Vec3d normal = cross(Vec3d(part.points[second] - origin), Vec3d(part.points[third] - origin));
        six_volumes += dot(Vec3d(part.points[first] - origin), normal);
    }
    return std::abs(six_volumes) / 6;
}

/// What the hull adds to the mesh; empty when the mesh is convex or has no faces.
std::string hull_warning(const MeshPart& part, const Polyhedron& hull) {
    if (part.triangles.empty()) return {};
    const std::optional<double> inside = mesh_volume(part);
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
