// SPDX-License-Identifier: MIT
#include "edgewise/bench/memory/arena.hpp"

#include <new>

namespace edgewise::bench {

void* Arena::do_allocate(std::size_t bytes, std::size_t align) {
    const std::size_t start = (used_ + align - 1) / align * align;
    if (bytes > TableMapping::bytes() || start > TableMapping::bytes() - bytes) throw std::bad_alloc();
    used_ = start + bytes;
    return mapping_.base() + start;
}

}  // namespace edgewise::bench
