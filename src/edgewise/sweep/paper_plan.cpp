// SPDX-License-Identifier: MIT
#include "edgewise/sweep/paper_plan.hpp"

#include <algorithm>

#include "edgewise/bench/registry.hpp"

namespace edgewise::sweep {

namespace {

using Names = std::vector<std::string>;

/// A program may have been built with some layouts only.
Names present(const Names& wanted) {
    Names names;
    for (const std::string& name : wanted) {
        const auto types = bench::table_types();
        const auto is_it = [&](const bench::TableType& type) { return type.name == name; };
        if (std::any_of(types.begin(), types.end(), is_it)) names.push_back(name);
    }
    return names;
}

SceneChoice scene(const char* file, const Names& layouts, const Names& axes = {}) {
    SceneChoice choice{file, {}};
    choice.layouts = present(layouts);
    choice.axes = axes;
    choice.plain = axes.empty();
    return choice;
}

}  // namespace

std::vector<SceneChoice> paper_scenes() {
    const Names both = {"aos_f64", "lean_f64"};
    const Names timed = {"aos_f64", "aos_f32", "lean_f64", "points_neighbours_f64"};
    std::vector<SceneChoice> scenes = {
        scene("paper_static", {"aos_f64", "aos_f32", "linked_f64", "lean_f64", "points_neighbours_f64"}),
        scene("paper_linear_8", both),
        scene("paper_bodies", both),
        scene("paper_bodies_shrinking", both),
        scene("paper_angular_8", timed, {"sharing=shared"}),
        scene("paper_angular_38", timed, {"sharing=shared"}),
        scene("paper_angular_386", timed, {"sharing=shared"}),
        scene("paper_proximity", timed),
        scene("paper_complexity", both),
        scene("paper_cold", both),
        scene("paper_needs", both,
              {"needs=verdict", "needs=distance", "needs=features", "needs=depth", "needs=certificate"}),
        scene("paper_caches_here", both)};
    for (const char* name : {"paper_thrash_8", "paper_thrash_38", "paper_thrash_386"}) {
        scenes.push_back(scene(name, {"aos_f64", "linked_f64", "lean_f64"},
                               {"sharing=shared", "order=bfs", "order=spatial"}));
        scenes.back().caches = {"all"};
    }
    std::erase_if(scenes, [](const SceneChoice& choice) { return choice.layouts.empty(); });
    return scenes;
}

}  // namespace edgewise::sweep
