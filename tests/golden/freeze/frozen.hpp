// SPDX-License-Identifier: MIT
//
// The texts of the freeze: output of the program as lines, so that a diff is readable. They are the same on
// every machine, on every day and in every folder.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "program.hpp"

namespace edgewise::golden {

/// File name -> its lines, each with a line break.
using Texts = std::map<std::string, std::string>;

/// Help of the program and of each command; `list NAME --json` and `bytes --json`.
void add_listings(Texts& texts);

/// Drawings of three tables of a tetrahedron.
void add_drawings(Texts& texts);

/// The report of a small store that is merged from two parts: report.md, the page, and the page's JSON.
void add_report(Texts& texts);

/// Status and distance of each pair of the corpus by some table types and algorithms; wrong ones are marked.
void add_verdicts(Texts& texts);

/// Makes a store in this folder and returns its path. It has the same figures wherever it is made: the
/// program sweeps a small plan in two parts and merges them, all its figures are modelled, and the times are
/// made up.
[[nodiscard]] std::string make_golden_store(const cli_test::Folder& folder);

/// Runs the program and returns its output; throws std::runtime_error with its message if it fails.
std::string output_of(const cli_test::Arguments& arguments, const cli_test::Folder& folder);

/// 16 hexadecimal digits of a text.
[[nodiscard]] std::string hash_of(std::string_view text);

}  // namespace edgewise::golden
