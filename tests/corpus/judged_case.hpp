// SPDX-License-Identifier: MIT
//
// One case through one runner, beside exact arithmetic on the bodies that the tables hold: everything that
// can be wrong with an answer, in words. The corpus test and the fuzz targets judge by it.
#pragma once

#include <string>
#include <vector>

#include "edgewise/bench/runner.hpp"
#include "edgewise/scene/case_file.hpp"

namespace edgewise {

struct JudgedCase {
    std::vector<std::string> complaints;  ///< none: all is right
    bool answered = false;                ///< else the bodies were refused, and `refusal` says why
    std::string refusal;
    bool apart = false, in_band = false;
    double distance = 0, witness = 0, depth = 0;  ///< errors over scale, beyond the band
};

/// What decides the errors that an answer is allowed.
struct Exactness {
    double eps = 0;               ///< rounding step that computes
    bool rounded_planes = false;  ///< the planes are rounder
};

/// Verdict outside the band, distance, witness points, depth, and the certificates of the stored and of the
/// given bodies.
[[nodiscard]] JudgedCase judge_case(bench::Runner& runner, const Exactness& exactness,
                                    const scene::Case& given);

}  // namespace edgewise
