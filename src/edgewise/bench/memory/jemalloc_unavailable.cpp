// SPDX-License-Identifier: MIT
#include <cstdlib>

#include "edgewise/bench/memory/jemalloc.hpp"

namespace edgewise::bench {

bool JemallocArena::available() { return false; }
JemallocArena::JemallocArena() { std::abort(); }
JemallocArena::~JemallocArena() = default;
void* JemallocArena::allocate(std::size_t /*bytes*/, std::size_t /*alignment*/) { std::abort(); }
void JemallocArena::deallocate(void* /*memory*/, std::size_t /*bytes*/, std::size_t /*alignment*/) {}
std::size_t JemallocArena::size_class(std::size_t bytes, std::size_t /*alignment*/) const { return bytes; }
std::size_t JemallocArena::allocated() const { return 0; }
std::size_t JemallocArena::resident() const { return 0; }

}  // namespace edgewise::bench
