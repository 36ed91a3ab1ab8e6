// SPDX-License-Identifier: MIT
//
// What a scene is called: its name and the parameters that make it another scene than its kind's standard
// one. A label depends on the cell alone, never on what else a store holds.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "edgewise/store/rows.hpp"

namespace edgewise::reports {

/// A parameter's value that is not written in a label, unless it is what tells scenes of its kind apart.
struct SceneStandard {
    std::string_view kind, parameter;
    double value;
    bool always_said = false;
};
/// Those of `edgewise list scenes`; a test of the command line holds the two together.
[[nodiscard]] std::span<const SceneStandard> scene_standards();

/// "tumble (rotation_step 0.1, bodies 100)"; of a scene file, whose text is its JSON, its name and the value
/// of what it varies: "more_bodies (bodies 200)".
[[nodiscard]] std::string scene_label(const store::CellRow& cell, const std::string& file_text = {});

/// A number among the cell's scene parameters; null where there is none of that name.
[[nodiscard]] std::optional<double> parameter_of(const store::CellRow& cell, const std::string& name);

}  // namespace edgewise::reports
