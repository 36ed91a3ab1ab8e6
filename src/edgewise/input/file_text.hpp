// SPDX-License-Identifier: MIT
//
// A file that a user names, as text. Regular files only: a pipe or a device may never end, and what waits for
// it hangs without a word. Where standard input is meant, commands say so with -.
#pragma once

#include <cstdint>
#include <string>

#include "edgewise/geometry/result.hpp"

namespace edgewise::input {

/// Of anything that is read whole and not measured in elements: scene files, plans, machines, locks.
inline constexpr std::uint64_t most_text_bytes = std::uint64_t{64} << 20;

/// Empty for a regular file that can be read; else what is wrong and what to do, without the path.
[[nodiscard]] std::string what_is_wrong_with(const std::string& path);

/// The whole file. Fails with one line that names it.
[[nodiscard]] Result<std::string> read_file_text(const std::string& path,
                                                 std::uint64_t most_bytes = most_text_bytes);

}  // namespace edgewise::input
