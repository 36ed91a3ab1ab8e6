// SPDX-License-Identifier: MIT
//
// The identity of a table is a number that each table takes when it is built; all views of its memory share
// it, and a refit keeps it. A pair notes it, so that a pair kept over a rebuild starts cold instead of
// walking with handles of another topology. A shape may have none: then its user makes a new pair after every
// rebuild.
#pragma once

#include <atomic>
#include <cstdint>

namespace edgewise {

/// Returns another number each time; never 0 before 2^32 tables.
[[nodiscard]] inline std::uint32_t next_table_identity() {
    static std::atomic<std::uint32_t> last{0};
    return last.fetch_add(1, std::memory_order_relaxed) + 1;
}

/// Identity of a table; 0 of a shape that has none.
template <class Table>
[[nodiscard]] std::uint32_t identity_of([[maybe_unused]] const Table& table) {
    if constexpr (requires { table.identity(); }) {
        return table.identity();
    } else {
        return 0;
    }
}

/// Joint identity of two tables, in this order.
template <class TableA, class TableB>
[[nodiscard]] std::uint32_t identity_of(const TableA& a, const TableB& b) {
    return identity_of(a) * 0x9e3779b1U ^ identity_of(b) * 0x85ebca77U;
}

}  // namespace edgewise
