// SPDX-License-Identifier: MIT
//
// Figures of merit of a store, one stable line each, for the harnesses of computing centres (ReFrame,
// Benchpark, Ramble): FOM name = value unit.
#pragma once

#include <string>

namespace edgewise::cli {

/// On stdout: cells verified and failed, answers checked and wrong, and of every algorithm on every table
/// type the geometric mean, over the comparisons it is in, of its time over the baseline's.
void print_figures_of_merit(const std::string& store);

}  // namespace edgewise::cli
