// SPDX-License-Identifier: MIT
//
// Finds the reader of a mesh file, and makes convex bodies of its parts. Every message begins with the path.
#include "edgewise/scene/mesh/mesh_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <regex>
#include <stdexcept>
#include <utility>

#include "edgewise/geometry/hull.hpp"
#include "edgewise/geometry/hull/point_set.hpp"
#include "edgewise/geometry/message.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/input/file_text.hpp"
#include "edgewise/input/known_names.hpp"
#include "edgewise/scene/mesh/mesh_parts.hpp"
#include "edgewise/scene/mesh/mesh_text.hpp"

namespace edgewise::scene {
namespace {

using Bodies = Result<std::vector<MeshBody>>;

constexpr std::uint64_t most_mesh_bytes = std::uint64_t{1} << 30;

/// Assimp holds several copies of a file, in nodes of its own, and takes 0.1 s for a megabyte of text.
input::GuardLimits usual_limits(std::uint64_t bytes) {
    return {(std::uint64_t{1} << 30) + 200 * bytes, std::chrono::seconds(10 + bytes / 200'000)};
}

/// Errors and warnings without the path.
Parts parts_of(const std::string& path, bool as_stored, const std::optional<input::GuardLimits>& limits) {
    if (std::string wrong = input::what_is_wrong_with(path); !wrong.empty())
        return Parts::failure(": " + wrong);
    std::error_code code;
    const std::uint64_t bytes = std::filesystem::file_size(path, code);
    if (bytes == 0) return Parts::failure(": is empty (0 bytes)");
    const std::string ending = lower_case(std::filesystem::path(path).extension().string());
    if (ending == ".obj" || ending == ".stl") {
        const auto text = input::read_file_text(path, most_mesh_bytes);
        if (!text) return Parts::failure(text.error.substr(path.size()));
        return ending == ".obj" ? obj_parts(*text) : stl_parts(*text);
    }
    if (std::string wrong = mesh_header_error(path); !wrong.empty()) return Parts::failure(": " + wrong);
    if (ending == ".ply" || ending == ".off") {
        const auto text = input::read_file_text(path, most_mesh_bytes);
        if (!text) return Parts::failure(text.error.substr(path.size()));
        if (std::string wrong = ending == ".ply" ? ply_rows_error(*text) : off_rows_error(*text);
            !wrong.empty())
            return Parts::failure(std::move(wrong));
    }
    return assimp_parts(path, as_stored, limits.value_or(usual_limits(bytes)));
}

/// All parts as one, so that a surface that is split by material counts as closed.
MeshPart joined(const std::vector<MeshPart>& parts) {
    MeshPart all;
    for (const MeshPart& part : parts) {
        all.in_single = all.in_single || part.in_single;
        const auto start = static_cast<Index>(all.points.size());
        all.points.insert(all.points.end(), part.points.begin(), part.points.end());
        for (const auto& [a, b, c] : part.triangles)
            all.triangles.push_back({start + a, start + b, start + c});
    }
    return all;
}

/// Returns true if each edge, after welding equal points, occurs as often in one direction as in the other.
/// Then sums of tetrahedra do not depend on the origin.
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

/// Says what the hull adds to the mesh; empty when the mesh is convex or has no faces.
std::string hull_warning(const MeshPart& part, const Polyhedron& hull) {
    if (part.triangles.empty() || hull.face_count() <= 2) return {};
    const std::optional<double> inside = mesh_volume(part);
    if (!inside) return "the mesh is not closed; its hull is used, hull volume / mesh volume is unknown";
    const double whole = volume(hull);
    if (*inside < single_planarity * whole) return "the mesh encloses no volume; its hull is used";
    if (*inside >= convex_volume_share * whole) return {};
    return message("the mesh is concave; its hull is used, hull volume / mesh volume = ",
                   rounded(whole / *inside, 5));
}

/// Says that the parts are convex bodies which one hull would fill up. Empty for others, such as a surface
/// that is split by material.
std::string several_bodies(const std::vector<MeshPart>& parts) {
    double inside = 0;
    for (const MeshPart& part : parts) {
        const Result<Polyhedron> hull = convex_hull(part.points);
        const std::optional<double> own = hull ? mesh_volume(part) : std::nullopt;
        if (!own || *own < convex_volume_share * volume(*hull)) return {};
        inside += *own;
    }
    const Result<Polyhedron> all = convex_hull(joined(parts).points);
    if (!all || inside >= convex_volume_share * volume(*all)) return {};
    return message(
        ": has ", parts.size(), " convex objects, and one hull would have ",
        rounded(volume(*all) / inside, 5),
        " times their volume: take each as a body (edgewise sweep --each-mesh), or write a file for each");
}

/// Each point once, in the order of the mesh.
std::vector<Vec3d> distinct(std::span<const Vec3d> points) {
    std::vector<Index> order = distinct_points(points);
    std::ranges::sort(order);
    std::vector<Vec3d> result;
    for (const Index i : order) result.push_back(points[i]);
    return result;
}

double single_step(std::span<const Vec3d> points) {
    double largest = 0;
    for (const Vec3d& point : points) largest = std::max(largest, max_abs(point));
    constexpr int bits_behind_first = 23;
    return largest > 0 ? std::ldexp(1.0, std::ilogb(largest) - bits_behind_first) : 0;
}

/// Empty where single precision is fine enough for the body.
std::string step_warning(const MeshBody& mesh) {
    constexpr double coarse = 1e-6;
    const double size = extent(mesh.points);
    if (mesh.step <= coarse * size || size == 0) return {};
    return message("read in single precision, whose steps of ", rounded(mesh.step), " there are ",
                   rounded(mesh.step / size),
                   " of the body's size; move it to the origin, or write it as OBJ, which is read in double");
}

/// Removes the numbers of vertices, which are not those of the user's file: readers number corners, and
/// geometry counts from 0.
std::string hull_error(const std::string& error) {
    const std::string text = std::regex_replace(error, std::regex("vertex [0-9]+"), "a vertex");
    return text.starts_with("flat") ? text + "; a solid is needed here: judge takes flat meshes" : text;
}

Result<MeshBody> body_of(const MeshPart& part, const MeshReading& reading) {
    if (const std::string error = coordinate_error(part.points); !error.empty())
        return Result<MeshBody>::failure(hull_error(error));
    MeshBody mesh{{}, {}, distinct(part.points)};
    Result<Polyhedron> hull = reading.takes_flat ? hull_of_any(mesh.points) : convex_hull(mesh.points);
    if (!hull) return Result<MeshBody>::failure(hull_error(hull.error));
    mesh.body = std::move(*hull);
    if (part.in_single) mesh.step = single_step(mesh.points);
    std::string warning = hull_warning(part, mesh.body);
    add_warning(warning, step_warning(mesh));
    return Result<MeshBody>::success(std::move(mesh), std::move(warning));
}

}  // namespace

Parts read_mesh_parts(const std::string& path, bool as_stored,
                      const std::optional<input::GuardLimits>& limits) {
    Parts parts = parts_of(path, as_stored, limits);
    if (!parts.error.empty()) parts.error = path + parts.error;
    if (!parts.warning.empty()) parts.warning = path + ": " + parts.warning;
    return parts;
}

Bodies read_mesh_file(const std::string& path, const MeshReading& reading) {
    Parts parts = read_mesh_parts(path, reading.as_stored);
    if (!parts) return Bodies::failure(parts.error);
    if (!reading.each_mesh && parts->size() > 1) {
        if (const std::string error = several_bodies(*parts); !error.empty())
            return Bodies::failure(path + error);
        *parts = {joined(*parts)};
    }
    const std::string stem = std::filesystem::path(path).stem().string();
    const bool several = parts->size() > 1;
    std::vector<MeshBody> bodies;
    std::string warnings = parts.warning;
    for (std::size_t k = 0; k < parts->size(); ++k) {
        const MeshPart& part = (*parts)[k];
        std::string where = path;
        if (several) where += message(" (mesh ", k + 1, part.name.empty() ? "" : " '" + part.name + "'", ")");
        Result<MeshBody> mesh = body_of(part, reading);
        if (!mesh) return Bodies::failure(where + ": " + mesh.error);
        if (!mesh.warning.empty()) add_warning(warnings, message(where, ": ", mesh.warning));
        (*mesh).name = several ? message(stem, "#", k + 1) : stem;
        bodies.push_back(std::move(*mesh));
    }
    return Bodies::success(std::move(bodies), std::move(warnings));
}

void refuse_as_stored_without_mesh(bool as_stored, std::span<const std::string> shapes) {
    if (as_stored && std::ranges::none_of(shapes, names_mesh_file))
        throw std::invalid_argument("--as-stored is for mesh files: name one, or leave it out");
}

Result<std::vector<NamedShape>> mesh_shapes(const std::string& file, const MeshReading& reading) {
    using Shapes = Result<std::vector<NamedShape>>;
    auto bodies = read_mesh_file(file, reading);
    if (!bodies) return Shapes::failure(bodies.error);
    const std::string source = std::filesystem::path(file).filename().string() +
                               (reading.as_stored ? ", as stored" : "") + ", scaled by 4/3";
    std::vector<NamedShape> shapes;
    for (MeshBody& mesh : *bodies) {
        for (Vec3d& v : mesh.body.vertices) v *= mesh_scale;
        auto hull = convex_hull(mesh.body.vertices);  // rounding moved the vertices: new faces
        if (!hull) return Shapes::failure(file + ": " + hull.error);
        shapes.push_back({mesh.name, source, *std::move(hull), {}});
    }
    return Shapes::success(std::move(shapes), bodies.warning);
}

Result<NamedShape> named_shape(const std::string& name, const MeshReading& reading) {
    using Shape = Result<NamedShape>;
    if (names_mesh_file(name)) {
        auto shapes = mesh_shapes(name, reading);
        return shapes ? Shape::success(std::move(shapes->front()), shapes.warning)
                      : Shape::failure(shapes.error);
    }
    auto body = make_shape(name);
    return body ? Shape::success({name, "built-in", *std::move(body), {}}) : Shape::failure(body.error);
}

}  // namespace edgewise::scene
