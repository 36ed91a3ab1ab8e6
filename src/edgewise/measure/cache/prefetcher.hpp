// SPDX-License-Identifier: MIT
//
// What a hardware prefetcher would bring in besides the lines that are asked for. A sensitivity: modelled
// caches have none, and a machine under one is called "zen5/next_line" or "zen5/stream", as machines under
// other replacement policies are called "zen5/random".
//
//   next_line  a miss brings the line after it (A. J. Smith, "Cache Memories", Computing Surveys 14, 1982,
//              prefetch on misses; the DCU prefetcher of Intel 64 and IA-32 Architectures Optimization
//              Reference Manual, "Data Prefetching")
//   stream     a miss in the direction of the miss before it in its page brings the next two lines that way;
//              the last 32 pages with misses are followed (the hardware prefetcher of the same manual, which
//              needs successive misses and follows one stream in a page)
//
// Misses are those of the first level. Neither leaves the page of 4 KiB. Lines come at once and enter every
// level, which is more than processors do: the model bounds what prefetching may change.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace edgewise::measure {

class Prefetcher {
  public:
    static constexpr std::uint64_t page_bytes = 4096, lines_ahead = 2;
    static constexpr std::size_t most_pages = 32;

    /// `machine`: a machine's name; a prefetcher's name follows the slash, or there is none.
    Prefetcher(const std::string& machine, std::uint32_t line_bytes)
        : next_line_(machine.ends_with("/next_line")),
          stream_(machine.ends_with("/stream")),
          lines_of_page_(std::max<std::uint64_t>(page_bytes / line_bytes, 1)) {}

    /// Calls `fetch` with each line that a miss of `line` brings.
    template <class Fetch>
    void on_miss(std::uint64_t line, const Fetch& fetch) {
        if (next_line_) fetch_in_page(line, 1, 1, fetch);
        if (!stream_) return;
        const std::uint64_t page = line / lines_of_page_;
        const auto found =
            std::find_if(pages_.begin(), pages_.end(), [&](const Page& of) { return of.page == page; });
        Page missed{page, line, 0};
        bool goes_on = false;
        if (found != pages_.end()) {
            missed.step = line > found->last ? 1 : line < found->last ? -1 : 0;
            goes_on = missed.step != 0 && missed.step == found->step;
            pages_.erase(found);
        } else if (pages_.size() == most_pages) {
            pages_.pop_back();
        }
        pages_.insert(pages_.begin(), missed);
        if (goes_on) fetch_in_page(line, missed.step, lines_ahead, fetch);
    }

  private:
    struct Page {
        std::uint64_t page, last;  ///< line that was missed last
        std::int64_t step;         ///< direction of the last two misses: 1, -1, or 0 after the first
    };

    template <class Fetch>
    void fetch_in_page(std::uint64_t line, std::int64_t step, std::uint64_t count, const Fetch& fetch) const {
        const std::uint64_t page = line / lines_of_page_;
        for (; count > 0; --count) {
            line += static_cast<std::uint64_t>(step);
            if (line / lines_of_page_ != page) return;
            fetch(line);
        }
    }

    bool next_line_, stream_;
    std::uint64_t lines_of_page_;
    std::vector<Page> pages_;  ///< the one missed in last is the first
};

}  // namespace edgewise::measure
