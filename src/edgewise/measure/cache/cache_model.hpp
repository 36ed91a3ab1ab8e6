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

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "edgewise/measure/cache/trace.hpp"

namespace edgewise::measure {

// One level of a modelled cache: sets of ways, any number of either, and which line makes room for a new one.
//   lru        the one used longest ago, exactly
//   tree_plru  a bit per node of a binary tree over the ways points away from what was used last; the left
//              subtree is the larger one where the ways are no power of two
//   random     any, from a seeded generator: the same misses on every run
// An empty way is taken before any line goes.
//
// Lines are numbers (address / line size); set = number modulo sets, so modelled caches are indexed by the
// addresses they are given, without the hashes of real last-level caches.

enum class Replacement : std::uint8_t { lru, tree_plru, random };

/// A word holds the nodes of a tree.
inline constexpr std::uint32_t most_tree_ways = 64;

/// State of a line that is cached, or was.
struct CachedLine {
    std::uint64_t line;
    std::uint64_t used = 0;  ///< a bit per 64th of the line: what of it was ever asked for
    bool dirty = false;
};

class CacheLevel {
  public:
    /// Position of a line. Valid until a line is inserted or taken out.
    using Place = std::size_t;
    static constexpr Place nowhere = ~Place{0};

    /// `sets` and `ways` must be above 0; with tree_plru `ways` is at most most_tree_ways.
    CacheLevel(std::uint32_t sets, std::uint32_t ways, Replacement replacement);

    /// Returns the position of the line, without using it; `nowhere` if it is not in the level.
    [[nodiscard]] Place find(std::uint64_t line) const {
        if (const Place last = last_places_[line % recent_lines]; lines_[last] == line) return last;
        const Place first = set_of(line) * ways_;
        const auto ways = std::span(lines_).subspan(first, ways_);
        const auto found = std::find(ways.begin(), ways.end(), line);
        return found == ways.end() ? nowhere : first + static_cast<Place>(found - ways.begin());
    }
    /// Notes that the line at `place` is used now.
    void use(std::uint64_t line, Place place) {
        last_places_[line % recent_lines] = place;
        times_[place] = ++now_;
        if (replacement_ == Replacement::tree_plru) point_away(place);
    }
    void note(Place place, std::uint64_t parts, bool dirty) {
        used_[place] |= parts;
        dirty_[place] |= static_cast<std::uint8_t>(dirty);
    }

    /// Inserts a line that is not in the level, and uses it. Returns the evicted line, if there was one.
    std::optional<CachedLine> insert(const CachedLine& entry);

    /// Takes the line out of the level and returns it; nothing if it is not in the level.
    std::optional<CachedLine> take(std::uint64_t line);

    /// Calls `use` for every line in the level, in unspecified order.
    template <class Use>
    void for_each(Use use) const {
        for (Place place = 0; place < lines_.size(); ++place) {
            if (times_[place] != 0) use(at(place));
        }
    }

  private:
    [[nodiscard]] std::uint64_t set_of(std::uint64_t line) const {
        return mask_ != 0 ? line & (mask_ - 1) : line % sets_;
    }
    [[nodiscard]] CachedLine at(Place place) const {
        return {lines_[place], used_[place], dirty_[place] != 0};
    }
    [[nodiscard]] std::uint32_t victim(std::uint64_t set);
    void point_away(Place place);

    static constexpr std::uint64_t none = ~std::uint64_t{0};
    static constexpr std::size_t recent_lines = 1024;

    std::uint32_t sets_, ways_;
    Replacement replacement_;
    std::uint64_t mask_;  ///< sets_, if that is a power of two
    // Set after set:
    std::vector<std::uint64_t> lines_, times_, used_;  ///< times_: of the last use; 0: nothing is there
    std::vector<std::uint8_t> dirty_;
    std::vector<std::uint64_t> trees_;  ///< of tree_plru, by set: bit k is the node that splits before way k
    /// Where the last line with this remainder was found: one look, where a fully associative level compares
    /// all its ways.
    std::vector<Place> last_places_;
    std::uint64_t now_ = 0, random_ = 0;
};

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

    /// Returns the number of levels that missed, the largest over the lines: 0 is a hit in the first level,
    /// the number of levels is a fetch from memory.
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

    /// Bytes of the lines that the first level brought in since counts were last forgotten, and bytes among
    /// them that were never accessed, to a 64th of a line. Lines that are still cached count in their present
    /// state; bytes of earlier lines that had not been accessed by then, and are now, are subtracted.
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
    /// Lines in the first level, in their present state.
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
    Fetched before_;  ///< lines that were there when counts were forgotten
};

}  // namespace edgewise::measure
