// SPDX-License-Identifier: MIT
//
// One arena of jemalloc, by its own interface. jemalloc is linked with all its symbols but these hidden, so
// that the C library's malloc stays what the rest of the program uses.
//
// Flags of the extended interface, as jemalloc's manual (section "Non-standard API") defines them: the
// alignment's binary logarithm; no thread cache, so that statistics are exact; and the arena.
#include <jemalloc/jemalloc.h>

#include <new>
#include <stdexcept>
#include <string>

#include "edgewise/bench/memory/allocators.hpp"

namespace edgewise::bench {
namespace {

template <class Value>
Value control(const std::string& name, Value value = {}, bool write = false) {
    std::size_t size = sizeof(Value);
    const int error = write ? mallctl(name.c_str(), nullptr, nullptr, &value, size)
                            : mallctl(name.c_str(), &value, &size, nullptr, 0);
    if (error != 0) throw std::runtime_error("jemalloc: control " + name + " failed");
    return value;
}

/// An arena for the tables only, so that its statistics count nothing else.
class JemallocAllocator final : public TableAllocator {
  public:
    JemallocAllocator() : arena_(control<unsigned>("arenas.create")) {}
    ~JemallocAllocator() override {
        const std::string name = "arena." + std::to_string(arena_) + ".destroy";
        mallctl(name.c_str(), nullptr, nullptr, nullptr, 0);
    }
    JemallocAllocator(const JemallocAllocator&) = delete;
    JemallocAllocator& operator=(const JemallocAllocator&) = delete;

    [[nodiscard]] std::optional<std::size_t> by_its_statistics() const override {
        return statistic(".small.allocated") + statistic(".large.allocated");
    }
    /// Its own books included.
    [[nodiscard]] std::optional<std::size_t> resident() const override { return statistic(".resident"); }

  private:
    void* do_allocate(std::size_t bytes, std::size_t alignment) override {
        void* const memory = mallocx(bytes, flags(alignment));
        if (!memory) throw std::bad_alloc();
        requested_ += bytes;
        taken_ += nallocx(bytes, flags(alignment));
        return memory;
    }
    void do_deallocate(void* memory, std::size_t bytes, std::size_t alignment) override {
        requested_ -= bytes;
        taken_ -= nallocx(bytes, flags(alignment));
        sdallocx(memory, bytes, flags(alignment));
    }

    [[nodiscard]] int flags(std::size_t alignment) const {
        return MALLOCX_ALIGN(alignment) | MALLOCX_TCACHE_NONE | MALLOCX_ARENA(arena_);
    }
    /// One of the arena's numbers; jemalloc brings them up to date when the epoch is written.
    [[nodiscard]] std::size_t statistic(const char* name) const {
        control<std::uint64_t>("epoch", 1, true);
        return control<std::size_t>("stats.arenas." + std::to_string(arena_) + name);
    }

    unsigned arena_;
};

}  // namespace

std::unique_ptr<TableAllocator> make_jemalloc() { return std::make_unique<JemallocAllocator>(); }

}  // namespace edgewise::bench
