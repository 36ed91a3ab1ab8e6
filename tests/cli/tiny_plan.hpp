// SPDX-License-Identifier: MIT
//
// A plan of a few comparisons and hard cases, which takes seconds, for tests of campaigns in parts.
#pragma once

namespace edgewise::cli_test {

inline constexpr const char* tiny_plan =
    R"({"scenes": [{"name": "cold"}, {"name": "tumble"}, {"name": "static"}],
    "shapes": ["cube8", "sphere18"], "meshes": [], "layouts": ["aos_f64", "lean_f32"],
    "algorithms": ["vclip", "gjk"], "axes": [], "machines": [],
    "queries": 100, "checked": 20, "rounds": 2, "stability": 2})";

}  // namespace edgewise::cli_test
