// SPDX-License-Identifier: MIT
#include "edgewise/measure/cache/heat_map.hpp"

#include <algorithm>
#include <bit>
#include <functional>
#include <numeric>
#include <utility>

namespace edgewise::measure {
namespace {

/// Calls use(word, bits) for each word that the range meets, with the range's bits in it.
template <class Use>
void each_word(std::uint64_t from, std::uint64_t bytes, Use use) {
    const std::uint64_t end = from + bytes;
    for (std::uint64_t at = from; at < end;) {
        const std::uint64_t stop = std::min(end, (at / 64 + 1) * 64);
        const std::uint64_t ones = ~std::uint64_t{0} >> (64 - (stop - at));
        use(at / 64, ones << at % 64);
        at = stop;
    }
}

}  // namespace

void TouchedBytes::touch(std::uint64_t from, std::uint64_t bytes) {
    const std::uint64_t needed = (from + bytes + 63) / 64;
    if (needed > words_.size()) words_.resize(std::max<std::uint64_t>(needed, 2 * words_.size()), 0);
    each_word(from, bytes, [&](std::uint64_t word, std::uint64_t bits) { words_[word] |= bits; });
}

std::uint64_t TouchedBytes::count(std::uint64_t from, std::uint64_t bytes) const {
    std::uint64_t sum = 0;
    const std::uint64_t there = 64 * words_.size();
    if (from >= there) return 0;
    each_word(from, std::min(bytes, there - from), [&](std::uint64_t word, std::uint64_t bits) {
        sum += static_cast<std::uint64_t>(std::popcount(words_[word] & bits));
    });
    return sum;
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
