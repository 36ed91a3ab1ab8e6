// SPDX-License-Identifier: MIT
//
// Readers of the small text files in which Linux describes itself.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "edgewise/measure/expected.hpp"

namespace edgewise::measure {

/// The whole file without trailing white space.
[[nodiscard]] Expected<std::string> read_text(const std::filesystem::path& file);

/// A file that holds one whole number, decimal or 0x-hexadecimal, with an optional K, M or G (1024 based).
[[nodiscard]] Expected<std::int64_t> read_number(const std::filesystem::path& file);

/// The number at the start of a text, as read_number reads it; null when there is none or when text follows.
[[nodiscard]] std::optional<std::int64_t> parse_number(std::string text);

}  // namespace edgewise::measure
