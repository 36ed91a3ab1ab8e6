// SPDX-License-Identifier: MIT
//
// The table of `quantised`, but the stored body contains the given one: it grows about its middle, by no more
// than is needed, before it is rounded. For users to whom a missed contact is worse than an early one: bodies
// that this table calls separated are separated. That holds for solids: a flat body is rounded to the
// nearest places.
#pragma once

#include <string_view>

#include "edgewise/layouts/quantised.hpp"

namespace edgewise {

template <Precision P, class Loader = Direct>
class quantised_outward : public DerivedTable<GridPoints<typename P::Compute>, P, Loader> {
    using Base = DerivedTable<GridPoints<typename P::Compute>, P, Loader>;

  public:
    static constexpr std::string_view name = "quantised_outward";
    static constexpr std::string_view stores =
        "as quantised, of a body grown until it contains the given one";

    /// The body as the table holds it: the only kind of body that it may be built from.
    [[nodiscard]] static Result<Polyhedron> stored_body(const Polyhedron& body) {
        return round_to_grid_outward(body, GridPoints<typename P::Compute>::eps);
    }

    using Base::Base;
};

}  // namespace edgewise
