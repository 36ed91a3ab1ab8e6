// SPDX-License-Identifier: MIT
//
// Which table a handle belongs to: a number that each table takes when it is built, shared by all views of
// its memory and kept when its geometry is refitted. A pair notes it, so that one kept over a rebuild is
// started cold instead of walking with handles of another topology. A shape may go without: then its user
// makes a new pair after every rebuild.
#pragma once

#include <atomic>
#include <cstdint>

namespace edgewise {

/// Another number each time; never 0 before 2^32 tables.
[[nodiscard]] inline std::uint32_t next_table_identity() {
    static std::atomic<std::uint32_t> last{0};
    return last.fetch_add(1, std::memory_order_relaxed) + 1;
}

/// 0 of a shape that has none.
template <class Table>
[[nodiscard]] std::uint32_t identity_of([[maybe_unused]] const Table& table) {
    if constexpr (requires { table.identity(); }) {
        return table.identity();
    } else {
        return 0;
    }
}

/// Of two tables in this order.
template <class TableA, class TableB>
[[nodiscard]] std::uint32_t identity_of(const TableA& a, const TableB& b) {
    return identity_of(a) * 0x9e3779b1U ^ identity_of(b) * 0x85ebca77U;
}

}  // namespace edgewise
