// SPDX-License-Identifier: MIT
#include "edgewise/scene/mesh/mesh_parts.hpp"

#include <filesystem>

#include "edgewise/input/file_text.hpp"
#include "edgewise/scene/mesh/mesh_text.hpp"

namespace edgewise::scene {
namespace {

using Parts = Result<std::vector<MeshPart>>;

constexpr std::uint64_t most_mesh_bytes = std::uint64_t{1} << 30;

/// Assimp keeps what it reads several times over, in nodes of its own; text of a megabyte takes it 0.1 s.
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
    const std::string ending = lowered(std::filesystem::path(path).extension().string());
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

}  // namespace

Parts read_mesh_parts(const std::string& path, bool as_stored,
                      const std::optional<input::GuardLimits>& limits) {
    Parts parts = parts_of(path, as_stored, limits);
    if (!parts.error.empty()) parts.error = path + parts.error;
    if (!parts.warning.empty()) parts.warning = path + ": " + parts.warning;
    return parts;
}

}  // namespace edgewise::scene
