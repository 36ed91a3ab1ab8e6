// SPDX-License-Identifier: MIT
//
// Assimp's scene tree, flattened. No post-processing is asked for: polygons become fans here, which gives the
// same signed volume, and equal points are welded where it matters. It runs in a child process under limits:
// some of its readers never end on damaged files, or take all memory.
#include "edgewise/scene/mesh/mesh_parts.hpp"

#include <assimp/commonMetaData.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <cstdint>
#include <cstring>
#include <exception>
#include <new>
#include <type_traits>

#include "edgewise/geometry/message.hpp"
#include "edgewise/geometry/pose.hpp"

namespace edgewise::scene {
namespace {

void put(std::string& to, const void* data, std::size_t bytes) {
    if (bytes > 0) to.append(static_cast<const char*>(data), bytes);
}
void put(std::string& to, std::uint64_t number) { put(to, &number, sizeof number); }
void put(std::string& to, const std::string& text) {
    put(to, text.size());
    put(to, text.data(), text.size());
}

/// Takes values from the front; once one is missing, all are.
class Taker {
  public:
    explicit Taker(std::string_view bytes) : rest_(bytes) {}

    void take(void* to, std::size_t bytes) {
        whole_ = whole_ && bytes <= rest_.size();
        if (!whole_ || bytes == 0) return;
        std::memcpy(to, rest_.data(), bytes);
        rest_.remove_prefix(bytes);
    }
    std::uint64_t number() {
        std::uint64_t value = 0;
        take(&value, sizeof value);
        return whole_ ? value : 0;
    }
    /// Reads a count and that number of items; returns no items if the rest is too short for them.
    template <class Items>
    Items items() {
        const std::uint64_t count = number();
        whole_ = whole_ && count <= rest_.size() / sizeof(typename Items::value_type);
        Items all(whole_ ? count : 0, typename Items::value_type{});
        take(all.data(), all.size() * sizeof(typename Items::value_type));
        return all;
    }
    [[nodiscard]] bool whole() const { return whole_; }

  private:
    std::string_view rest_;
    bool whole_ = true;
};

using Parts = Result<std::vector<MeshPart>>;

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

/// What a COLLADA file's root does to the file's coordinates: Assimp puts the unit and the up axis there and
/// nothing else.
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

/// In the child.
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
    std::string bytes;
    put(bytes, parts.error);
    put(bytes, parts.warning);
    put(bytes, parts ? parts->size() : 0);
    if (!parts) return bytes;
    for (const MeshPart& part : *parts) {
        put(bytes, part.name);
        put(bytes, 3 * part.points.size());
        for (const Vec3d& point : part.points) put(bytes, point.data(), 3 * sizeof(double));
        put(bytes, 3 * part.triangles.size());
        for (const auto& triangle : part.triangles) put(bytes, triangle.data(), 3 * sizeof(Index));
        put(bytes, std::uint64_t{part.in_single});
    }
    return bytes;
}

Parts parts_from(std::string_view bytes) {
    Taker taker(bytes);
    if (std::string error = taker.items<std::string>(); !error.empty()) return Parts::failure(error);
    std::string warning = taker.items<std::string>();
    std::vector<MeshPart> parts;
    for (std::uint64_t left = taker.number(); left > 0 && taker.whole(); --left) {
        MeshPart& part = parts.emplace_back();
        part.name = taker.items<std::string>();
        const auto coordinates = taker.items<std::vector<double>>();
        for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3)
            part.points.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
        const auto corners = taker.items<std::vector<Index>>();
        for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
            part.triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
        part.in_single = taker.number() != 0;
    }
    if (!taker.whole())
        return Parts::failure(": cannot be read as a mesh: the reader's answer was cut short");
    return Parts::success(std::move(parts), std::move(warning));
}

Parts assimp_parts(const std::string& path, bool as_stored, const input::GuardLimits& limits) {
    const auto bytes = input::run_guarded([&] { return parts_as_bytes(path, as_stored); }, limits);
    if (!bytes) return Parts::failure(": cannot be read as a mesh: its reader " + bytes.error);
    return parts_from(*bytes);
}

}  // namespace edgewise::scene
