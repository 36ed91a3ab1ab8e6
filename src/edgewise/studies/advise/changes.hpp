// SPDX-License-Identifier: MIT
//
// What another question would change in an advice: the tables shared the other way, a larger error allowed, a
// smaller one asked for.
#pragma once

#include <string>
#include <vector>

#include "edgewise/studies/advise/screen.hpp"

namespace edgewise::studies::advise {

/// The recommended cell.
struct Taken {
    std::string name;  ///< "V-Clip on lean_f32"
    double bytes_per_edge = 0, error = 0;
};

/// Returns one sentence per change. `other_tables`: cells that pass with the tables shared the other way,
/// fastest first; null: the other sharing was not looked at.
[[nodiscard]] std::vector<std::string> what_would_change(const CaseAsked& asked, const Screen& screen,
                                                         const std::vector<ScreenedCell>& other_tables,
                                                         const Taken& taken);

}  // namespace edgewise::studies::advise
