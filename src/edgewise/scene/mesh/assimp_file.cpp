// SPDX-License-Identifier: MIT
//
// Assimp's scene tree, flattened. No post-processing is asked for: polygons become fans here, which gives the
// same signed volume, and equal points are welded where it matters. It runs in a child process under limits:
// some of its readers never end on damaged files, or take all memory.
#include "edgewise/scene/mesh/mesh_parts.hpp"

#include <assimp/commonMetaData.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <cstring>
#include <exception>
#include <new>
#include <nlohmann/json.hpp>
#include <span>
#include <type_traits>

#include "edgewise/geometry/message.hpp"
#include "edgewise/geometry/pose.hpp"

namespace edgewise::scene {
namespace {

using Json = nlohmann::json;

/// The items as they lie in memory.
template <class Item>
Json binary(const std::vector<Item>& items) {
    const auto bytes = std::as_bytes(std::span(items));
    const auto* const first = reinterpret_cast<const std::uint8_t*>(bytes.data());
    return Json::binary(std::vector<std::uint8_t>(first, first + bytes.size()));
}

template <class Item>
std::vector<Item> items_of(const Json& json) {
    const std::vector<std::uint8_t>& bytes = json.get_binary();
    std::vector<Item> items(bytes.size() / sizeof(Item));
    std::memcpy(static_cast<void*>(items.data()), bytes.data(), items.size() * sizeof(Item));
    return items;
}

/// A node's map. Its matrix need not be a rotation.
Pose from_assimp(const aiMatrix4x4& m) {
    Pose map;
    map.rotation << double{m.a1}, double{m.a2}, double{m.a3}, double{m.b1}, double{m.b2}, double{m.b3},
        double{m.c1}, double{m.c2}, double{m.c3};
    map.translation = Vec3d(double{m.a4}, double{m.b4}, double{m.c4});
    return map;
}

Pose after(const Pose& outer, const Pose& inner) {
    return {multiply(outer.rotation, inner.rotation), outer.apply(inner.translation)};
}

bool mirrors(const Pose& map) {
    const Vec3d x = map.rotation.col(0);
    const Vec3d y = map.rotation.col(1);
    return dot(cross(x, y), map.rotation.col(2)) < 0;
}

/// Adds the triangles of one face; false if it names a vertex that does not exist.
bool add_fan(const aiFace& face, bool mirrored, MeshPart& part) {
    for (unsigned k = 0; k < face.mNumIndices; ++k) {
        if (face.mIndices[k] >= part.points.size()) return false;
    }
    for (unsigned k = 1; k + 1 < face.mNumIndices; ++k) {
        const Index second = face.mIndices[mirrored ? k + 1 : k];
        const Index third = face.mIndices[mirrored ? k : k + 1];
        part.triangles.push_back({face.mIndices[0], second, third});
    }
    return true;
}

/// False if the mesh contradicts itself.
bool add_part(const aiMesh& mesh, const Pose& map, std::vector<MeshPart>& parts) {
    MeshPart part{mesh.mName.C_Str(), {}, {}, std::is_same_v<ai_real, float>};
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
        const aiVector3D& p = mesh.mVertices[v];
        const Vec3d raw(double{p.x}, double{p.y}, double{p.z});
        part.points.push_back(raw.array().isFinite().all() ? map.apply(raw)
                                                           : raw);  // for the error line: Inf * 0 is NaN
    }
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        if (!add_fan(mesh.mFaces[f], mirrors(map), part)) return false;
    }
    if (!part.points.empty()) parts.push_back(std::move(part));
    return true;
}

bool add_node(const aiScene& scene, const aiNode& node, const Pose& above, std::vector<MeshPart>& parts) {
    const Pose map = after(above, from_assimp(node.mTransformation));
    for (unsigned k = 0; k < node.mNumMeshes; ++k) {
        if (node.mMeshes[k] >= scene.mNumMeshes) return false;
        if (!add_part(*scene.mMeshes[node.mMeshes[k]], map, parts)) return false;
    }
    for (unsigned k = 0; k < node.mNumChildren; ++k) {
        if (!add_node(scene, *node.mChildren[k], map, parts)) return false;
    }
    return true;
}

