// SPDX-License-Identifier: MIT
#include "edgewise/studies/advise/case_asked.hpp"

#include <fmt/format.h>

#include "edgewise/scene/scenes.hpp"

namespace edgewise::studies::advise {

sweep::SceneChoice tumbling(std::size_t bodies, double rotation_step) {
    return {
        "tumble",
        {{"bodies", static_cast<double>(bodies)}, {"rotation_step", rotation_step}, {"in_time_order", 1}}};
}

bool can_share(const CaseAsked& asked) {
    return scene::complete_parameters(asked.scene.name, {{"own_tables", 1.0}}).value.has_value();
}

sweep::SceneChoice scene_of(const CaseAsked& asked) {
    sweep::SceneChoice scene = asked.scene;
    if (can_share(asked)) scene.parameters["own_tables"] = asked.own_tables ? 1 : 0;
    return scene;
}

std::string sentence_of(const CaseAsked& asked) {
    const auto complete = scene::complete_parameters(asked.scene.name, asked.scene.parameters);
    std::string numbers;
    for (const char* name : {"bodies", "rotation_step"}) {
        if (complete && complete->contains(name)) numbers += fmt::format(", {} {}", name, complete->at(name));
    }
    const std::string tables = !can_share(asked)  ? ""
                               : asked.own_tables ? ", a table each"
                                                  : ", one table for all";
    return fmt::format("{}{}, {} vertices ({}){}, {}, error <= {}", asked.scene.name, numbers,
                       asked.shape.body.vertex_count(), asked.shape.name, tables, to_string(asked.needs),
                       asked.error_limit);
}

}  // namespace edgewise::studies::advise
