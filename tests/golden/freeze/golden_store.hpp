// SPDX-License-Identifier: MIT
//
// A store with the same figures wherever it is made. The program sweeps a small plan in two parts and merges
// them; all its figures are modelled. The times are made up.
#pragma once

#include <string>

#include "program.hpp"

namespace edgewise::golden {

/// Makes the store in this folder and returns its path.
[[nodiscard]] std::string make_golden_store(const cli_test::Folder& folder);

}  // namespace edgewise::golden
