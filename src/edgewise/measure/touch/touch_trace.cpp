// SPDX-License-Identifier: MIT
#include "edgewise/measure/touch/touch_trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace edgewise::measure {

void Structure::book(const std::string& component, std::uint64_t bytes) {
    for (ComponentBytes& booked : bytes_) {
        if (booked.component != component) continue;
        booked.bytes += bytes;
        return;
    }
    bytes_.push_back({component, bytes});
}

void Structure::put(const Stretch& stretch) {
    const auto behind = std::ranges::upper_bound(stretches_, stretch.from, {}, &Stretch::from);
    const auto overlap = [&](const Stretch& other) {
        refuse(fmt::format("the arrays '{}' and '{}' overlap: add each byte once", other.name, stretch.name));
    };
    if (behind != stretches_.end() && behind->from < stretch.to) overlap(*behind);
    if (behind != stretches_.begin() && std::prev(behind)->to > stretch.from) overlap(*std::prev(behind));
    stretches_.insert(behind, stretch);
}

void Structure::add_memory(const std::string& name, const void* at, std::size_t count, std::size_t stride,
                           const std::vector<Member>& members, std::size_t alignment) {
    std::size_t named = 0;
    for (const Member& member : members) {
        book(name + "." + member.name, std::uint64_t{member.bytes} * count);
        named += member.bytes;
    }
    if (named > stride)
        refuse(fmt::format("the members of '{}' have {} bytes, an element has {}", name, named, stride));
    if (!std::has_single_bit(alignment))
        refuse(fmt::format("'{}' is aligned to {}, which is no power of two", name, alignment));
    if (!problem_.empty()) return;
    book(name + ".padding", std::uint64_t{stride - named} * count);
    const std::uint64_t bytes = std::uint64_t{stride} * count;
    if (bytes == 0) return;
    const std::uint64_t place = (next_ + alignment - 1) / alignment * alignment;
    const auto from = reinterpret_cast<std::uintptr_t>(at);
    put({from, from + bytes, place, name});
    next_ = place + bytes;
}

std::optional<std::uint64_t> Structure::place_of(const void* address, std::size_t bytes) const {
    const auto from = reinterpret_cast<std::uintptr_t>(address);
    const auto behind = std::ranges::upper_bound(stretches_, from, {}, &Stretch::from);
    if (behind == stretches_.begin()) return std::nullopt;
    const Stretch& in = *std::prev(behind);
    if (from >= in.to || bytes > in.to - from) return std::nullopt;
    return in.place + (from - in.from);
}

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
