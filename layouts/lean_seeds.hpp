// SPDX-License-Identifier: MIT
//
// The table of `lean` with seeds: the farthest vertices in 26 directions, where cold queries and queries
// after a large turn begin (layout_parts/seeds.hpp). 27 to 108 bytes per table from 32 vertices on. MuJoCo
// keeps 27 seeds with each mesh (layouts/mujoco.hpp).
#pragma once

#include <string_view>

#include "edgewise/layout_parts/seeds.hpp"
#include "edgewise/layouts/lean.hpp"

namespace edgewise {

template <Precision P, class Loader = Direct>
class lean_seeds
    : public TableWithSeeds<Seeded<PlainPoints<typename P::Stored>, CornerDirections>, P, Loader> {
    using Base = TableWithSeeds<Seeded<PlainPoints<typename P::Stored>, CornerDirections>, P, Loader>;

  public:
    static constexpr std::string_view name = "lean_seeds";
    static constexpr std::string_view stores =
        "vertex coordinates, neighbour rings of 8, 16 or 32 bits, and the farthest vertices in 26 directions";

    using Base::Base;
};

}  // namespace edgewise
