// SPDX-License-Identifier: MIT
//
// The contents of a mesh file, as plain points and triangles in the file's world frame.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/result.hpp"
#include "edgewise/input/guarded.hpp"

namespace edgewise::scene {

struct MeshPart {
    std::string name;
    std::vector<Vec3d> points;
    std::vector<std::array<Index, 3>> triangles;  ///< polygons as fans; none for points and lines
    bool in_single = false;                       ///< the format or its reader keeps single precision
};
using Parts = Result<std::vector<MeshPart>>;

/// OBJ and STL files by the readers here, all others by Assimp in a child process: under the limits that the
/// file's size allows, or under these. `as_stored`: a COLLADA file's up axis and unit are left out. The error
/// and the warning are one line each, and begin with the path; errors about a line with "path:LINE: ".
[[nodiscard]] Parts read_mesh_parts(const std::string& path, bool as_stored = false,
                                    const std::optional<input::GuardLimits>& limits = {});

// Functions of single formats. Errors begin with ":LINE: " where they are about a line, else with ": ".

/// The parts of an OBJ text, in double (Assimp and Debian's tinyobjloader read single precision, take 0,5 for
/// a number and name no line). A new object (o), group (g) or material (usemtl) begins a part. A part has the
/// vertices that its faces, lines and points name, in the order of the file; the warning counts those that
/// no element names. If no element names any, all vertices count, each in the part in which it is listed.
[[nodiscard]] Parts obj_parts(std::string_view text);

/// One part for each solid of an STL file: text in double, whatever the case of its keywords, or binary,
/// which stores single precision. Assimp refuses both without a reason where a count or a keyword is not as
/// it expects.
[[nodiscard]] Parts stl_parts(std::string_view bytes);

/// Returns an error of the file at that path; empty if none. Its ending or first letters give the format:
/// the sizes in its header are compared with its bytes before a parser reserves memory for it or looks for
/// lines that are not there. PLY (paulbourke.net/dataformats/ply) and OFF (paulbourke.net/dataformats/off).
[[nodiscard]] std::string mesh_header_error(const std::string& path);
/// Takes the path's ending, the file's first bytes and its size in bytes instead of a path.
[[nodiscard]] std::string mesh_header_error(const std::string& ending, const std::string& head,
                                            std::uint64_t bytes);

/// Bytes of a PLY scalar; 1 of an unknown one.
[[nodiscard]] std::uint64_t ply_bytes(std::string_view type);

/// Returns an error in the rows of a PLY or OFF file that passed mesh_header_error; empty if none.
/// Assimp takes a row of a face for a vertex where a count is off by one, and 0,5 for a number.
[[nodiscard]] std::string ply_rows_error(std::string_view bytes);
[[nodiscard]] std::string off_rows_error(std::string_view text);

/// The parts of a file that Assimp reads, in a separate process: one for each use of a mesh by a node, with
/// the transforms of all nodes above it applied in double. Fails if Assimp cannot read the file, or if its
/// reader takes more than the limits. The warning says what was done to a COLLADA file's axes and unit, which
/// `as_stored` leaves out.
[[nodiscard]] Parts assimp_parts(const std::string& path, bool as_stored, const input::GuardLimits& limits);

/// Parts, or an error, as the bytes that Assimp's process sends to this one; and back, where bytes that are
/// cut short are an error.
[[nodiscard]] std::string bytes_of(const Parts& parts);
[[nodiscard]] Parts parts_from(std::string_view bytes);

}  // namespace edgewise::scene
