// SPDX-License-Identifier: MIT
//
// A hierarchy of caches that never ran anything: addresses go in, misses come out. Without prefetchers, other
// programs, instructions or kernels; on addresses as given, not on physical ones. So its numbers are the same
// on every machine, and a comparison of layouts by it is a comparison of what they ask of a cache.
//
// What the levels do, top down from 0:
//   - An access that no level answers goes to memory; every line comes in whole, writes as well
//     (write-allocate, write-back).
//   - non_inclusive: a line is put into every level it was missed in; what one level evicts, others keep.
//   - inclusive: besides, what this level evicts, the levels above lose as well.
//   - exclusive (a victim cache): holds only what the level above evicted; a hit moves the line up and out.
//   - A dirty line that is evicted goes to the level below if that has it or is exclusive, else on to memory.
//   - One line size for all levels. With pages for lines this is a hierarchy of TLBs.
//
// A reference that crosses a line is one access per line (`split`, as hardware does it), or one access and
// one miss at most (`merge`, as Cachegrind counts).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "edgewise/measure/cache/cache_level.hpp"
#include "edgewise/measure/cache/trace.hpp"

namespace edgewise::measure {

enum class Inclusion : std::uint8_t { non_inclusive, inclusive, exclusive };
enum class LineCrossing : std::uint8_t { split, merge };

struct LevelGeometry {
    std::string name;  ///< "L1D"
    std::uint32_t sets = 1, ways = 1;
    Inclusion inclusion = Inclusion::non_inclusive;
    Replacement replacement = Replacement::lru;
};

struct CacheGeometry {
    std::uint32_t line_bytes = 64;  ///< a power of two
    std::vector<LevelGeometry> levels;
    LineCrossing crossing = LineCrossing::split;

    [[nodiscard]] std::uint64_t bytes_of(std::size_t level) const {
        return std::uint64_t{levels[level].sets} * levels[level].ways * line_bytes;
    }
};

/// What one level saw.
struct LevelCounts {
    std::uint64_t accesses = 0, misses = 0;
    std::uint64_t write_backs = 0;  ///< dirty lines that left for below
};

class CacheModel {
  public:
    explicit CacheModel(CacheGeometry geometry);

    /// How many levels had to be asked in vain, at most over the lines: 0 is a hit in the first, as many as
    /// there are a fetch from memory.
    std::size_t access(std::uint64_t address, std::uint32_t bytes, AccessKind kind) {
        const std::uint64_t first = address >> line_shift_, last = (address + bytes - 1) >> line_shift_;
        if (first == last) [[likely]] {
            const std::size_t depth = touch(first, used_bits(address, bytes), kind != AccessKind::read);
            count(depth);
            return depth;
        }
        return access_lines(address, bytes, kind);
    }

    [[nodiscard]] const CacheGeometry& geometry() const { return geometry_; }
    [[nodiscard]] std::span<const LevelCounts> counts() const { return counts_; }
    [[nodiscard]] const LevelCounts& counts(std::size_t level) const { return counts_[level]; }

    /// Of the lines that the first level brought in since counts were last forgotten: bytes, and those of
    /// them that were never asked for, to a 64th of a line. Lines that are still there count as they stand;
    /// what lines from before had not been asked for by then, and are now, is taken off.
    struct Fetched {
        std::uint64_t bytes = 0, unused = 0;
    };
    [[nodiscard]] Fetched fetched() const;

    /// Counts are zero again; what is cached stays.
    void forget_counts();

    /// The line is in no level any more; nothing is counted.
    void drop(std::uint64_t line);

  private:
    std::size_t access_lines(std::uint64_t address, std::uint32_t bytes, AccessKind kind);

    /// Depth of one line, which is in the first level afterwards.
    std::size_t touch(std::uint64_t line, std::uint64_t used, bool dirties) {
        CacheLevel& first = levels_[0];
        if (const CacheLevel::Place place = first.find(line); place != CacheLevel::nowhere) [[likely]] {
            first.use(line, place);
            first.note(place, used, dirties);
            return 0;
        }
        return fetch(line, used, dirties);
    }
    std::size_t fetch(std::uint64_t line, std::uint64_t used, bool dirties);
    void put(std::size_t level, const CachedLine& entry);
    void write_back(std::size_t level, const CachedLine& entry);
    void add_to(Fetched& sum, const CachedLine& entry) const;
    /// Lines in the first level, as they stand.
    [[nodiscard]] Fetched standing() const;

    void count(std::size_t depth) {
        ++counts_[0].accesses;
        for (std::size_t level = 0; level < depth; ++level) {
            ++counts_[level].misses;
            if (level + 1 < levels_.size()) ++counts_[level + 1].accesses;
        }
    }

    /// The 64ths of its line that an access within it touches.
    [[nodiscard]] std::uint64_t used_bits(std::uint64_t address, std::uint64_t bytes) const {
        const std::uint64_t offset = address & (geometry_.line_bytes - 1);
        const std::uint64_t first = (offset * 64) >> line_shift_;
        const std::uint64_t last = ((offset + bytes) * 64 - 1) >> line_shift_;
        return (~std::uint64_t{0} >> (63 - (last - first))) << first;
    }

    CacheGeometry geometry_;
    std::uint32_t line_shift_;
    std::vector<CacheLevel> levels_;
    std::vector<LevelCounts> counts_;
    Fetched gone_;    ///< lines that left the first level
    Fetched before_;  ///< lines that stood there when counts were forgotten
};

}  // namespace edgewise::measure
