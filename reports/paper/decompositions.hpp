// SPDX-License-Identifier: MIT
//
// Ways to reach the paper's 168 bytes per edge. The paper gives the sum and not its terms: what is known,
// what is not, and which reading this program takes.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace edgewise::reports {

struct Decomposition {
    std::string_view terms;
    double in_double, in_single;  ///< bytes per edge
    std::string_view remark;
};

[[nodiscard]] const std::vector<Decomposition>& decompositions();

[[nodiscard]] nlohmann::json decompositions_json();
/// A short table with what is known about it.
[[nodiscard]] std::string decompositions_text();

}  // namespace edgewise::reports
