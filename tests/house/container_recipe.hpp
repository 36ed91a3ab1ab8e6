// SPDX-License-Identifier: MIT
//
// The container's recipe, line by line: where no builder of images runs, this is what is known of it.
#pragma once

#include <string>
#include <vector>

#include "source_tree.hpp"

namespace edgewise::house {

struct Instruction {
    std::size_t line = 0;  ///< from 1
    std::string name;      ///< "RUN"
    std::string rest;      ///< in one line
};

/// Comments left out, continued lines joined.
[[nodiscard]] std::vector<Instruction> instructions_of(const SourceFile& recipe);

/// An instruction that recipes do not have; one before FROM that is not ARG; no FROM, or one of another
/// system than Debian 12; what is copied or run and not in the tree; packages that are not installed by the
/// project's own script; a variable that no ARG or ENV sets; no ENTRYPOINT.
[[nodiscard]] std::vector<Violation> recipe_faults(const SourceFile& recipe,
                                                   const std::vector<SourceFile>& tree);

}  // namespace edgewise::house
