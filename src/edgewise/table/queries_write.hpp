// SPDX-License-Identifier: MIT
//
// Whether queries write to a table. A const table is safe to ask from several threads at once, as const
// things are; unless it makes parts of itself when they are first asked for, and says so by
// `static constexpr bool queries_write = true`: such a table serves one thread at a time, and so do all
// views of its memory.
#pragma once

namespace edgewise {

template <class Table>
inline constexpr bool queries_write = requires {
    requires Table::queries_write;
};

}  // namespace edgewise
