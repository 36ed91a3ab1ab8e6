// SPDX-License-Identifier: MIT
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::store {

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
    if (value) return {name.name(), value, name.unit()};
    return {name.name(), std::nullopt, name.unit(), std::move(reason), std::move(remedy)};
}

}  // namespace edgewise::store
