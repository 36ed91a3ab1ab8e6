// SPDX-License-Identifier: MIT
//
// A minimal table for GJK and V-Clip: rings of vertex indices, as narrow as the body allows, and vertex
// coordinates. Every plane is computed when it is asked for. At 386 vertices 12.8 bytes per edge in double
// and 8.8 in single, topology included, where the paper's record takes 168 and 84 without it.
#pragma once

#include <cstddef>
#include <string_view>

#include "edgewise/layout_parts/derived/derived_table.hpp"

namespace edgewise {

/// Vertex coordinates as plain vectors.
template <class Stored>
struct PlainPoints {
    using Point = Vec3<Stored>;

    static void place(BlockPlan& plan, const BodyFacts& n) {
        plan.array_at<Point>(n.vertex_count, {{Component::vertex_coordinates, sizeof(Point)}});
    }
    static void write(std::byte* base, const Polyhedron& body) {
        auto* const points = reinterpret_cast<Point*>(base);
        for (Index v = 0; v < body.vertex_count(); ++v) points[v] = cast<Stored>(body.vertices[v]);
    }
    template <class Loader>
    [[nodiscard]] static const Point& read(const Loader& loader, const std::byte* base, Index v) {
        return loader.load(reinterpret_cast<const Point*>(base)[v], Field::vertex);
    }
};

template <Precision P, class Loader = Direct>
class lean : public DerivedTable<PlainPoints<typename P::Stored>, P, Loader> {
    using Base = DerivedTable<PlainPoints<typename P::Stored>, P, Loader>;

  public:
    static constexpr std::string_view name = "lean";
    static constexpr std::string_view stores = "vertex coordinates and neighbour rings of 8, 16 or 32 bits";
    static constexpr bool measured_at_scales = true;

    using Base::Base;
};

}  // namespace edgewise
