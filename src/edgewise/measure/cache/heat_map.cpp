// SPDX-License-Identifier: MIT
#include "edgewise/measure/cache/heat_map.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

namespace edgewise::measure {

void HeatMap::on_access(const TracedAccess& access) {
    ++by_field_[access.field];
    ++by_step_[access.step];
    touched_.touch(access.address, access.bytes);
    access.for_each_unit(64, [this](std::uint64_t line) {
        if (line >= by_line_.size())
            by_line_.resize(std::max<std::uint64_t>(line + 1, 2 * by_line_.size()), 0);
        ++by_line_[line];
    });
}

std::uint64_t HeatMap::lines() const {
    return by_line_.size() -
           static_cast<std::uint64_t>(std::count(by_line_.begin(), by_line_.end(), std::uint32_t{0}));
}

std::uint64_t HeatMap::lines_taking(double part) const {
    std::vector<std::uint32_t> hottest;
    std::copy_if(by_line_.begin(), by_line_.end(), std::back_inserter(hottest),
                 [](std::uint32_t accesses) { return accesses > 0; });
    std::sort(hottest.begin(), hottest.end(), std::greater<>());
    const auto all = static_cast<double>(std::accumulate(hottest.begin(), hottest.end(), std::uint64_t{0}));
    std::uint64_t taken = 0, lines = 0;
    while (static_cast<double>(taken) < part * all) taken += hottest[lines++];
    return lines;
}

}  // namespace edgewise::measure
