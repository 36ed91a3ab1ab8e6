// SPDX-License-Identifier: MIT
//
// Compares one runner's answer to a case with exact arithmetic on the bodies that the tables hold, and
// describes every error in words. The corpus test and the fuzz targets use it.
#pragma once

#include <string>
#include <vector>

#include "edgewise/bench/runner.hpp"
#include "edgewise/scene/case_file.hpp"

namespace edgewise {

struct JudgedCase {
    std::vector<std::string> complaints;  ///< empty if the answer is right
    bool answered = false;                ///< false if the bodies were refused; `refusal` says why
    std::string refusal;
    bool apart = false, in_band = false;
    double distance = 0, witness = 0, depth = 0;  ///< errors over scale, beyond the band
};

/// Accuracy of a table type, which decides the errors that an answer may have.
struct Exactness {
    double eps = 0;               ///< rounding step of the arithmetic
    bool rounded_planes = false;  ///< planes are stored with less precision
};

/// Checks the verdict outside the band, distance, witness points, depth, and the certificates of the stored
/// and of the given bodies.
[[nodiscard]] JudgedCase judge_case(bench::Runner& runner, const Exactness& exactness,
                                    const scene::Case& given);

}  // namespace edgewise
