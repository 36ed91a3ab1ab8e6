// SPDX-License-Identifier: MIT
#include "edgewise/measure/cache/lines_touched.hpp"

#include <utility>

namespace edgewise::measure {

LinesTouched& LinesTouched::operator+=(const LinesTouched& other) {
    queries += other.queries;
    reads += other.reads;
    bytes += other.bytes;
    lines += other.lines;
    return *this;
}

bool LineCounter::is_new(std::uint64_t line) {
    // Multiplicative hashing (Knuth, volume 3, 6.4); the high half of the product is the better one.
    for (std::uint64_t at = line * 0x9e3779b97f4a7c15 >> 32;; ++at) {
        Seen& seen = seen_[at & (seen_.size() - 1)];
        if (seen.query == query_number_ && seen.line == line) return false;
        if (seen.query == query_number_) continue;
        seen = {line, query_number_};
        return true;
    }
}

void LineCounter::grow() {
    const std::vector<Seen> before = std::exchange(seen_, std::vector<Seen>(2 * seen_.size()));
    for (const Seen& seen : before)
        if (seen.query == query_number_) is_new(seen.line);
}

void LineCounter::on_access(const TracedAccess& access) {
    if (access.side == TraceSide::scene) return;
    ++query_.reads;
    query_.bytes += access.bytes;
    access.for_each_unit(cache_line, [&](std::uint64_t line) {
        if (is_new(2 * line + static_cast<std::uint64_t>(access.side))) ++query_.lines;
        if (2 * query_.lines > seen_.size()) grow();
    });
}

void LineCounter::on_query_end(bool /*counts*/) {
    query_.queries = 1;
    sums_.each(start_, [&](LinesTouched& sum) { sum += query_; });
    query_ = {};
    start_.reset();
    ++query_number_;
}

}  // namespace edgewise::measure
