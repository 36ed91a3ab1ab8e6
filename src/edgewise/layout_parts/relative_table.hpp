// SPDX-License-Identifier: MIT
//
// A table that derives all features, as DerivedTable does, with vertices numbered so that neighbours are one
// byte away (relative_rings.hpp). It holds a body in another order as well, in more bytes.
#pragma once

#include "edgewise/geometry/vertex_order.hpp"
#include "edgewise/layout_parts/derived/derived_table.hpp"
#include "edgewise/layout_parts/input_order.hpp"
#include "edgewise/layout_parts/relative_rings.hpp"

namespace edgewise {

template <class Points, Precision P, class Loader>
class RelativeTable : public DerivedTable<WithInputOrder<Points>, P, Loader, RelativeRingPlaces> {
    using Base = DerivedTable<WithInputOrder<Points>, P, Loader, RelativeRingPlaces>;

  public:
    using typename Base::Vertex;

    /// Order of the bodies that tables are built from (table/stored_body.hpp).
    static constexpr VertexOrder vertex_order = VertexOrder::rcm;

    RelativeTable(const Polyhedron& body, Parts parts, Loader loader = {},
                  InputOrder wanted = InputOrder::left_out)
        : Base(body, parts, loader, WithInputOrder<Points>(body, wanted)) {}
    template <class OtherLoader>
    RelativeTable(const RelativeTable<Points, P, OtherLoader>& other, Loader loader) : Base(other, loader) {}

    [[nodiscard]] bool keeps_input_order() const { return this->points_.keeps_input_order(); }
    /// Index of the vertex in the user's list, for a table that keeps it.
    [[nodiscard]] Index input_index(Vertex v) const {
        return this->points_.input_index(this->loader_, this->block_.base(), v);
    }
};

}  // namespace edgewise
