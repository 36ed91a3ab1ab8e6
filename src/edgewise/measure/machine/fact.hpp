// SPDX-License-Identifier: MIT
//
// Something read from the system: a value, or the reason why it is not known. And readers of the small text
// files in which Linux tells such facts.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace edgewise::measure {

template <class Value>
struct Fact {
    std::optional<Value> value;
    std::string reason = {};  ///< why there is no value

    [[nodiscard]] static Fact unknown(std::string why) { return {std::nullopt, std::move(why)}; }
};

/// The whole file without trailing white space.
[[nodiscard]] Fact<std::string> read_text(const std::filesystem::path& file);

/// A file that holds one whole number, decimal or 0x-hexadecimal, with an optional K, M or G (1024 based).
[[nodiscard]] Fact<std::int64_t> read_number(const std::filesystem::path& file);

/// The number at the start of a text, as read_number reads it; null when there is none or when text follows.
[[nodiscard]] std::optional<std::int64_t> parse_number(std::string text);

}  // namespace edgewise::measure
