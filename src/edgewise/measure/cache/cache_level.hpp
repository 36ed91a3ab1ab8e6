// SPDX-License-Identifier: MIT
//
// One level of a modelled cache: sets of ways, any number of either, and which line makes room for a new one.
//   lru        the one used longest ago, exactly
//   tree_plru  a bit per node of a binary tree over the ways points away from what was used last; the left
//              subtree is the larger one where the ways are no power of two
//   random     any, from a seeded generator: the same misses on every run
// An empty way is taken before any line goes.
//
// Lines are numbers (address / line size); set = number modulo sets, so modelled caches are indexed by the
// addresses they are given, without the hashes of real last-level caches.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace edgewise::measure {

enum class Replacement : std::uint8_t { lru, tree_plru, random };

/// A word holds the nodes of a tree.
inline constexpr std::uint32_t most_tree_ways = 64;

/// What is known of a line that is there, or was.
struct CachedLine {
    std::uint64_t line;
    std::uint64_t used = 0;  ///< a bit per 64th of the line: what of it was ever asked for
    bool dirty = false;
};

class CacheLevel {
  public:
    /// Where a line is, until the next line comes or goes.
    using Place = std::size_t;
    static constexpr Place nowhere = ~Place{0};

    /// sets > 0, ways > 0; of tree_plru most_tree_ways at most.
    CacheLevel(std::uint32_t sets, std::uint32_t ways, Replacement replacement);

    /// The line, without a use.
    [[nodiscard]] Place find(std::uint64_t line) const {
        const std::uint64_t set = set_of(line);
        const std::uint64_t* const ways = lines_.data() + set * ways_;
        if (ways[last_[set]] == line) return set * ways_ + last_[set];
        // To the end even when found: as vectors, without a jump.
        std::uint32_t at = ways_;
        for (std::uint32_t way = 0; way < ways_; ++way) at = ways[way] == line ? way : at;
        return at == ways_ ? nowhere : set * ways_ + at;
    }
    /// It was used now.
    void use(std::uint64_t line, Place place) {
        const std::uint64_t set = set_of(line);
        last_[set] = static_cast<std::uint32_t>(place - set * ways_);
        times_[place] = ++now_;
        if (replacement_ == Replacement::tree_plru) point_away(set);
    }
    void note(Place place, std::uint64_t parts, bool dirty) {
        used_[place] |= parts;
        dirty_[place] |= static_cast<std::uint8_t>(dirty);
    }

    /// Puts a line that is not there and uses it; gives what had to go.
    std::optional<CachedLine> insert(const CachedLine& entry);

    /// Takes the line out, if it is there.
    std::optional<CachedLine> take(std::uint64_t line);

    /// Every line that is there, in no order that means anything.
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
    void point_away(std::uint64_t set);

    static constexpr std::uint64_t none = ~std::uint64_t{0};

    std::uint32_t sets_, ways_;
    Replacement replacement_;
    std::uint64_t mask_;  ///< sets_, if that is a power of two
    // Set after set:
    std::vector<std::uint64_t> lines_, times_, used_;  ///< times_: of the last use; 0: nothing is there
    std::vector<std::uint8_t> dirty_;
    // By set:
    std::vector<std::uint32_t> last_;   ///< the way last used
    std::vector<std::uint64_t> trees_;  ///< of tree_plru: bit k is the node that splits before way k
    std::uint64_t now_ = 0, random_ = 0;
};

}  // namespace edgewise::measure
