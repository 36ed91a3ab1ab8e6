// SPDX-License-Identifier: MIT
//
// Memory for tables that records its allocations.
#pragma once

#include <cstddef>
#include <map>
#include <memory_resource>

namespace edgewise {

class CountedMemory final : public std::pmr::memory_resource {
  public:
    /// Bytes that are allocated and not freed.
    [[nodiscard]] std::size_t live_bytes() const { return live_bytes_; }

    /// Returns true if these bytes lie inside one piece of memory that is in use.
    [[nodiscard]] bool hold(const void* address, std::size_t bytes) const {
        const auto* const from = static_cast<const std::byte*>(address);
        auto after = live_.upper_bound(from);
        if (after == live_.begin()) return false;
        const auto& [start, size] = *--after;
        return from + bytes <= start + size;
    }

  private:
    void* do_allocate(std::size_t bytes, std::size_t alignment) override {
        void* const memory = std::pmr::new_delete_resource()->allocate(bytes, alignment);
        live_[static_cast<std::byte*>(memory)] = bytes;
        live_bytes_ += bytes;
        return memory;
    }
    void do_deallocate(void* memory, std::size_t bytes, std::size_t alignment) override {
        live_.erase(static_cast<std::byte*>(memory));
        live_bytes_ -= bytes;
        std::pmr::new_delete_resource()->deallocate(memory, bytes, alignment);
    }
    [[nodiscard]] bool do_is_equal(const memory_resource& other) const noexcept override {
        return this == &other;
    }

    std::map<const std::byte*, std::size_t> live_;
    std::size_t live_bytes_ = 0;
};

}  // namespace edgewise