/// Assimp's reason on one line.
std::string one_line(std::string reason) {
    reason = reason.substr(0, reason.find_first_of("\r\n"));
    return reason.empty() ? "unknown reason" : reason;
}

/// Says how the root of a COLLADA file changes the file's coordinates: Assimp puts the unit and the up axis
/// there and nothing else.
std::string change_by_root(const aiMatrix4x4& root) {
    const float scale = aiVector3D(root.a1, root.b1, root.c1).Length();
    const char* const up = root.b3 > 0 ? "Z" : root.b1 > 0 ? "X" : "Y";
    const std::string turned = *up == 'Y' ? "" : message("turned from ", up, " up to Y up");
    const std::string scaled = scale == 1 ? "" : message("scaled by ", scale);
    if (turned.empty() && scaled.empty()) return {};
    const bool both = !turned.empty() && !scaled.empty();
    return message(turned, both ? " and " : "", scaled, " as the file says; --as-stored leaves ",
                   both ? "both" : "that", " out");
}

bool is_collada(const aiScene& scene) {
    aiString format;
    return scene.mMetaData != nullptr && scene.mMetaData->Get(AI_METADATA_SOURCE_FORMAT, format) &&
           std::string_view(format.C_Str()).starts_with("Collada");
}

Parts parts_of(const std::string& path, bool as_stored) {
    Assimp::Importer importer;
    for (const char* read_here : {"obj", "stl"}) importer.UnregisterLoader(importer.GetImporter(read_here));
    const aiScene* scene = importer.ReadFile(path, 0);
    if (scene == nullptr)
        return Parts::failure(": cannot be read as a mesh: " + one_line(importer.GetErrorString()));
    std::vector<MeshPart> parts;
    std::string change;
    if (aiNode* const root = scene->mRootNode; root != nullptr) {
        if (is_collada(*scene) && !as_stored) change = change_by_root(root->mTransformation);
        if (is_collada(*scene) && as_stored) root->mTransformation = aiMatrix4x4();
        if (!add_node(*scene, *root, {}, parts))
            return Parts::failure(": is damaged: a face names a vertex that does not exist");
    }
    if (parts.empty()) return Parts::failure(": has no mesh inside");
    return Parts::success(std::move(parts), change);
}

/// Runs in the child process.
std::string parts_as_bytes(const std::string& path, bool as_stored) {
    try {
        return bytes_of(parts_of(path, as_stored));
    } catch (const std::bad_alloc&) {
        throw;  // the memory limit reports it
    } catch (const std::exception& thrown) {
        return bytes_of(Parts::failure(": cannot be read as a mesh: " + one_line(thrown.what())));
    } catch (...) {
        return bytes_of(Parts::failure(": cannot be read as a mesh: the reader failed"));
    }
}

}  // namespace

std::string bytes_of(const Parts& parts) {
    Json all = Json::array();
    for (std::size_t k = 0; parts && k < parts->size(); ++k) {
        const MeshPart& part = (*parts)[k];
        all.push_back({part.name, binary(part.points), binary(part.triangles), part.in_single});
    }
    std::string bytes;
    Json::to_cbor({{"error", parts.error}, {"warning", parts.warning}, {"parts", all}}, bytes);
    return bytes;
}

Parts parts_from(std::string_view bytes) {
    try {
        const Json json = Json::from_cbor(bytes);
        if (const std::string error = json.at("error"); !error.empty()) return Parts::failure(error);
        std::vector<MeshPart> parts;
        for (const Json& part : json.at("parts"))
            parts.push_back({part.at(0), items_of<Vec3d>(part.at(1)),
                             items_of<std::array<Index, 3>>(part.at(2)), part.at(3)});
        return Parts::success(std::move(parts), json.at("warning"));
    } catch (const Json::exception&) {
        return Parts::failure(": cannot be read as a mesh: the reader's answer was cut short");
    }
}

Parts assimp_parts(const std::string& path, bool as_stored, const input::GuardLimits& limits) {
    const auto bytes = input::run_guarded([&] { return parts_as_bytes(path, as_stored); }, limits);
    if (!bytes) return Parts::failure(": cannot be read as a mesh: its reader " + bytes.error);
    return parts_from(*bytes);
}

}  // namespace edgewise::scene
