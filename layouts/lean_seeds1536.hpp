// SPDX-License-Identifier: MIT
//
// The table of `lean_seeds` with seeds in 1536 directions, a grid of 16 x 16 on each side of a cube, as in
// PhysX. 1536 to 6144 bytes per table from 32 vertices on.
#pragma once

#include <string_view>

#include "edgewise/layout_parts/seeds.hpp"
#include "edgewise/layouts/lean.hpp"

namespace edgewise {

template <Precision P, class Loader = Direct>
class lean_seeds1536
    : public TableWithSeeds<Seeded<PlainPoints<typename P::Stored>, GridDirections<16>>, P, Loader> {
    using Base = TableWithSeeds<Seeded<PlainPoints<typename P::Stored>, GridDirections<16>>, P, Loader>;

  public:
    static constexpr std::string_view name = "lean_seeds1536";
    static constexpr std::string_view stores =
        "vertex coordinates, neighbour rings of 8, 16 or 32 bits, and the farthest vertices in 1536 directions";

    using Base::Base;
};

}  // namespace edgewise
