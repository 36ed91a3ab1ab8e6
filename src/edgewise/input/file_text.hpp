// SPDX-License-Identifier: MIT
//
// A file that a user names, as text. Regular files only: a pipe or a device may never end, and a program that
// waits for it hangs without a message. Standard input is named - where a command reads it.
#pragma once

#include <cstdint>
#include <string>

#include "edgewise/geometry/result.hpp"

namespace edgewise::input {

/// Largest file that is read whole: scene files, plans, machines, locks.
inline constexpr std::uint64_t most_text_bytes = std::uint64_t{64} << 20;

/// What is wrong with the file and what to do, without the path; empty for a regular file that can be read.
[[nodiscard]] std::string what_is_wrong_with(const std::string& path);

/// The text of the whole file. Fails with one line that names the file.
[[nodiscard]] Result<std::string> read_file_text(const std::string& path,
                                                 std::uint64_t most_bytes = most_text_bytes);

}  // namespace edgewise::input
