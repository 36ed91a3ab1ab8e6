// SPDX-License-Identifier: MIT
#include "edgewise/store/vocabulary.hpp"

#include <cassert>

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
    const std::string_view value = name.substr(open, name.size() - before.size() - after.size());
    for (const std::string_view start : {StartNames::cold_start, StartNames::warm_start}) {
        if (value.ends_with(start) && value.substr(0, value.size() - start.size()).ends_with('.'))
            return std::nullopt;
    }
    return std::string(value);
}

void add_values(const StartNames& names, const measure::ByStart<std::optional<double>>& values,
                std::vector<measure::Figure>& to) {
    to.push_back(figure(names.all, values.all, "no query was asked", "ask for more queries"));
    to.push_back(figure(names.cold(), values.cold, "no query here starts cold", "another scene"));
    to.push_back(figure(names.warm(), values.warm, "no query here starts warm",
                        "a scene that follows pairs, or more queries"));
}

void add_means(const StartNames& names, const measure::ByStart<std::uint64_t>& sums,
               const measure::ByStart<std::uint64_t>& queries, std::vector<measure::Figure>& to) {
    const auto mean = [](std::uint64_t sum, std::uint64_t count) -> std::optional<double> {
        if (count == 0) return std::nullopt;
        return static_cast<double>(sum) / static_cast<double>(count);
    };
    add_values(names,
               {mean(sums.all, queries.all), mean(sums.cold, queries.cold), mean(sums.warm, queries.warm)},
               to);
}

measure::Figure figure(const FigureName& name, std::optional<double> value, std::string reason,
                       std::string remedy) {
    assert(name.name().find('{') == std::string::npos);
    if (value) return {name.name(), value, name.unit()};
    return {name.name(), std::nullopt, name.unit(), std::move(reason), std::move(remedy)};
}

/// Returns true if `text` is `pattern` with some text for each pair of braces; that text may have dots.
static bool fits(std::string_view pattern, std::string_view text) {
    const std::size_t open = pattern.find('{');
    if (open == std::string_view::npos) return pattern == text;
    if (!text.starts_with(pattern.substr(0, open))) return false;
    const std::string_view rest = pattern.substr(pattern.find('}') + 1);
    for (std::size_t end = open + 1; end <= text.size(); ++end)
        if (fits(rest, text.substr(end))) return true;
    return false;
}

const FigureInfo* find_figure(std::string_view probe, std::string_view name) {
    for (const FigureInfo& info : vocabulary)
        if (info.probe() == probe && fits(info.name(), name)) return &info;
    return nullptr;
}

}  // namespace edgewise::store
