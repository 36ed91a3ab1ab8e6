// SPDX-License-Identifier: MIT
//
// What queries read of their tables: distinct cache lines of 64 bytes, which is what a cache sees, beside the
// bytes that were asked for. Each side of a pair is a table of its own here, whether or not they share one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace edgewise {

inline constexpr std::size_t cache_line = 64;

/// How many queries are traced: the first ones of a scene, pair after pair; enough for a mean to a few
/// percent.
inline constexpr std::size_t traced_queries = 1000;

/// Sums over queries.
struct LinesTouched {
    std::uint64_t queries = 0, reads = 0, bytes = 0, lines = 0;
};

/// A sink of traced loaders that gathers one query's lines.
class LineSink {
  public:
    /// What of a table it is does not matter here.
    template <class Field>
    void read(const void* address, std::size_t size, Field /*field*/) {
        read(address, size);
    }
    /// Not to be inlined: query loops call it at every read.
    void read(const void* address, std::size_t size);

    /// Adds what was read since the last call; whether it counts as a query is the caller's.
    void add_to(LinesTouched& sum);
    void forget();

  private:
    std::vector<std::uintptr_t> lines_;
    std::uint64_t reads_ = 0, bytes_ = 0;
};

}  // namespace edgewise
