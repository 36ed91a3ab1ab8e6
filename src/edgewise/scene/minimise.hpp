// SPDX-License-Identifier: MIT
//
// A smaller pair on which something still goes wrong: fewer vertices, no faces, simpler poses, rounder
// numbers. Delta debugging (Zeller and Hildebrandt 2002, "Simplifying and Isolating Failure-Inducing Input",
// ddmin) on the vertices, then one number after the other; repeated until nothing gets simpler. Nothing here
// knows what goes wrong: the caller's predicate does.
#pragma once

#include <cstddef>
#include <functional>

#include "edgewise/scene/case_file.hpp"

namespace edgewise::scene {

/// Returns true if the case still fails. It must be true for the given case. It is also called for bodies
/// that a test refuses (flat ones, for example), and may return false for them.
using StillFails = std::function<bool(const Case&)>;

struct Minimised {
    Case pair;
    std::size_t tried = 0;  ///< how many cases were asked about
    bool at_limit = false;  ///< stopped there: a still smaller one may exist
};

/// Deterministic. Asks at most `most_tries` times.
[[nodiscard]] Minimised minimise(const Case& failing, const StillFails& still_fails,
                                 std::size_t most_tries = 20000);

/// Figures that a reader sees of a case: vertices, and significant digits of all numbers together, but those
/// of rotations. Smaller is simpler.
struct CaseSize {
    std::size_t vertices = 0, digits = 0;
};
[[nodiscard]] CaseSize size_of(const Case& pair);

}  // namespace edgewise::scene
