// SPDX-License-Identifier: MIT
//
// Flags of jemalloc's extended interface, as its manual (section "Non-standard API") defines them: the
// alignment's binary logarithm; no thread cache, so that statistics are exact; and the arena.
#include "edgewise/bench/memory/jemalloc.hpp"

#include <jemalloc/jemalloc.h>

#include <cstdint>
#include <new>
#include <stdexcept>
#include <string>

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

int flags(unsigned arena, std::size_t alignment) {
    return MALLOCX_ALIGN(alignment) | MALLOCX_TCACHE_NONE | MALLOCX_ARENA(arena);
}

}  // namespace

bool JemallocArena::available() { return true; }

JemallocArena::JemallocArena() : arena_(control<unsigned>("arenas.create")) {}

JemallocArena::~JemallocArena() {
    const std::string name = "arena." + std::to_string(arena_) + ".destroy";
    mallctl(name.c_str(), nullptr, nullptr, nullptr, 0);
}

void* JemallocArena::allocate(std::size_t bytes, std::size_t alignment) {
    void* const memory = mallocx(bytes, flags(arena_, alignment));
    if (!memory) throw std::bad_alloc();
    return memory;
}

void JemallocArena::deallocate(void* memory, std::size_t bytes, std::size_t alignment) {
    sdallocx(memory, bytes, flags(arena_, alignment));
}

std::size_t JemallocArena::size_class(std::size_t bytes, std::size_t alignment) const {
    return nallocx(bytes, flags(arena_, alignment));
}

namespace {

/// One of an arena's numbers; jemalloc brings them up to date when the epoch is written.
std::size_t statistic(unsigned arena, const char* name) {
    control<std::uint64_t>("epoch", 1, true);
    return control<std::size_t>("stats.arenas." + std::to_string(arena) + name);
}

}  // namespace

std::size_t JemallocArena::allocated() const {
    return statistic(arena_, ".small.allocated") + statistic(arena_, ".large.allocated");
}

std::size_t JemallocArena::resident() const { return statistic(arena_, ".resident"); }

}  // namespace edgewise::bench
