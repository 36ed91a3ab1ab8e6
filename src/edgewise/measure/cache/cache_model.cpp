// SPDX-License-Identifier: MIT
#include "edgewise/measure/cache/cache_model.hpp"

#include <bit>
#include <cassert>
#include <utility>

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
      trees_(replacement == Replacement::tree_plru ? sets : 0, 0),
      last_places_(recent_lines, 0) {
    assert(sets > 0 && ways > 0 && (ways <= most_tree_ways || replacement != Replacement::tree_plru));
}

/// Every node above the way used at `place` points to the other side.
void CacheLevel::point_away(Place place) {
    const std::uint64_t set = place / ways_, way = place % ways_;
    for (std::uint32_t first = 0, last = ways_; last - first > 1;) {
        const std::uint32_t split = middle(first, last);
        const std::uint64_t bit = std::uint64_t{1} << split;
        if (way < split) {
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

CacheModel::CacheModel(CacheGeometry geometry)
    : geometry_(std::move(geometry)),
      line_shift_(static_cast<std::uint32_t>(std::countr_zero(geometry_.line_bytes))),
      counts_(geometry_.levels.size()) {
    assert(std::has_single_bit(geometry_.line_bytes) && !geometry_.levels.empty());
    assert(geometry_.levels[0].inclusion != Inclusion::exclusive);  // nothing above evicts anything
    for (const LevelGeometry& level : geometry_.levels)
        levels_.emplace_back(level.sets, level.ways, level.replacement);
}

std::size_t CacheModel::access_lines(std::uint64_t address, std::uint32_t bytes, AccessKind kind) {
    const std::uint64_t line_bytes = geometry_.line_bytes;
    std::size_t deepest = 0;
    for (std::uint64_t left = bytes, here = 0; left > 0; left -= here, address += here) {
        here = std::min(left, line_bytes - (address & (line_bytes - 1)));
        const std::uint64_t line = address >> line_shift_;
        const std::size_t depth = touch(line, used_bits(address, here), kind != AccessKind::read);
        if (geometry_.crossing == LineCrossing::split) count(depth);
        deepest = std::max(deepest, depth);
    }
    if (geometry_.crossing == LineCrossing::merge) count(deepest);
    return deepest;
}

std::size_t CacheModel::fetch(std::uint64_t line, std::uint64_t used, bool dirties) {
    CachedLine entry{line, used, dirties};
    std::size_t depth = 1;
    for (; depth < levels_.size(); ++depth) {
        if (geometry_.levels[depth].inclusion == Inclusion::exclusive) {
            const auto moved = levels_[depth].take(line);
            if (!moved) continue;
            entry.dirty |= moved->dirty;
            break;
        }
        const CacheLevel::Place place = levels_[depth].find(line);
        if (place == CacheLevel::nowhere) continue;
        levels_[depth].use(line, place);
        break;
    }
    for (std::size_t level = depth; level-- > 1;) {
        if (geometry_.levels[level].inclusion != Inclusion::exclusive) put(level, {line});
    }
    put(0, entry);
    return depth;
}

/// Puts a line into a level and finds a place for what that evicts.
void CacheModel::put(std::size_t level, const CachedLine& entry) {
    auto gone = levels_[level].insert(entry);
    if (!gone) return;
    if (level == 0) add_to(gone_, *gone);
    if (geometry_.levels[level].inclusion == Inclusion::inclusive) {
        for (std::size_t above = 0; above < level; ++above) {
            const auto lost = levels_[above].take(gone->line);
            if (!lost) continue;
            gone->dirty |= lost->dirty;
            if (above == 0) add_to(gone_, *lost);
        }
    }
    const std::size_t below = level + 1;
    if (below < levels_.size() && geometry_.levels[below].inclusion == Inclusion::exclusive) {
        if (gone->dirty) ++counts_[level].write_backs;
        put(below, *gone);
    } else if (gone->dirty) {
        write_back(level, *gone);
    }
}

/// To the nearest level below that has the line; to memory if none has.
void CacheModel::write_back(std::size_t level, const CachedLine& entry) {
    ++counts_[level].write_backs;
    for (std::size_t below = level + 1; below < levels_.size(); ++below) {
        const CacheLevel::Place place = levels_[below].find(entry.line);
        if (place != CacheLevel::nowhere) return levels_[below].note(place, 0, true);
        ++counts_[below].write_backs;
    }
}

void CacheModel::add_to(Fetched& sum, const CachedLine& entry) const {
    sum.bytes += geometry_.line_bytes;
    sum.unused += (64 - static_cast<std::uint64_t>(std::popcount(entry.used))) * geometry_.line_bytes / 64;
}

CacheModel::Fetched CacheModel::standing() const {
    Fetched all;
    levels_[0].for_each([&](const CachedLine& entry) { add_to(all, entry); });
    return all;
}

CacheModel::Fetched CacheModel::fetched() const {
    const Fetched now = standing();
    const auto less = [](std::uint64_t sum, std::uint64_t part) { return sum > part ? sum - part : 0; };
    return {less(gone_.bytes + now.bytes, before_.bytes), less(gone_.unused + now.unused, before_.unused)};
}

void CacheModel::forget_counts() {
    std::fill(counts_.begin(), counts_.end(), LevelCounts{});
    gone_ = {};
    before_ = standing();
}

void CacheModel::drop(std::uint64_t line) {
    for (CacheLevel& level : levels_) static_cast<void>(level.take(line));
}

}  // namespace edgewise::measure
