// SPDX-License-Identifier: MIT
//
// Replaces the global operator new and delete of this program.
#include "counted_allocations.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <new>

namespace edgewise {
namespace {

struct Allocation {
    const std::byte* address;
    std::size_t bytes;
};

struct Log {
    bool counting = false;
    std::size_t count = 0, live = 0;
    std::array<Allocation, 1 << 14> alive{};  // an array, because the log must not allocate
};

Log log_;

void* allocate(std::size_t bytes, std::size_t alignment) {
    const std::size_t whole = (std::max<std::size_t>(bytes, 1) + alignment - 1) / alignment * alignment;
    void* const address = std::aligned_alloc(alignment, whole);
    if (!address) throw std::bad_alloc();
    if (log_.counting) {
        ++log_.count;
        if (log_.live == log_.alive.size()) std::abort();
        log_.alive[log_.live++] = {static_cast<const std::byte*>(address), bytes};
    }
    return address;
}

void release(void* address) noexcept {
    for (std::size_t i = log_.live; log_.counting && i > 0; --i) {  // most releases are of recent allocations
        if (log_.alive[i - 1].address != address) continue;
        log_.alive[i - 1] = log_.alive[--log_.live];
        break;
    }
    std::free(address);
}

}  // namespace

CountedAllocations::CountedAllocations() {
    log_.count = 0;
    log_.live = 0;
    log_.counting = true;
}

CountedAllocations::~CountedAllocations() { log_.counting = false; }

std::size_t CountedAllocations::count() const { return log_.count; }

std::size_t CountedAllocations::live_bytes() const {
    std::size_t sum = 0;
    for (std::size_t i = 0; i < log_.live; ++i) sum += log_.alive[i].bytes;
    return sum;
}

}  // namespace edgewise

void* operator new(std::size_t bytes) { return edgewise::allocate(bytes, alignof(std::max_align_t)); }
void* operator new(std::size_t bytes, std::align_val_t alignment) {
    return edgewise::allocate(bytes, static_cast<std::size_t>(alignment));
}
void operator delete(void* address) noexcept { edgewise::release(address); }
void operator delete(void* address, std::size_t) noexcept { edgewise::release(address); }
void operator delete(void* address, std::align_val_t) noexcept { edgewise::release(address); }
void operator delete(void* address, std::size_t, std::align_val_t) noexcept { edgewise::release(address); }
