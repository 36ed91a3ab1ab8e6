// SPDX-License-Identifier: MIT
#include "edgewise/bench/memory/allocators.hpp"

#include <malloc.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <new>
#include <stdexcept>

#include "edgewise/bench/memory/arena.hpp"
#include "edgewise/bench/memory/jemalloc.hpp"

namespace edgewise::bench {
namespace {

constexpr std::array<std::string_view, 4> allocator_names = {"arena", "jemalloc", "libc", "file"};

class ArenaAllocator final : public TableAllocator {
  public:
    explicit ArenaAllocator(Backing backing) : arena_(backing) {}

    [[nodiscard]] std::size_t taken() const override { return arena_.used(); }
    [[nodiscard]] std::optional<std::size_t> resident() const override { return arena_.resident(); }
    [[nodiscard]] const std::byte* base() const override { return arena_.base(); }
    [[nodiscard]] bool evict() const override { return arena_.mapping().evict(arena_.used()); }
    [[nodiscard]] bool keeps_recency() const override { return arena_.mapping().keeps_recency(); }

  private:
    void* do_allocate(std::size_t bytes, std::size_t alignment) override {
        void* const memory = arena_.allocate(bytes, alignment);
        requested_ += bytes;
        return memory;
    }
    void do_deallocate(void* memory, std::size_t bytes, std::size_t alignment) override {
        requested_ -= bytes;
        arena_.deallocate(memory, bytes, alignment);
    }

    Arena arena_;
};

/// glibc: a chunk has a header of one word in front of what malloc_usable_size says. (Chunks that are mapped
/// apart, from 128 KiB on to begin with, have two: the second is not counted.)
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

/// An arena of its own, so that its statistics are of these tables alone.
class JemallocAllocator final : public TableAllocator {
  public:
    [[nodiscard]] std::optional<std::size_t> by_its_statistics() const override { return arena_.allocated(); }
    [[nodiscard]] std::optional<std::size_t> resident() const override { return arena_.resident(); }

  private:
    void* do_allocate(std::size_t bytes, std::size_t alignment) override {
        void* const memory = arena_.allocate(bytes, alignment);
        requested_ += bytes;
        taken_ += arena_.size_class(bytes, alignment);
        return memory;
    }
    void do_deallocate(void* memory, std::size_t bytes, std::size_t alignment) override {
        requested_ -= bytes;
        taken_ -= arena_.size_class(bytes, alignment);
        arena_.deallocate(memory, bytes, alignment);
    }

    JemallocArena arena_;
};

}  // namespace

std::string_view to_string(AllocatorKind kind) { return allocator_names[static_cast<std::size_t>(kind)]; }

std::optional<AllocatorKind> allocator_from(std::string_view name) {
    const auto found = std::find(allocator_names.begin(), allocator_names.end(), name);
    if (found == allocator_names.end()) return std::nullopt;
    return static_cast<AllocatorKind>(found - allocator_names.begin());
}

const std::vector<AllocatorInfo>& allocators_known() {
    static const std::vector<AllocatorInfo> known = {
        {allocator_names[0], "tables one behind the other from a multiple of 2 MiB"},
        {allocator_names[1], "jemalloc's size classes, in a jemalloc arena of its own"},
        {allocator_names[2], "the C library's malloc"},
        {allocator_names[3], "as arena, in a temporary file on a disk: pages can leave memory and come back"},
    };
    return known;
}

std::unique_ptr<TableAllocator> make_allocator(AllocatorKind kind) {
    switch (kind) {
        case AllocatorKind::arena:
            return std::make_unique<ArenaAllocator>(Backing::memory);
        case AllocatorKind::file:
            return std::make_unique<ArenaAllocator>(Backing::file);
        case AllocatorKind::libc:
            return std::make_unique<LibcAllocator>();
        case AllocatorKind::jemalloc:
            break;
    }
    if (!JemallocArena::available()) {
        throw std::runtime_error(
            "allocator jemalloc: this program was built without it; install libjemalloc-dev and build again "
            "(it is left out under sanitizers)");
    }
    return std::make_unique<JemallocAllocator>();
}

}  // namespace edgewise::bench
