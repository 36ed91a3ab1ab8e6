// SPDX-License-Identifier: MIT
//
// The table of `lean_seeds` with seeds in 114 directions, on seven rings of latitude and at two poles: the
// number of SWIFT's smaller look-up table. 114 to 456 bytes per table from 32 vertices on.
#pragma once

#include <string_view>

#include "edgewise/layout_parts/seeds.hpp"
#include "edgewise/layouts/lean.hpp"

namespace edgewise {

template <Precision P, class Loader = Direct>
class lean_seeds114
    : public TableWithSeeds<Seeded<PlainPoints<typename P::Stored>, RingDirections<7>>, P, Loader> {
    using Base = TableWithSeeds<Seeded<PlainPoints<typename P::Stored>, RingDirections<7>>, P, Loader>;

  public:
    static constexpr std::string_view name = "lean_seeds114";
    static constexpr std::string_view stores =
        "vertex coordinates, neighbour rings of 8, 16 or 32 bits, and the farthest vertices in 114 directions";

    using Base::Base;
};

}  // namespace edgewise
