// SPDX-License-Identifier: MIT
//
// The reader's question to the report: which layout to take, for which bodies, and how exact.
#pragma once

#include <optional>
#include <string>

namespace edgewise::reports {

struct Question {
    double error_limit = 1e-6;  ///< largest allowed error of a distance, over the scale of the pair
    std::optional<std::string> shape = {};  ///< null: each scene's reference shape
    std::optional<bool> own_tables = {};    ///< a table for each body, or one for all; null: both
};

}  // namespace edgewise::reports
