// SPDX-License-Identifier: MIT
//
// Case files: pairs of bodies with poses, one JSON object per line:
//   {"id", "a": {"vertices": [[x,y,z]...], "faces": [[i,j,k...]...]?}, "b": {...},
//    "pose_a": {"R": [9, row-major] or [[3],[3],[3]], "t": [3]}?, "pose_b": {...}?}
// Members of a pose that are left out (or null) are the identity; faces, when present, are taken as given. A
// matrix that is nearly a rotation is replaced by the nearest one; others are refused (nearest_rotation.hpp).
// `source`, `note`, `expect` and some others may be present too; unknown members are refused. Lines
// are read one by one, so a bad line does not lose the others; each error names file, line and field.
#pragma once

#include <cstddef>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/pose.hpp"
#include "edgewise/geometry/result.hpp"

namespace edgewise::scene {

struct CaseBody {
    std::string where;  ///< for messages, e.g. "cases.jsonl:12: a"
    std::vector<Vec3d> vertices;
    std::optional<std::vector<std::vector<Index>>> faces;  ///< else: the hull of the vertices
};

struct Case {
    std::string id;  ///< as written; a number is kept as its digits
    CaseBody a, b;
    Pose pose_a, pose_b;
};

/// One line. `where` opens every message, e.g. "cases.jsonl:12"; `id` is set as soon as it could be read,
/// also when the rest of the line is bad, so that an answer can name the line it belongs to. The warning says
/// which matrix was replaced by the nearest rotation, and how far it was from one.
[[nodiscard]] Result<Case> parse_case(std::string_view line, const std::string& where, std::string& id);

/// Enough for a body of a million vertices; longer input is a stream without end, not a line.
inline constexpr std::size_t most_line_bytes = std::size_t{256} << 20;

/// Reads the stream case by case; blank lines are passed over.
class CaseReader {
  public:
    CaseReader(std::istream& stream, std::string name) : stream_(stream), name_(std::move(name)) {}

    /// Nothing at the end of the stream.
    [[nodiscard]] std::optional<Result<Case>> next();

    [[nodiscard]] std::size_t line() const { return line_; }     ///< of the last case; the first is 1
    [[nodiscard]] const std::string& id() const { return id_; }  ///< of the last case; empty if unreadable

    /// How many of the lines so far had a matrix that was replaced by the nearest rotation, and the first of
    /// them; empty if none had.
    [[nodiscard]] std::string rotation_note() const;

  private:
    /// False at the end. A line that is too long is cut there.
    bool read_line(std::string& line);

    std::istream& stream_;
    std::string name_, id_, first_replaced_;
    std::size_t line_ = 0, replaced_ = 0;  ///< replaced_: lines with such a matrix
};

/// Returns the hull of the vertices, or the faces as given. An error begins with the body's place.
[[nodiscard]] Result<Polyhedron> body_from_case(const CaseBody& body);

}  // namespace edgewise::scene
