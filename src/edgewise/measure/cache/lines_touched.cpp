// SPDX-License-Identifier: MIT
#include "edgewise/measure/cache/lines_touched.hpp"

namespace edgewise::measure {

LinesTouched& LinesTouched::operator+=(const LinesTouched& other) {
    queries += other.queries;
    reads += other.reads;
    bytes += other.bytes;
    lines += other.lines;
    return *this;
}

void LineCounter::on_access(const TracedAccess& access) {
    if (access.side == TraceSide::scene) return;
    ++query_.reads;
    query_.bytes += access.bytes;
    access.for_each_unit(cache_line, [&](std::uint64_t line) {
        lines_.insert(2 * line + static_cast<std::uint64_t>(access.side));
    });
}

void LineCounter::on_query_end(bool /*counts*/) {
    query_.queries = 1;
    query_.lines = lines_.size();
    sums_.each(start_, [&](LinesTouched& sum) { sum += query_; });
    query_ = {};
    lines_.clear();
    start_.reset();
}

}  // namespace edgewise::measure
