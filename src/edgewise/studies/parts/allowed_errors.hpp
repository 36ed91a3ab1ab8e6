// SPDX-License-Identifier: MIT
//
// Errors allowed for a cell on hard and foreign pairs. The limits of a sweep's own scenes follow from the
// arithmetic alone (sweep/prepared_cell.hpp).
#pragma once

#include <string_view>

#include "edgewise/bench/registry.hpp"
#include "edgewise/truth/checked_answer.hpp"

namespace edgewise::studies {

[[nodiscard]] inline truth::AllowedErrors allowed_errors(const bench::TableType& type,
                                                         std::string_view algorithm) {
    return truth::allowed_errors(type.eps, type.rounded_planes && algorithm == "vclip");
}

}  // namespace edgewise::studies
