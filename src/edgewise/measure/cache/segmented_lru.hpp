// SPDX-License-Identifier: MIT
//
// Which pages a memory holds when only faults show which are used. The newest pages are mapped, in the order
// in which they were mapped; using them costs and reveals nothing. The other pages are unmapped, in order of
// last use, and using one is a soft fault that maps it again. When memory is full the least recent of the
// unmapped goes: the next use of it is a hard fault. (Segmented FIFO: Turner and Levy, "Segmented FIFO page
// replacement", SIGMETRICS 1981; with one mapped page it is LRU, with all mapped FIFO.)
//
// Memory is taken once: a signal handler can use it.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace edgewise::measure {

enum class PageUse : std::uint8_t {
    mapped,
    first,  ///< first use ever: nothing to fetch
    soft,
    hard
};

class SegmentedLru {
  public:
    /// A memory that holds `held` of `pages` pages, `mapped` of them mapped: 1 <= mapped <= held.
    SegmentedLru(std::size_t pages, std::size_t mapped, std::size_t held)
        : most_mapped_(mapped), most_unmapped_(held - mapped), nodes_(pages) {
        assert(mapped >= 1 && mapped <= held);
    }

    /// Result of a use: how the page was found, and the page that was unmapped because of it.
    struct Use {
        PageUse how;
        std::optional<std::uint32_t> unmapped;
    };

    Use use(std::uint32_t page) {
        Node& node = nodes_[page];
        if (node.state == State::mapped) return {PageUse::mapped, std::nullopt};
        const PageUse how = node.state == State::unmapped ? PageUse::soft
                            : node.state == State::fresh  ? PageUse::first
                                                          : PageUse::hard;
        if (how == PageUse::soft) take_out(unmapped_, page);
        Use result{how, std::nullopt};
        if (mapped_.count == most_mapped_) {
            const std::uint32_t oldest = mapped_.last;
            take_out(mapped_, oldest);
            put_first(unmapped_, oldest, State::unmapped);
            result.unmapped = oldest;
        }
        put_first(mapped_, page, State::mapped);
        if (unmapped_.count > most_unmapped_) {
            const std::uint32_t evicted = unmapped_.last;
            take_out(unmapped_, evicted);
            nodes_[evicted].state = State::away;
        }
        return result;
    }

    [[nodiscard]] std::size_t pages() const { return nodes_.size(); }
    [[nodiscard]] std::size_t held() const { return mapped_.count + unmapped_.count; }

  private:
    enum class State : std::uint8_t { fresh, away, mapped, unmapped };
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    struct Node {
        std::uint32_t before = none, after = none;
        State state = State::fresh;
    };
    struct List {
        std::uint32_t first = none, last = none;
        std::size_t count = 0;
    };

    void put_first(List& list, std::uint32_t page, State state) {
        nodes_[page] = {none, list.first, state};
        (list.first == none ? list.last : nodes_[list.first].before) = page;
        list.first = page;
        ++list.count;
    }
    void take_out(List& list, std::uint32_t page) {
        const Node node = nodes_[page];
        (node.before == none ? list.first : nodes_[node.before].after) = node.after;
        (node.after == none ? list.last : nodes_[node.after].before) = node.before;
        --list.count;
    }

    std::size_t most_mapped_, most_unmapped_;
    std::vector<Node> nodes_;
    List mapped_, unmapped_;
};

}  // namespace edgewise::measure
