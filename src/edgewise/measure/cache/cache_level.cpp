// SPDX-License-Identifier: MIT
#include "edgewise/measure/cache/cache_level.hpp"

#include <algorithm>
#include <bit>
#include <cassert>

#include "edgewise/geometry/split_mix.hpp"

namespace edgewise::measure {

namespace {

/// Where a node over ways first .. last - 1 splits: the left half is the larger.
std::uint32_t middle(std::uint32_t first, std::uint32_t last) { return first + (last - first + 1) / 2; }

/// The way that a tree of set (right) and clear (left) bits leads to.
std::uint32_t pointed_at(std::uint64_t tree, std::uint32_t ways) {
    std::uint32_t first = 0, last = ways;
    while (last - first > 1) {
        const std::uint32_t split = middle(first, last);
        ((tree >> split & 1) != 0 ? first : last) = split;
    }
    return first;
}

}  // namespace

CacheLevel::CacheLevel(std::uint32_t sets, std::uint32_t ways, Replacement replacement)
    : sets_(sets),
      ways_(ways),
      replacement_(replacement),
      mask_(std::has_single_bit(sets) ? sets : 0),
      lines_(std::size_t{sets} * ways, none),
      times_(lines_.size(), 0),
      used_(lines_.size(), 0),
      dirty_(lines_.size(), 0),
      last_(sets, 0),
      trees_(replacement == Replacement::tree_plru ? sets : 0, 0) {
    assert(sets > 0 && ways > 0 && (ways <= most_tree_ways || replacement != Replacement::tree_plru));
}

/// Every node above the way last used points to the other side.
void CacheLevel::point_away(std::uint64_t set) {
    for (std::uint32_t first = 0, last = ways_; last - first > 1;) {
        const std::uint32_t split = middle(first, last);
        const std::uint64_t bit = std::uint64_t{1} << split;
        if (last_[set] < split) {
            trees_[set] |= bit;
            last = split;
        } else {
            trees_[set] &= ~bit;
            first = split;
        }
    }
}

std::uint32_t CacheLevel::victim(std::uint64_t set) {
    const auto times = times_.begin() + static_cast<std::ptrdiff_t>(set * ways_);
    const auto oldest = static_cast<std::uint32_t>(std::min_element(times, times + ways_) - times);
    if (times[oldest] == 0 || replacement_ == Replacement::lru) return oldest;
    if (replacement_ == Replacement::tree_plru) return pointed_at(trees_[set], ways_);
    return static_cast<std::uint32_t>(split_mix(random_) % ways_);
}

std::optional<CachedLine> CacheLevel::insert(const CachedLine& entry) {
    const std::uint64_t set = set_of(entry.line);
    const Place place = set * ways_ + victim(set);
    std::optional<CachedLine> gone;
    if (times_[place] != 0) gone = at(place);
    lines_[place] = entry.line;
    used_[place] = entry.used;
    dirty_[place] = static_cast<std::uint8_t>(entry.dirty);
    use(entry.line, place);
    return gone;
}

std::optional<CachedLine> CacheLevel::take(std::uint64_t line) {
    const Place place = find(line);
    if (place == nowhere) return std::nullopt;
    const CachedLine taken = at(place);
    lines_[place] = none;
    times_[place] = 0;
    return taken;
}

}  // namespace edgewise::measure
