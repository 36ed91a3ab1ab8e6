// SPDX-License-Identifier: MIT
//
// An arena for tables: one stretch of addresses that starts on a multiple of 2 MiB, filled from its start. So
// a table lies at the same offset on every machine and in every run, tables follow each other without
// headers, and what a cache model makes of an offset is the same everywhere. Memory is given back all at
// once, when the arena goes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <optional>

namespace edgewise {

class Arena final : public std::pmr::memory_resource {
  public:
    /// Where the arena starts: the size of a large page. Large pages are declined all the same, so that what
    /// is resident is what was written.
    static constexpr std::size_t alignment = std::size_t{2} << 20;

    /// Takes no memory yet, only addresses. Throws std::bad_alloc when there are not even those.
    Arena();
    ~Arena() override;
    Arena(const Arena&) = delete;
    Arena& operator=(const Arena&) = delete;

    [[nodiscard]] const std::byte* base() const { return base_; }
    /// Bytes from the start that are taken, gaps for alignment included.
    [[nodiscard]] std::size_t used() const { return used_; }
    /// Bytes of pages that the operating system has really given to it; nothing when it does not say.
    [[nodiscard]] std::optional<std::size_t> resident() const;

  private:
    void* do_allocate(std::size_t bytes, std::size_t align) override;
    void do_deallocate(void* /*memory*/, std::size_t /*bytes*/, std::size_t /*align*/) override {}
    [[nodiscard]] bool do_is_equal(const memory_resource& other) const noexcept override {
        return this == &other;
    }

    std::byte* reserved_;
    std::byte* base_;
    std::size_t used_ = 0;
};

}  // namespace edgewise
