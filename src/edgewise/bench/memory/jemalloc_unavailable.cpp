// SPDX-License-Identifier: MIT
#include "edgewise/bench/memory/allocators.hpp"

namespace edgewise::bench {

std::unique_ptr<TableAllocator> make_jemalloc() { return nullptr; }

}  // namespace edgewise::bench
