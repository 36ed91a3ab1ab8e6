// SPDX-License-Identifier: MIT
//
// The scenes by name: what each is for, its parameters with their defaults and bounds (kinds/kinds.json), and
// how to make one (kinds/scene_*.cpp).
//
// A body's *size* is its extent (the diagonal of its axis-aligned box); its *centre* the mean of its
// vertices, a point inside. Bodies turn about their centre, and boxes and walls hold the centres, so that a
// thin body in a box of the right occupancy may stick out instead of not fitting.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/geometry/result.hpp"
#include "edgewise/scene/workload.hpp"

namespace edgewise::scene {

struct ParameterInfo {
    std::string name, unit, meaning;
    double standard;   ///< value when none is given
    double low, high;  ///< bounds, both allowed
    bool whole;        ///< whole numbers only
};

struct SceneInfo {
    std::string name, meaning;
    bool warm;          ///< pairs keep their cache from query to query
    bool places_pairs;  ///< by their distance: needs the function
    std::vector<ParameterInfo> parameters;
};

/// The text of kinds.json.
extern const char* const kind_texts;
[[nodiscard]] const std::vector<SceneInfo>& list_scenes();

/// The given parameters with the defaults of the others: the full identity of a scene. Unknown names and
/// values out of bounds are errors that list what is known.
[[nodiscard]] Result<SceneParameters> complete_parameters(std::string_view scene,
                                                          const SceneParameters& given);

/// Exactly `query_count` queries, or more where the parameter least_steps asks for them. Same arguments, same
/// bits, on every machine; `distance` is asked by the scenes that place pairs by it: `cold`, `gap` and
/// `proximity`.
[[nodiscard]] Result<Workload> make_scene(std::string_view scene, const Polyhedron& shape,
                                          const SceneParameters& given, std::uint64_t seed,
                                          std::size_t query_count, const DistanceFunction& distance);

}  // namespace edgewise::scene
