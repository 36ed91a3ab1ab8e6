// SPDX-License-Identifier: MIT
#include "edgewise/measure/lines_touched.hpp"

#include <algorithm>

namespace edgewise {

void LineSink::read(const void* address, std::size_t size) {
    const auto from = reinterpret_cast<std::uintptr_t>(address);
    ++reads_;
    bytes_ += size;
    for (auto line = from / cache_line; line <= (from + size - 1) / cache_line; ++line)
        lines_.push_back(line);
}

void LineSink::add_to(LinesTouched& sum) {
    std::sort(lines_.begin(), lines_.end());
    sum.lines += static_cast<std::uint64_t>(std::unique(lines_.begin(), lines_.end()) - lines_.begin());
    sum.reads += reads_;
    sum.bytes += bytes_;
    forget();
}

void LineSink::forget() {
    lines_.clear();
    reads_ = bytes_ = 0;
}

}  // namespace edgewise
