// SPDX-License-Identifier: MIT
//
// One arena of jemalloc, by its own interface. jemalloc is linked with all its symbols but these hidden, so
// that the C library's malloc stays what the rest of the program uses.
#pragma once

#include <cstddef>

namespace edgewise::bench {

class JemallocArena {
  public:
    /// Whether this program holds jemalloc; without it nothing else may be called.
    [[nodiscard]] static bool available();

    JemallocArena();
    ~JemallocArena();
    JemallocArena(const JemallocArena&) = delete;
    JemallocArena& operator=(const JemallocArena&) = delete;

    /// Throws std::bad_alloc.
    [[nodiscard]] void* allocate(std::size_t bytes, std::size_t alignment);
    void deallocate(void* memory, std::size_t bytes, std::size_t alignment);

    /// What a request really gets (nallocx).
    [[nodiscard]] std::size_t size_class(std::size_t bytes, std::size_t alignment) const;

    /// Of this arena, by jemalloc's statistics: small and large.
    [[nodiscard]] std::size_t allocated() const;
    /// Bytes of its pages in memory, its own books included.
    [[nodiscard]] std::size_t resident() const;

  private:
    unsigned arena_ = 0;
};

}  // namespace edgewise::bench
