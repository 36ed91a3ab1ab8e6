// SPDX-License-Identifier: MIT
//
// One measured number. A figure that could not be measured has no value but a reason and a remedy; it is
// never 0 and never left out.
#pragma once

#include <optional>
#include <string>

namespace edgewise::measure {

struct Figure {
    std::string name;             ///< unique within its probe, e.g. "paper_bytes_per_edge"
    std::optional<double> value;  ///< null: not measured, see reason
    std::string unit;             ///< "B/edge", "ns", "1" ...
    std::string reason = {};      ///< why there is no value
    std::string remedy = {};      ///< what would make it measurable
};

}  // namespace edgewise::measure
