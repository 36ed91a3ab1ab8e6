// SPDX-License-Identifier: MIT
#include "edgewise/measure/cache/lines_touched.hpp"

namespace edgewise::measure {

void LineCounter::on_access(const TracedAccess& access) {
    if (access.side == TraceSide::scene) return;
    ++query_.reads;
    query_.bytes += access.bytes;
    access.for_each_unit(cache_line, [&](std::uint64_t line) {
        const std::uint64_t place = 2 * line + static_cast<std::uint64_t>(access.side);
        if (place >= last_query_.size()) last_query_.resize(2 * place + 2);
        if (last_query_[place] != query_number_) ++query_.lines;
        last_query_[place] = query_number_;
    });
}

void LineCounter::on_query_end(bool counts) {
    if (counts) {
        sums_.lines += query_.lines;
        sums_.reads += query_.reads;
        sums_.bytes += query_.bytes;
        ++sums_.queries;
    }
    query_ = {};
    ++query_number_;
}

}  // namespace edgewise::measure
