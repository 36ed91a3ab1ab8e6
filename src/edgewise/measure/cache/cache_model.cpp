// SPDX-License-Identifier: MIT
#include "edgewise/measure/cache/cache_model.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <utility>

namespace edgewise::measure {

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
    const std::uint64_t end = address + bytes;
    std::size_t deepest = 0;
    while (address < end) {
        const std::uint64_t line = address >> line_shift_;
        const std::uint64_t stop = std::min(end, (line + 1) << line_shift_);
        const std::size_t depth = touch(line, used_bits(address, stop - address), kind != AccessKind::read);
        if (geometry_.crossing == LineCrossing::split) count(depth);
        deepest = std::max(deepest, depth);
        address = stop;
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
