// SPDX-License-Identifier: MIT
//
// Folders that a command may make: one that is named, beside what exists. A path that begins with folders
// which do not exist is a slip of the pen.
#pragma once

#include <string>

namespace edgewise::cli {

/// Throws std::invalid_argument where neither the folder nor the one above it exists. `option`: what the path
/// was given as.
void check_folder(const std::string& folder, const std::string& option);
/// The same of a file's; the folder of the default store may always be made.
void check_folder_of(const std::string& file, const std::string& option);

/// Makes the folder unless it is there, after that check.
void make_folder(const std::string& folder, const std::string& option);

/// Likewise the folder of a file; that of the default store with those above it.
void make_folder_of(const std::string& file, const std::string& option);

}  // namespace edgewise::cli
