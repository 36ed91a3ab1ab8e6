// SPDX-License-Identifier: MIT
//
// What there is to say of a figure, or of a family of figures that differ in what stands between braces.
#pragma once

#include <string_view>

namespace edgewise::store {

/// Which queries a figure is about. A query starts cold that is its pair's first, or of a scene that keeps no
/// answers; warm that starts from its pair's kept answer.
enum class Population {
    none,
    all,
    cold,
    warm,
    named,   ///< cold or warm, as the figure's name ends
    steady,  ///< warm where pairs are followed; else all, which are cold
    checked
};

[[nodiscard]] constexpr std::string_view to_string(Population population) {
    constexpr std::string_view names[] = {"none", "all", "cold", "warm", "named", "steady", "checked"};
    return names[static_cast<int>(population)];
}

enum class Repeats {
    exactly,  ///< the same bits in every run on every machine
    timed     ///< measured: another run gives another number
};

struct FigureInfo {
    std::string_view key;  ///< probe, a dot and the name: "time.all_ns", "heap.{structure}.slack_bytes"
    std::string_view unit;
    Population population;
    Repeats repeats;
    std::string_view meaning;

    [[nodiscard]] constexpr std::string_view probe() const { return key.substr(0, key.find('.')); }
    [[nodiscard]] constexpr std::string_view name() const { return key.substr(key.find('.') + 1); }
};

}  // namespace edgewise::store
