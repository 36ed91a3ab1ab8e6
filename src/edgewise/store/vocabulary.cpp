// SPDX-License-Identifier: MIT
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::store {

namespace {

/// Whether `text` is `pattern` with something in place of each pair of braces; that something may hold dots.
bool fits(std::string_view pattern, std::string_view text) {
    const std::size_t open = pattern.find('{');
    if (open == std::string_view::npos) return pattern == text;
    if (!text.starts_with(pattern.substr(0, open))) return false;
    const std::string_view rest = pattern.substr(pattern.find('}') + 1);
    for (std::size_t end = open + 1; end <= text.size(); ++end)
        if (fits(rest, text.substr(end))) return true;
    return false;
}

}  // namespace

std::string FigureName::name() const {
    std::string filled;
    std::string_view rest = info_->name();
    for (const std::string_view value : values_) {
        const std::size_t open = rest.find('{');
        if (open == std::string_view::npos || value.empty()) break;
        filled.append(rest.substr(0, open)).append(value);
        rest.remove_prefix(rest.find('}') + 1);
    }
    return filled.append(rest);
}

std::optional<std::string> FigureName::value_in(std::string_view probe, std::string_view name) const {
    const std::string filled = this->name();
    const std::size_t open = filled.find('{');
    assert(open != std::string::npos);
    const std::string_view before = std::string_view(filled).substr(0, open),
                           after = std::string_view(filled).substr(filled.find('}') + 1);
    if (probe != info_->probe() || name.size() <= before.size() + after.size()) return std::nullopt;
    if (!name.starts_with(before) || !name.ends_with(after)) return std::nullopt;
    return std::string(name.substr(open, name.size() - before.size() - after.size()));
}

measure::Figure figure(const FigureName& name, std::optional<double> value, std::string reason,
                       std::string remedy) {
    assert(name.name().find('{') == std::string::npos);
    return {name.name(), value, name.unit(), std::move(reason), std::move(remedy)};
}

const FigureInfo* find_figure(std::string_view probe, std::string_view name) {
    for (const auto part : vocabulary_parts)
        for (const FigureInfo& info : part)
            if (info.probe() == probe && fits(info.name(), name)) return &info;
    return nullptr;
}

}  // namespace edgewise::store
