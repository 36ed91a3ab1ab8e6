// SPDX-License-Identifier: MIT
#include "edgewise/studies/gate/entry.hpp"

#include <algorithm>

#include "edgewise/measure/statistics.hpp"

namespace edgewise::studies {

std::string GateEntry::name() const {
    std::string name = algorithm + " " + table + " " + scene + " " + shape;
    return axes.empty() ? name : name + " " + axes;
}

std::string gate_group_name(const std::string& scene, const std::string& shape) {
    return scene + " " + shape;
}

std::optional<GateRatio> gate_ratio(std::span<const double> times, std::span<const double> beside) {
    const std::vector<double> ratios = measure::paired_ratios(times, beside);
    if (!std::all_of(ratios.begin(), ratios.end(), [](double ratio) { return ratio > 0; }))
        return std::nullopt;
    const auto middle = measure::median(ratios);
    const auto interval = measure::bootstrap_median(ratios);
    if (!middle || !interval) return std::nullopt;
    // The bootstrap's ends may miss the median of a sample of few values.
    return GateRatio{*middle, std::min(interval->lower, *middle), std::max(interval->upper, *middle)};
}

}  // namespace edgewise::studies
