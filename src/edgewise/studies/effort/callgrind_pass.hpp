// SPDX-License-Identifier: MIT
//
// Passes over one cell's queries in a process of its own, for tools that watch whole programs, and
// Callgrind's counts of the passes.
#pragma once

#include <string>
#include <vector>

#include "edgewise/measure/expected.hpp"
#include "edgewise/measure/process/callgrind.hpp"
#include "edgewise/studies/single_cell.hpp"

namespace edgewise::studies {

/// Returns the hidden command that runs one pass to warm up, then the number of passes to be counted, and
/// nothing else (cli/command_crosscheck.cpp).
[[nodiscard]] std::vector<std::string> pass_command(const CellChoice& choice, const std::string& program,
                                                    int passes);

/// Counts the passes under Callgrind, all together. `program`: Edgewise, built for a processor that Valgrind
/// knows. Several calls may run at a time.
[[nodiscard]] measure::Expected<measure::CallgrindCounts> callgrind_pass(
    const CellChoice& choice, const measure::CacheGeometry& geometry, const std::string& program,
    int passes = 1);

/// Counts the same passes instruction by instruction (`--dump-instr=yes`); the counts are equal.
[[nodiscard]] measure::Expected<measure::CallgrindLines> callgrind_lines(
    const CellChoice& choice, const measure::CacheGeometry& geometry, const std::string& program, int passes);

/// Returns a program that Valgrind can run: this one, or edgewise_sim next to it; else how to build one.
[[nodiscard]] measure::Expected<std::string> program_for_valgrind();

}  // namespace edgewise::studies
