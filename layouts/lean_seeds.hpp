// SPDX-License-Identifier: MIT
//
// As `lean`, with seeds: the farthest vertices in 26 directions, where cold queries and those after a large
// turn begin (layout_parts/seeds.hpp). 27 to 108 bytes per table from 32 vertices on.
#pragma once

#include <cassert>
#include <string_view>

#include "edgewise/layout_parts/seeds.hpp"
#include "edgewise/layouts/lean.hpp"

namespace edgewise {

template <Precision P, class Loader = Direct>
class lean_seeds : public DerivedTable<Seeded<PlainPoints<typename P::Stored>>, P, Loader> {
    using Base = DerivedTable<Seeded<PlainPoints<typename P::Stored>>, P, Loader>;

  public:
    static constexpr std::string_view name = "lean_seeds";
    static constexpr std::string_view stores =
        "vertex coordinates, neighbour rings of 8, 16 or 32 bits, and the farthest vertices in 26 directions";

    using Base::Base;

    /// Among the vertices far along the direction, of any length; not of bodies of less than 32.
    [[nodiscard]] typename Base::Vertex seed(const Vec3<typename Base::Compute>& direction) const {
        assert(this->vertex_count() >= seeds_from);
        return this->points_.seed(this->loader_, this->block_.base(), direction);
    }
};

}  // namespace edgewise
