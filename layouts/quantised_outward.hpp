// SPDX-License-Identifier: MIT
//
// As `quantised`, but the stored body contains the given one: grown about its middle, by no more than is
// needed, before it is rounded. For those to whom a missed contact is worse than an early one: what this
// table calls apart is apart. That holds for solids: a flat body stays flat, rounded to the nearest places.
#pragma once

#include "edgewise/layout_parts/grid_table.hpp"

namespace edgewise {

template <Precision P, class Loader = Direct>
class quantised_outward : public GridTable<quantised_outward<P, Loader>, P, Loader> {
    using Base = GridTable<quantised_outward, P, Loader>;

  public:
    static constexpr std::string_view name = "quantised_outward";
    static constexpr std::string_view stores =
        "as quantised, of a body grown until it contains the given one";
    static constexpr std::string_view derives = "edges, faces and every plane";

    /// What the table holds of a body.
    [[nodiscard]] static Result<Polyhedron> stored_body(const Polyhedron& body) {
        return round_to_grid_outward(body, Base::grid_eps);
    }

    /// The body must be a stored_body.
    quantised_outward(const Polyhedron& body, Parts parts, Loader loader = {}) : Base(body, parts, loader) {}

    /// The same memory seen through another loader.
    template <class OtherLoader>
    quantised_outward(const quantised_outward<P, OtherLoader>& other, Loader loader) : Base(other, loader) {}
};

}  // namespace edgewise
