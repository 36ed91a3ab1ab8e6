// SPDX-License-Identifier: MIT
//
// The source of the tables' memory: any std::pmr::memory_resource, one place for all layouts. A choice
// applies to tables that this thread builds while the choice lives; each table gives its memory back to its
// own source, which must outlive it.
#pragma once

#include <memory_resource>

namespace edgewise {

namespace detail {
inline std::pmr::memory_resource*& table_memory_of_thread() {
    thread_local std::pmr::memory_resource* current = std::pmr::new_delete_resource();
    return current;
}
}  // namespace detail

/// Memory resource of a table built now; operator new if there is no choice.
[[nodiscard]] inline std::pmr::memory_resource& table_memory() { return *detail::table_memory_of_thread(); }

/// Chooses a memory resource for as long as this object lives; choices nest.
class TablesIn {
  public:
    explicit TablesIn(std::pmr::memory_resource& resource) : before_(detail::table_memory_of_thread()) {
        detail::table_memory_of_thread() = &resource;
    }
    ~TablesIn() { detail::table_memory_of_thread() = before_; }
    TablesIn(const TablesIn&) = delete;
    TablesIn& operator=(const TablesIn&) = delete;

  private:
    std::pmr::memory_resource* before_;
};

}  // namespace edgewise
