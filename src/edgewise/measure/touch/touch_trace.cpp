// SPDX-License-Identifier: MIT
#include "edgewise/measure/touch/touch_trace.hpp"

#include <fmt/format.h>

namespace edgewise::measure {

static_assert(sizeof(TracedAccess) == 16, "touch_trace.hpp says so");

TouchTrace::TouchTrace(Structure structure, std::vector<std::string> fields)
    : structure_(std::move(structure)), fields_(std::move(fields)), problem_(structure_.problem()) {
    if (problem_.empty() && (fields_.empty() || fields_.size() > 256))
        problem_ = fmt::format("a trace has 1 to 256 fields, this has {}", fields_.size());
}

void TouchTrace::start_query(QueryStart start) {
    end_query();
    queries_.push_back({accesses_.size(), accesses_.size(), start});
    in_query_ = true;
}

void TouchTrace::end_query() {
    if (in_query_) queries_.back().last = accesses_.size();
    in_query_ = false;
}

void TouchTrace::refuse(std::size_t bytes, std::size_t field) {
    if (!problem_.empty()) return;
    problem_ = field < fields_.size()
                   ? fmt::format("{} bytes of field '{}' (touch {}) lie in no array of the structure", bytes,
                                 fields_[field], accesses_.size() + 1)
                   : fmt::format("field {} of touch {} has no name", field, accesses_.size() + 1);
}

void TouchTrace::note(const void* address, std::size_t bytes, AccessKind kind, std::size_t field) {
    if (bytes == 0) return;
    const std::optional<std::uint64_t> place = structure_.place_of(address, bytes);
    if (!place || field >= fields_.size()) return refuse(bytes, field);
    accesses_.push_back({*place, static_cast<std::uint32_t>(bytes), kind, static_cast<std::uint8_t>(field), 0,
                         in_query_ ? TraceSide::table_a : TraceSide::scene});
}

void TouchTrace::replay(TraceListener& listener) const {
    std::size_t next = 0;
    const auto tell_to = [&](std::size_t end) {
        for (; next < end; ++next) listener.on_access(accesses_[next]);
    };
    for (std::size_t i = 0; i < queries_.size(); ++i) {
        const bool open = in_query_ && i + 1 == queries_.size();
        tell_to(queries_[i].first);
        listener.on_query_start(queries_[i].start);
        tell_to(open ? accesses_.size() : queries_[i].last);
        listener.on_query_end(true);
    }
    tell_to(accesses_.size());
}

}  // namespace edgewise::measure
