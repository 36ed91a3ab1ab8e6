// SPDX-License-Identifier: MIT
#include "edgewise/input/shown_text.hpp"

#include <fmt/core.h>

#include <cstddef>
#include <cstdint>

namespace edgewise::input {

namespace {

struct Character {
    std::uint32_t code = 0;
    std::size_t bytes = 0;  ///< 0: the first byte begins no character of UTF-8
};

/// RFC 3629: no code in more bytes than it needs, no surrogate, nothing above U+10FFFF.
Character first_of(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i]));
    };
    const std::uint32_t lead = byte(0);
    if (lead < 0x80) return {lead, 1};
    const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() < bytes) return {};
    std::uint32_t code = lead & (0x7Fu >> bytes);
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return {};
        code = code << 6 | (byte(i) & 0x3F);
    }
    constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    if (code < least[bytes] || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) return {};
    return {code, bytes};
}

bool is_control(std::uint32_t code) { return code < 0x20 || (code >= 0x7F && code < 0xA0); }

/// Returns true for marks that turn the direction of the text after them, and for separators that a terminal
/// may take for line ends.
bool is_mark(std::uint32_t code) {
    return code == 0x061C || code == 0x200E || code == 0x200F || (code >= 0x2028 && code <= 0x202E) ||
           (code >= 0x2066 && code <= 0x2069);
}

/// The text with put(code, character) for every character, and its number for every byte that is no
/// character.
template <class Put>
std::string rewritten(std::string_view text, const Put& put) {
    std::string out;
    for (std::size_t i = 0; i < text.size();) {
        if (text[i] >= ' ' && text[i] <= '~') {
            out += text[i++];
            continue;
        }
        const Character next = first_of(text.substr(i));
        if (next.bytes == 0)
            out += fmt::format("\\x{:02X}", static_cast<unsigned char>(text[i++]));
        else
            out += put(next.code, text.substr(i, next.bytes)), i += next.bytes;
    }
    return out;
}

std::string shown(std::uint32_t code, std::string_view character) {
    if (!is_control(code) && !is_mark(code)) return std::string(character);
    return code < 0x80 ? fmt::format("\\x{:02X}", code) : fmt::format("\\u{:04X}", code);
}

}  // namespace

std::string shown_text(std::string_view text) {
    return rewritten(text, [&](std::uint32_t code, std::string_view character) {
        const auto next = static_cast<std::size_t>(character.data() - text.data()) + 1;
        const bool ends_line = code == '\n' || (code == '\r' && text.substr(next).starts_with('\n'));
        return ends_line || code == '\t' ? std::string(character) : shown(code, character);
    });
}

std::string shown_line(std::string_view text) { return rewritten(text, shown); }

std::string valid_utf8(std::string_view text) {
    return rewritten(text, [](std::uint32_t, std::string_view character) { return std::string(character); });
}

std::string json_escaped(std::string_view json) {
    return rewritten(json, [](std::uint32_t code, std::string_view character) {
        const bool hidden = code >= 0x7F && (is_control(code) || is_mark(code));
        return hidden ? fmt::format("\\u{:04X}", code) : std::string(character);
    });
}

}  // namespace edgewise::input
