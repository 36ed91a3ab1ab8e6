// SPDX-License-Identifier: MIT
#include "edgewise/reports/answer/scene_words.hpp"

#include <fmt/core.h>

#include "edgewise/reports/scene_label.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

/// Returns "12 bodies" if the scene says how many.
std::string bodies_of(const ReportCell& cell) {
    const auto bodies = parameter_of(cell, "bodies");
    return bodies ? plural(static_cast<std::size_t>(*bodies), "body", "bodies") : "bodies";
}

std::string turn_of(const ReportCell& cell) {
    if (parameter_of(cell, "random_orientation") == 1) return "turn at random in every step";
    const auto turn = parameter_of(cell, "rotation_step");
    return turn ? fmt::format("turn by {:g} rad per step", *turn) : "turn";
}

std::string motion_of(const ReportCell& cell) {
    const std::string kind = scene_kind(cell), bodies = bodies_of(cell);
    if (kind == "static") return fmt::format("{} at rest, every pair new, from sweep and prune", bodies);
    if (kind == "cold") return "independent random pairs, every query new";
    if (kind == "gap") return "independent random pairs at given gaps, every query new";
    if (kind == "tumble")
        return fmt::format("{} drift and {}, pairs followed from step to step", bodies, turn_of(cell));
    if (kind == "proximity") return fmt::format("pairs that stay close and {}", turn_of(cell));
    if (kind == "pressure")
        return fmt::format("{} in a row {}, neighbours asked in turn", bodies, turn_of(cell));
    return kind;
}

}  // namespace

std::string scene_kind(const ReportCell& cell) {
    return cell.scene_kind.empty() ? cell.scene : cell.scene_kind;
}

bool has_own_tables(const ReportCell& cell) {
    return scene_kind(cell) == "pressure" || parameter_of(cell, "own_tables") == 1;
}

std::string scene_sentence(const ReportCell& cell) {
    return fmt::format("{}; {}", motion_of(cell),
                       has_own_tables(cell) ? "a table for each body" : "one shared table");
}

}  // namespace edgewise::reports
