// SPDX-License-Identifier: MIT
//
// Folders that a command may make: one new folder in a folder that exists. A path that begins with several
// folders which do not exist is a typing error.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace edgewise::cli {

/// An option that names a file to be written (input/output_file.hpp). A path that cannot be written is
/// refused before any work is done.
CLI::Option* add_output_file(CLI::App& command, const std::string& name, std::string& to,
                             const std::string& what);

/// Throws std::invalid_argument where neither the folder nor the one above it exists. `option`: what the path
/// was given as.
void check_folder(const std::string& folder, const std::string& option);
/// Checks the folder of a file; the folder of the default store may always be made.
void check_folder_of(const std::string& file, const std::string& option);

/// Makes the folder unless it is there, after that check.
void make_folder(const std::string& folder, const std::string& option);

/// Makes the folder of a file; that of the default store with the folders above it.
void make_folder_of(const std::string& file, const std::string& option);

}  // namespace edgewise::cli
