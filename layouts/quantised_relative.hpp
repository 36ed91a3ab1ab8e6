// SPDX-License-Identifier: MIT
//
// The table of `lean_relative` with vertex coordinates of 16 bits on the body's own grid, as in `quantised`:
// 4.7 bytes per edge. The body is that of `quantised` in another order.
#pragma once

#include <string_view>

#include "edgewise/layout_parts/relative_table.hpp"
#include "edgewise/layouts/quantised.hpp"

namespace edgewise {

template <Precision P, class Loader = Direct>
class quantised_relative : public RelativeTable<GridPoints<typename P::Compute>, P, Loader> {
    using Base = RelativeTable<GridPoints<typename P::Compute>, P, Loader>;

  public:
    static constexpr std::string_view name = "quantised_relative";
    static constexpr std::string_view stores =
        "vertex coordinates of 16 bits on the body's grid, and neighbours as differences of 8 bits";

    /// The body as the table holds it, except for the order of its vertices.
    [[nodiscard]] static Result<Polyhedron> stored_body(const Polyhedron& body) {
        return round_to_grid(body, GridPoints<typename P::Compute>::eps);
    }

    using Base::Base;
};

}  // namespace edgewise
