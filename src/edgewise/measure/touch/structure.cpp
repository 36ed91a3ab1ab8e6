// SPDX-License-Identifier: MIT
#include "edgewise/measure/touch/structure.hpp"

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
    const auto behind =
        std::upper_bound(stretches_.begin(), stretches_.end(), stretch.from,
                         [](std::uintptr_t from, const Stretch& other) { return from < other.from; });
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
    const auto behind =
        std::upper_bound(stretches_.begin(), stretches_.end(), from,
                         [](std::uintptr_t at, const Stretch& stretch) { return at < stretch.from; });
    if (behind == stretches_.begin()) return std::nullopt;
    const Stretch& in = *std::prev(behind);
    if (from >= in.to || bytes > in.to - from) return std::nullopt;
    return in.place + (from - in.from);
}

}  // namespace edgewise::measure
