// SPDX-License-Identifier: MIT
//
// Where tables take their memory from: one seam for all layouts, any std::pmr::memory_resource. What is
// chosen holds for tables that this thread builds while the choice lives; each table gives its memory back to
// where it came from, which must outlive it.
#pragma once

#include <memory_resource>

namespace edgewise {

namespace detail {
inline std::pmr::memory_resource*& table_memory_of_thread() {
    thread_local std::pmr::memory_resource* current = std::pmr::new_delete_resource();
    return current;
}
}  // namespace detail

/// What a table built now takes its memory from; operator new unless somebody chose.
[[nodiscard]] inline std::pmr::memory_resource& table_memory() { return *detail::table_memory_of_thread(); }

/// A choice, for as long as it lives; choices nest.
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
