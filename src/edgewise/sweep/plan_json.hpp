// SPDX-License-Identifier: MIT
//
// Plans as JSON: those that come with Edgewise, as reports/paper/plan.json, and a user's own files.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string_view>

#include "edgewise/sweep/plan.hpp"

namespace edgewise::sweep {

/// A plan in the program; its file is found wherever the program is installed.
struct PlanText {
    std::string_view name, json;
};
[[nodiscard]] std::span<const PlanText> plan_texts();

/// The plan with what the JSON says in place of it; it has the members of Plan, but for its name. Throws
/// std::exception for what is no plan.
[[nodiscard]] Plan read_plan(const nlohmann::json& json, Plan plan);

}  // namespace edgewise::sweep
