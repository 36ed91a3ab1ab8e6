// SPDX-License-Identifier: MIT
#include "edgewise/studies/parts/contender_name.hpp"

namespace edgewise::studies {

std::string contender_name(const std::string& algorithm, const std::string& table) {
    return (algorithm == "vclip" ? "V-Clip" : algorithm == "gjk" ? "GJK" : algorithm) + " on " + table;
}

}  // namespace edgewise::studies
