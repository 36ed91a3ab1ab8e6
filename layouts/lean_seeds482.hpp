// SPDX-License-Identifier: MIT
//
// The table of `lean_seeds` with seeds in 482 directions, on fifteen rings of latitude and at two poles: the
// number of SWIFT's middle look-up table. 482 to 1928 bytes per table from 32 vertices on.
#pragma once

#include <string_view>

#include "edgewise/layout_parts/seeds.hpp"
#include "edgewise/layouts/lean.hpp"

namespace edgewise {

template <Precision P, class Loader = Direct>
class lean_seeds482
    : public TableWithSeeds<Seeded<PlainPoints<typename P::Stored>, RingDirections<15>>, P, Loader> {
    using Base = TableWithSeeds<Seeded<PlainPoints<typename P::Stored>, RingDirections<15>>, P, Loader>;

  public:
    static constexpr std::string_view name = "lean_seeds482";
    static constexpr std::string_view stores =
        "vertex coordinates, neighbour rings of 8, 16 or 32 bits, and the farthest vertices in 482 directions";

    using Base::Base;
};

}  // namespace edgewise
