// SPDX-License-Identifier: MIT
//
// Case files: pairs of bodies with poses, one JSON object per line:
//   {"id", "a": {"vertices": [[x,y,z]...], "faces": [[i,j,k...]...]?}, "b": {...},
//    "pose_a": {"R": [9, row-major], "t": [3]}?, "pose_b": {...}?}
// Poses are the identity when left out (or null); faces, when present, are taken as given. Other keys are
// ignored. Line by line, so that one bad line does not lose the rest; each error names file, line and field.
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
/// also when the rest of the line is bad, so that an answer can name the line it belongs to.
[[nodiscard]] Result<Case> parse_case(std::string_view line, const std::string& where, std::string& id);

/// A body of a million vertices has no more; what is longer is no line but a stream without end.
inline constexpr std::size_t most_line_bytes = std::size_t{256} << 20;

/// Reads the stream case by case; blank lines are passed over.
class CaseReader {
  public:
    CaseReader(std::istream& stream, std::string name) : stream_(stream), name_(std::move(name)) {}

    /// Nothing at the end of the stream.
    [[nodiscard]] std::optional<Result<Case>> next();

    [[nodiscard]] std::size_t line() const { return line_; }     ///< of the last case; the first is 1
    [[nodiscard]] const std::string& id() const { return id_; }  ///< of the last case; empty if unreadable

  private:
    /// False at the end. A line that is too long is cut there.
    bool read_line(std::string& line);

    std::istream& stream_;
    std::string name_, id_;
    std::size_t line_ = 0;
};

/// The hull of the vertices, or the faces as given; an error opens with where the body stands.
[[nodiscard]] Result<Polyhedron> body_from_case(const CaseBody& body);

}  // namespace edgewise::scene
