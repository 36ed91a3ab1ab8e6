// SPDX-License-Identifier: MIT
#include "edgewise/measure/cache/lines_touched.hpp"

#include <algorithm>

namespace edgewise::measure {

void LineCounter::on_access(const TracedAccess& access) {
    if (access.side == TraceSide::scene) return;
    ++query_.reads;
    query_.bytes += access.bytes;
    const std::uint64_t last = (access.address + access.bytes - 1) / cache_line;
    for (std::uint64_t line = access.address / cache_line; line <= last; ++line)
        lines_.push_back(2 * line + static_cast<std::uint64_t>(access.side));
}

void LineCounter::on_query_end(bool counts) {
    if (counts) {
        std::sort(lines_.begin(), lines_.end());
        sums_.lines += static_cast<std::uint64_t>(std::unique(lines_.begin(), lines_.end()) - lines_.begin());
        sums_.reads += query_.reads;
        sums_.bytes += query_.bytes;
        ++sums_.queries;
    }
    query_ = {};
    lines_.clear();
}

}  // namespace edgewise::measure
