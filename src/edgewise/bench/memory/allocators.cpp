// SPDX-License-Identifier: MIT
#include "edgewise/bench/memory/allocators.hpp"

#include <malloc.h>

#include <cstdlib>
#include <new>
#include <stdexcept>

#include "edgewise/bench/memory/arena.hpp"

namespace edgewise::bench {
namespace {

/// glibc: a chunk has a header of one word in front of what malloc_usable_size says. (Chunks that are mapped
/// separately, from 128 KiB on to begin with, have two: the second is not counted.)
class LibcAllocator final : public TableAllocator {
    static std::size_t chunk(void* memory) { return malloc_usable_size(memory) + sizeof(std::size_t); }

    void* do_allocate(std::size_t bytes, std::size_t alignment) override {
        const std::size_t whole = (bytes + alignment - 1) / alignment * alignment;
        void* const memory = alignment <= alignof(std::max_align_t) ? std::malloc(bytes)
                                                                    : std::aligned_alloc(alignment, whole);
        if (!memory) throw std::bad_alloc();
        requested_ += bytes;
        taken_ += chunk(memory);
        return memory;
    }
    void do_deallocate(void* memory, std::size_t bytes, std::size_t /*alignment*/) override {
        requested_ -= bytes;
        taken_ -= chunk(memory);
        std::free(memory);
    }
};

}  // namespace

std::span<const AllocatorInfo> allocators_known() {
    static constexpr AllocatorInfo known[] = {
        {"arena", "tables one behind the other from a multiple of 2 MiB"},
        {"jemalloc", "jemalloc's size classes, in a jemalloc arena of its own"},
        {"libc", "the C library's malloc"},
        {"file", "as arena, in a temporary file on a disk: pages can leave memory and come back"},
        {"memfd", "as arena, in shared memory: a pager of this program can take pages away"},
    };
    return known;
}

std::string_view to_string(AllocatorKind kind) {
    return allocators_known()[static_cast<std::size_t>(kind)].name;
}

std::optional<AllocatorKind> allocator_from(std::string_view name) {
    for (std::size_t i = 0; i < allocators_known().size(); ++i) {
        if (allocators_known()[i].name == name) return static_cast<AllocatorKind>(i);
    }
    return std::nullopt;
}

std::unique_ptr<TableAllocator> make_allocator(AllocatorKind kind) {
    if (kind == AllocatorKind::arena) return std::make_unique<Arena>(Backing::memory);
    if (kind == AllocatorKind::file) return std::make_unique<Arena>(Backing::file);
    if (kind == AllocatorKind::memfd) return std::make_unique<Arena>(Backing::shared_memory);
    if (kind == AllocatorKind::libc) return std::make_unique<LibcAllocator>();
    auto jemalloc = make_jemalloc();
    if (!jemalloc)
        throw std::runtime_error(
            "allocator jemalloc: this program was built without it; install libjemalloc-dev and build again "
            "(it is left out under sanitizers)");
    return jemalloc;
}

}  // namespace edgewise::bench
