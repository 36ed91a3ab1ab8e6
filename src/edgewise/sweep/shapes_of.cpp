// SPDX-License-Identifier: MIT
#include "edgewise/sweep/shapes_of.hpp"

#include <filesystem>
#include <stdexcept>

#include "edgewise/geometry/hull.hpp"
#include "edgewise/scene/mesh/mesh_file.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise::sweep {

namespace {

/// A single-precision mesh file holds only coordinates that every precision stores exactly, so that the
/// rounding of storage would never show. This map, stated in the report, gives the coordinates all their
/// digits back.
constexpr double mesh_scale = 1.0 + 1.0 / 3.0;

void add_mesh(const Plan& plan, const std::string& file, std::vector<scene::NamedShape>& to,
              const std::function<void(const std::string&)>& warn) {
    const std::string name = std::filesystem::path(file).filename().string();
    auto bodies = scene::read_mesh_file(
        file, plan.each_mesh ? scene::MeshGrouping::each_mesh : scene::MeshGrouping::one_hull);
    if (!bodies.warning.empty()) warn(bodies.warning);
    if (!bodies) {
        if (plan.meshes_required) throw std::invalid_argument(bodies.error);
        warn(bodies.error);
        scene::NamedShape missing;
        missing.name = std::filesystem::path(file).stem().string();
        missing.source = name;
        missing.error = bodies.error;
        to.push_back(std::move(missing));
        return;
    }
    for (scene::MeshBody& mesh : *bodies) {
        for (Vec3d& v : mesh.body.vertices) v *= mesh_scale;
        auto body = convex_hull(mesh.body.vertices);  // rounding moved the vertices: faces anew
        if (!body) throw std::logic_error(body.error);
        to.push_back({mesh.name, name + ", scaled by 4/3", std::move(*body), {}});
    }
}

}  // namespace

std::vector<scene::NamedShape> shapes_of(const Plan& plan,
                                         const std::function<void(const std::string&)>& warn) {
    std::vector<scene::NamedShape> result;
    for (const std::string& name : plan.shapes) {
        auto body = scene::make_shape(name);
        if (!body) throw std::invalid_argument(body.error);
        result.push_back({name, "built-in", std::move(*body), {}});
    }
    for (const std::string& file : plan.meshes) add_mesh(plan, file, result, warn);
    return result;
}

}  // namespace edgewise::sweep
