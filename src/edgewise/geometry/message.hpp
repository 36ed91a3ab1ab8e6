// SPDX-License-Identifier: MIT
//
// Puts an error line together: text, integers, and doubles in the shortest form that reads back the same.
#pragma once

#include <charconv>
#include <string>
#include <string_view>
#include <type_traits>

namespace edgewise {

template <class Part>
[[nodiscard]] std::string message_part(const Part& part) {
    if constexpr (std::is_floating_point_v<Part>) {
        char digits[32];
        return {digits, std::to_chars(digits, digits + sizeof digits, part).ptr};
    } else if constexpr (std::is_same_v<Part, char>) {
        return std::string(1, part);
    } else if constexpr (std::is_integral_v<Part>) {
        return std::to_string(part);
    } else {
        return std::string(std::string_view(part));
    }
}

template <class... Parts>
[[nodiscard]] std::string message(const Parts&... parts) {
    return (std::string() + ... + message_part(parts));
}

/// Adds a warning, unless it is empty, to those before it.
inline void add_warning(std::string& warnings, std::string_view warning) {
    if (!warnings.empty() && !warning.empty()) warnings += "; ";
    warnings += warning;
}

/// Formats a number for reading only, in a few significant digits.
[[nodiscard]] inline std::string rounded(double value, int significant = 2) {
    char digits[32];
    const auto end =
        std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, significant).ptr;
    return {digits, end};
}

}  // namespace edgewise
