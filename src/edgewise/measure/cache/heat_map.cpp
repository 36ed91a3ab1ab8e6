// SPDX-License-Identifier: MIT
#include "edgewise/measure/cache/heat_map.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

namespace edgewise::measure {

void TouchedBytes::touch(std::uint64_t from, std::uint64_t bytes) {
    const std::uint64_t needed = from + bytes;
    if (needed > bytes_.size()) bytes_.resize(std::max<std::uint64_t>(needed, 2 * bytes_.size()));
    const auto first = bytes_.begin() + static_cast<std::ptrdiff_t>(from);
    std::fill(first, first + static_cast<std::ptrdiff_t>(bytes), true);
}

std::uint64_t TouchedBytes::count(std::uint64_t from, std::uint64_t bytes) const {
    if (from >= bytes_.size()) return 0;
    const auto first = bytes_.begin() + static_cast<std::ptrdiff_t>(from);
    const auto there = static_cast<std::ptrdiff_t>(std::min(bytes, bytes_.size() - from));
    return static_cast<std::uint64_t>(std::count(first, first + there, true));
}

HeatMap::HeatMap(std::size_t fields, std::size_t steps) : by_step_(steps) {
    for (auto* counts : {&by_field_.all, &by_field_.cold, &by_field_.warm}) counts->resize(fields);
}

void HeatMap::on_access(const TracedAccess& access) {
    by_field_.each(start_, [&](std::vector<std::uint64_t>& counts) { ++counts[access.field]; });
    ++by_step_[access.step];
    touched_.touch(access.address, access.bytes);
    access.for_each_unit(64, [&](std::uint64_t line) {
        if (line >= by_line_.size()) {
            by_line_.resize(std::max<std::uint64_t>(line + 1, 2 * by_line_.size()), 0);
            last_query_.resize(by_line_.size(), 0);
        }
        ++by_line_[line];
        if (access.side == TraceSide::scene) return;
        const std::uint64_t query = queries_.all + 1;
        if (std::exchange(last_query_[line], query) != query) lines_of_queries_.add(start_, 1);
    });
}

void HeatMap::on_query_end(bool /*counts*/) {
    queries_.add(start_, 1);
    start_.reset();
}

std::uint64_t HeatMap::lines() const {
    return by_line_.size() -
           static_cast<std::uint64_t>(std::count(by_line_.begin(), by_line_.end(), std::uint32_t{0}));
}

std::uint64_t HeatMap::lines_taking(double part) const {
    std::vector<std::uint32_t> hottest = by_line_;
    std::sort(hottest.begin(), hottest.end(), std::greater<>());
    const auto all = static_cast<double>(std::accumulate(hottest.begin(), hottest.end(), std::uint64_t{0}));
    std::uint64_t taken = 0, lines = 0;
    while (static_cast<double>(taken) < part * all) taken += hottest[lines++];
    return lines;
}

}  // namespace edgewise::measure
