// SPDX-License-Identifier: MIT
//
// How a scene's tables are placed: in what order a body's vertices are numbered, whether instances share a
// table, and where the memory comes from.
#pragma once

#include <cstdint>

#include "edgewise/bench/memory/allocators.hpp"
#include "edgewise/geometry/vertex_order.hpp"

namespace edgewise::bench {

enum class Sharing : std::uint8_t {
    as_scene,      ///< what the scene is about: shared, but for `pressure`
    shared,        ///< one table a body, instances point at it
    per_instance,  ///< a copy each, as in the paper
};

struct TableOptions {
    VertexOrder order = VertexOrder::given;
    Sharing sharing = Sharing::as_scene;
    AllocatorKind allocator = AllocatorKind::arena;

    [[nodiscard]] bool operator==(const TableOptions&) const = default;
};

}  // namespace edgewise::bench
