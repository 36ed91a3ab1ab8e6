// SPDX-License-Identifier: MIT
//
// What the algorithms' own source says of how hard they are to implement: counted at every build
// (cmake/count_source.cmake).
#pragma once

#include <string>
#include <vector>

namespace edgewise::reports {

struct SourceFacts {
    std::string algorithm;
    int files = 0, code_lines = 0;        ///< neither blank nor comment
    std::vector<std::string> tolerances;  ///< distinct names
};

[[nodiscard]] std::vector<SourceFacts> source_facts();

}  // namespace edgewise::reports
