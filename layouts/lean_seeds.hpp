// SPDX-License-Identifier: MIT
//
// The table of `lean` with seeds: the farthest vertices in a set of directions, where cold queries and
// queries after a large turn begin (layout_parts/seeds.hpp). A seed takes 1, 2 or 4 bytes; there are none
// below 32 vertices.
//
//     lean_seeds       26 directions (27 seeds): the axes, edges and corners of a cube; MuJoCo keeps 27, too,
//                      with each mesh (layouts/mujoco.hpp)
//     lean_seeds114    seven rings of latitude and two poles: the number of SWIFT's smaller look-up table
//     lean_seeds482    fifteen rings and two poles: that of SWIFT's middle table
//     lean_seeds1536   a grid of 16 x 16 on each side of a cube, as in PhysX
#pragma once

#include <string_view>

#include "edgewise/layout_parts/seeds.hpp"
#include "edgewise/layouts/lean.hpp"

namespace edgewise {

/// The set of this number of directions, and how its layout is named and described.
template <int number>
struct SeedSet;
template <>
struct SeedSet<26> : CornerDirections {
    static constexpr std::string_view name = "lean_seeds";
    static constexpr std::string_view stores =
        "vertex coordinates, neighbour rings of 8, 16 or 32 bits, and the farthest vertices in 26 directions";
};
template <>
struct SeedSet<114> : RingDirections<7> {
    static constexpr std::string_view name = "lean_seeds114";
    static constexpr std::string_view stores =
        "vertex coordinates, neighbour rings of 8, 16 or 32 bits, and the farthest vertices in 114 directions";
};
template <>
struct SeedSet<482> : RingDirections<15> {
    static constexpr std::string_view name = "lean_seeds482";
    static constexpr std::string_view stores =
        "vertex coordinates, neighbour rings of 8, 16 or 32 bits, and the farthest vertices in 482 directions";
};
template <>
struct SeedSet<1536> : GridDirections<16> {
    static constexpr std::string_view name = "lean_seeds1536";
    static constexpr std::string_view stores =
        "vertex coordinates, neighbour rings of 8, 16 or 32 bits, and the farthest vertices in 1536 directions";
};

template <Precision P, class Loader, int number>
class LeanWithSeeds
    : public TableWithSeeds<Seeded<PlainPoints<typename P::Stored>, SeedSet<number>>, P, Loader> {
    using Base = TableWithSeeds<Seeded<PlainPoints<typename P::Stored>, SeedSet<number>>, P, Loader>;

  public:
    static constexpr std::string_view name = SeedSet<number>::name;
    static constexpr std::string_view stores = SeedSet<number>::stores;

    using Base::Base;
};

template <Precision P, class Loader = Direct>
using lean_seeds = LeanWithSeeds<P, Loader, 26>;
template <Precision P, class Loader = Direct>
using lean_seeds114 = LeanWithSeeds<P, Loader, 114>;
template <Precision P, class Loader = Direct>
using lean_seeds482 = LeanWithSeeds<P, Loader, 482>;
template <Precision P, class Loader = Direct>
using lean_seeds1536 = LeanWithSeeds<P, Loader, 1536>;

}  // namespace edgewise
