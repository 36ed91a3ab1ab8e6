// SPDX-License-Identifier: MIT
//
// A pair as people post it when a library was wrong about it: a case line, what FCL and Drake print with an
// exception, or the code of a report for Coal, hpp-fcl, FCL or Bullet. Shapes with a curved surface are
// refused: an answer about a polyhedron in their place would be one to another question.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "edgewise/geometry/result.hpp"
#include "edgewise/scene/case_file.hpp"

namespace edgewise::scene {

/// What the text says that a library answered.
struct ReportedAnswer {
    std::string who;                 ///< "FCL"
    std::string what;                ///< its message, on one line
    std::optional<double> distance;  ///< none: it threw
};

struct PastedPair {
    Case pair;
    std::string format;  ///< "case line", "FCL dump", "code"
    std::optional<ReportedAnswer> reported;
};

/// Whichever of them it is. `where` opens every message. Errors name what is missing and what is read.
[[nodiscard]] Result<PastedPair> read_pasted(std::string_view text, const std::string& where);

/// "Shape 1: ... X_FS1 ... Shape 2: ... X_FS2 ...", as FCL's ThrowDetailedConfiguration prints it: since 2019
/// with columns apart by blanks, since 2023 as C++ with commas.
[[nodiscard]] Result<PastedPair> read_fcl_dump(std::string_view text, const std::string& where);

/// Lines of C++ or Python that make two shapes and place them: boxes by their sides (btBoxShape: half of
/// them), vertices as btVector3 or as rows of an array, poses by setTranslation, setRotation, setOrigin,
/// setBasis, translation() <<, rotation() <<. Which body a pose is of its name says: 1 or 2, a or b.
[[nodiscard]] Result<PastedPair> read_code_dump(std::string_view text, const std::string& where);

/// The eight corners.
[[nodiscard]] std::vector<Vec3d> box_corners(double x, double y, double z);

/// Empty, or which curved shape a text names first, with what to do.
[[nodiscard]] std::string curved_shape(std::string_view text);

}  // namespace edgewise::scene
