// SPDX-License-Identifier: MIT
//
// The least that still answers: rings of vertex indices, as narrow as the body allows, and vertex
// coordinates. Every plane is computed when it is asked for. At 386 vertices 12.8 bytes per edge in double
// and 8.8 in single, topology included, where the paper's record takes 168 and 84 without it.
#pragma once

#include <string_view>

#include "edgewise/layout_parts/derived_table.hpp"

namespace edgewise {

/// Coordinates as plain vectors.
template <class Stored>
struct PlainPoints {
    Vec3<Stored>* points = nullptr;

    void place(BlockPlan& plan, const BodyFacts& n) {
        plan.array(points, n.vertex_count, {{Component::vertex_coordinates, sizeof(Vec3<Stored>)}});
    }
    void write(const Polyhedron& body) {
        for (Index v = 0; v < body.vertex_count(); ++v) points[v] = cast<Stored>(body.vertices[v]);
    }
    template <class Loader>
    [[nodiscard]] const Vec3<Stored>& read(const Loader& loader, Index v) const {
        return loader.load(points[v], Field::vertex);
    }
};

template <Precision P, class Loader = Direct>
class lean : public DerivedTable<PlainPoints<typename P::Stored>, P, Loader> {
    using Base = DerivedTable<PlainPoints<typename P::Stored>, P, Loader>;

  public:
    static constexpr std::string_view name = "lean";
    static constexpr std::string_view stores = "vertex coordinates and neighbour rings of 8, 16 or 32 bits";

    using Base::Base;
};

}  // namespace edgewise
