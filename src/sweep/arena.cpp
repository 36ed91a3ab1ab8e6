// SPDX-License-Identifier: MIT
//
// Addresses are reserved once, far more than any scene needs, and become memory page by page as they are
// written to: mmap without a swap reservation.
#include "edgewise/sweep/arena.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <new>
#include <vector>

namespace edgewise {
namespace {

constexpr std::size_t reserve_bytes = std::size_t{16} << 30;

}  // namespace

Arena::Arena() {
    void* const place = mmap(nullptr, reserve_bytes + alignment, PROT_READ | PROT_WRITE,
                             MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (place == MAP_FAILED) throw std::bad_alloc();
    reserved_ = static_cast<std::byte*>(place);
    const auto address = reinterpret_cast<std::uintptr_t>(place);
    base_ = reserved_ + (alignment - address % alignment) % alignment;
    madvise(base_, reserve_bytes, MADV_NOHUGEPAGE);
}

Arena::~Arena() { munmap(reserved_, reserve_bytes + alignment); }

void* Arena::do_allocate(std::size_t bytes, std::size_t align) {
    const std::size_t start = (used_ + align - 1) / align * align;
    if (bytes > reserve_bytes || start > reserve_bytes - bytes) throw std::bad_alloc();
    used_ = start + bytes;
    return base_ + start;
}

std::optional<std::size_t> Arena::resident() const {
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    const std::size_t pages = (used_ + page - 1) / page;
    std::vector<unsigned char> in_memory(pages);
    if (pages > 0 && mincore(base_, pages * page, in_memory.data()) != 0) return std::nullopt;
    std::size_t count = 0;
    for (const unsigned char there : in_memory) count += there & 1U;
    return count * page;
}

}  // namespace edgewise
