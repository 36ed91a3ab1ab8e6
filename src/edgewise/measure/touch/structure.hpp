// SPDX-License-Identifier: MIT
//
// A user's own structure, as a trace of it needs it: which arrays it has and what each element's bytes are
// for. Addresses become places that are the same in every run: arrays follow each other in the order in which
// they were added, each from the start of a cache line, as an aligned allocation has it. Where an array
// really begins within a line is the allocator's chance and no layout's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <ranges>
#include <string>
#include <vector>

namespace edgewise::measure {

/// So many bytes of an element serve this member.
struct Member {
    std::string name;
    std::size_t bytes;
};

/// Bytes of a component of a structure, such as "nodes.children".
struct ComponentBytes {
    std::string component;
    std::uint64_t bytes;
};

class Structure {
  public:
    /// Its elements must stay where they are as long as they are traced: add arrays when they are built. What
    /// no member takes of an element is its padding. An array may be added in parts of one name.
    template <std::ranges::contiguous_range Array>
    void add_array(const std::string& name, const Array& elements, const std::vector<Member>& members) {
        add_memory(name, std::ranges::data(elements), std::ranges::size(elements),
                   sizeof(std::ranges::range_value_t<Array>), members);
    }

    /// `count` elements, `stride` bytes apart, placed at a multiple of `alignment`, a power of two: a line
    /// for what is allocated as a whole, less for nodes that are allocated one by one.
    void add_memory(const std::string& name, const void* at, std::size_t count, std::size_t stride,
                    const std::vector<Member>& members, std::size_t alignment = 64);

    /// Where these bytes lie; nothing: no array has them all.
    [[nodiscard]] std::optional<std::uint64_t> place_of(const void* address, std::size_t bytes) const;

    /// Of every member and of every array's padding, in the order in which they were added.
    [[nodiscard]] const std::vector<ComponentBytes>& bytes() const { return bytes_; }

    /// What is wrong with what was added; empty: nothing.
    [[nodiscard]] const std::string& problem() const { return problem_; }

  private:
    struct Stretch {
        std::uintptr_t from, to;  ///< past its end
        std::uint64_t place;
        std::string name;
    };

    void book(const std::string& component, std::uint64_t bytes);
    void put(const Stretch& stretch);
    void refuse(const std::string& problem) {
        if (problem_.empty()) problem_ = problem;
    }

    std::vector<Stretch> stretches_;  ///< by address
    std::vector<ComponentBytes> bytes_;
    std::uint64_t next_ = 0;
    std::string problem_;
};

}  // namespace edgewise::measure
