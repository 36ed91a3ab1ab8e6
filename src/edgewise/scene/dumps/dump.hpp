// SPDX-License-Identifier: MIT
//
// A pair as people post it when a library was wrong about it: a case line, or what FCL and Drake print with
// an exception. A text is read to its last figure or refused: a pose that is passed over would be the
// identity, and the exact answer that of another pair. Program code is refused. So are shapes with a curved
// surface: an answer about a polyhedron in their place would be one to another question.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/geometry/result.hpp"
#include "edgewise/scene/case_file.hpp"

namespace edgewise::scene {

/// A library's answer, as the text reports it.
struct ReportedAnswer {
    std::string who;                 ///< "FCL"
    std::string what;                ///< its message, on one line
    std::optional<double> distance;  ///< none: it threw
};

struct PastedPair {
    Case pair;
    std::string format;  ///< "case line", "FCL dump"
    std::optional<ReportedAnswer> reported;
};

/// Reads a pasted text in any format listed above. `where` begins every message. Errors name what is missing
/// and what is read; the warning says that a matrix was replaced by the nearest rotation.
[[nodiscard]] Result<PastedPair> read_pasted(std::string_view text, const std::string& where);

/// 12 or 16 numbers, row by row, the translation last in each row; the fourth row is 0 0 0 1. `name` opens
/// the error and the warning.
[[nodiscard]] Result<Pose> pose_from_rows(const std::vector<double>& numbers, const std::string& name);

/// All the numbers of a text that holds nothing else but blanks, brackets, and at most one comma or semicolon
/// between two of them. The error names what is no number.
[[nodiscard]] Result<std::vector<double>> numbers_in(std::string_view text);

}  // namespace edgewise::scene
