// SPDX-License-Identifier: MIT
//
// Messages for unknown names: they suggest the known name that was most likely meant, and list all known
// names. Every "unknown ...; known: ..." line is made here. Inline, because rooms that are no library use it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/geometry/message.hpp"

namespace edgewise {

[[nodiscard]] inline std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return lower;
}

/// Number of letters to insert, delete, replace, or swap with their neighbour, to turn one name into the
/// other (optimal string alignment). Ignores case.
[[nodiscard]] inline int edits_between(std::string_view first, std::string_view second) {
    const std::string a = lower_case(first), b = lower_case(second);
    // Rows of the table of distances between beginnings: two letters ago, one letter ago, now.
    std::vector<int> before, last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = static_cast<int>(j);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before = last;
        last = row;
        row[0] = static_cast<int>(i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
    }
    return row[b.size()];
}

/// The known name that needs the fewest edits, the first of several; nothing if more than a third of the
/// letters would have to change. If none is near enough: the first name that begins with the given one
/// ("sphere38" for "sphere").
[[nodiscard]] inline std::optional<std::string> nearest_name(std::string_view name,
                                                             const std::vector<std::string>& known) {
    constexpr std::size_t least_beginning = 3;  // shorter ones are the beginning of too many others
    const auto edits = [&](const std::string& candidate) { return edits_between(name, candidate); };
    const auto nearest = std::ranges::min_element(known, {}, edits);
    // More edits are no slip of the fingers.
    const int most_edits = std::max(1, static_cast<int>(name.size()) / 3);
    if (nearest != known.end() && edits(*nearest) <= most_edits) return *nearest;
    const std::string wanted = lower_case(name);
    const auto longer = std::ranges::find_if(
        known, [&](const std::string& candidate) { return lower_case(candidate).starts_with(wanted); });
    if (wanted.size() < least_beginning || longer == known.end()) return std::nullopt;
    return *longer;
}

/// "; did you mean 'aos'?", or ";" if no name is near: the text before the list of known names.
[[nodiscard]] inline std::string did_you_mean(std::string_view name, const std::vector<std::string>& known) {
    const auto nearest = nearest_name(name, known);
    return nearest ? message("; did you mean '", *nearest, "'?") : ";";
}

/// The text with '?' for control characters: a message that quotes a user's text stays one line.
[[nodiscard]] inline std::string without_controls(std::string text) {
    for (char& c : text) {
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
    }
    return text;
}

/// A user's text on one line of at most 200 characters.
[[nodiscard]] inline std::string on_one_line(std::string_view text) {
    constexpr std::size_t longest = 200;
    const std::string line = without_controls(std::string(text.substr(0, longest)));
    return text.size() > longest ? line + "..." : line;
}

/// The message for an unknown name: "unknown layout 'aso'; did you mean 'aos'? known: aos, soa".
[[nodiscard]] inline std::string unknown_name(std::string_view what, std::string_view name,
                                              const std::vector<std::string>& known) {
    std::string line =
        message("unknown ", what, " '", on_one_line(name), "'", did_you_mean(name, known), " known: ");
    for (std::size_t i = 0; i < known.size(); ++i) line += message(i == 0 ? "" : ", ", known[i]);
    return line;
}

}  // namespace edgewise
