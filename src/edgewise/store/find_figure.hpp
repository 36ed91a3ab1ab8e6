// SPDX-License-Identifier: MIT
//
// The entry of the vocabulary that a stored figure belongs to.
#pragma once

#include <string_view>

#include "edgewise/store/vocabulary.hpp"

namespace edgewise::store {

/// Whether `text` is `pattern` with something in place of each pair of braces; that something may hold dots.
inline bool fits(std::string_view pattern, std::string_view text) {
    const std::size_t open = pattern.find('{');
    if (open == std::string_view::npos) return pattern == text;
    if (!text.starts_with(pattern.substr(0, open))) return false;
    const std::string_view rest = pattern.substr(pattern.find('}') + 1);
    for (std::size_t end = open + 1; end <= text.size(); ++end)
        if (fits(rest, text.substr(end))) return true;
    return false;
}

/// Null when the vocabulary has none.
inline const FigureInfo* find_figure(std::string_view probe, std::string_view name) {
    for (const auto part : vocabulary_parts)
        for (const FigureInfo& info : part)
            if (info.probe() == probe && fits(info.name(), name)) return &info;
    return nullptr;
}

}  // namespace edgewise::store
