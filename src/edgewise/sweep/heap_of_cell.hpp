// SPDX-License-Identifier: MIT
//
// The heap probe's measurement, each structure in a jemalloc arena of its own: one table, built anew; and
// blocks of the sizes that the caches of a scene's pairs and the arrays of its broad phase have.
#pragma once

#include "edgewise/bench/registry.hpp"
#include "edgewise/measure/heap_use.hpp"
#include "edgewise/scene/workload.hpp"

namespace edgewise::sweep {

/// `body`: one that the tables can store. pair_bytes: of one pair's cache.
[[nodiscard]] measure::HeapUse heap_of_cell(const bench::TableType& type, Parts parts, const Polyhedron& body,
                                            const scene::Workload& workload, std::size_t pair_bytes);

}  // namespace edgewise::sweep
