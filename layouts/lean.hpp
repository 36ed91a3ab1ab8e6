// SPDX-License-Identifier: MIT
//
// The least that still answers: rings of vertex indices, as narrow as the body allows, and vertex
// coordinates. Every plane is worked out when it is asked for. At 386 vertices 12.8 bytes an edge in double
// and 8.8 in single, topology included, where the paper's record takes 168 and 84 without it.
#pragma once

#include "edgewise/table/derived_table.hpp"

namespace edgewise {

template <Precision P, class Loader = Direct>
class lean : public DerivedTable<lean<P, Loader>, P, Loader> {
    using Base = DerivedTable<lean, P, Loader>;
    using Base::block_;

  public:
    using typename Base::Compute;
    using typename Base::Stored;
    using typename Base::Vertex;

    static constexpr std::string_view name = "lean";
    static constexpr std::string_view stores = "vertex coordinates and neighbour rings of 8, 16 or 32 bits";
    static constexpr std::string_view derives = "edges, faces and every plane";

    lean(const Polyhedron& body, Parts parts, Loader loader = {}) : Base(loader) {
        BlockPlan plan;
        const auto vertices = plan.array<Vec3<Stored>>(
            body.vertex_count(), {{Component::vertex_coordinates, sizeof(Vec3<Stored>)}});
        this->rings_ = NarrowRings(plan, body);
        block_ = Block(plan);
        this->facts_ = BodyFacts(body, parts, Tolerance<Compute>::strict_turn);
        vertices_ = block_.fill(vertices, [&](Index v) { return cast<Stored>(body.vertices[v]); });
        this->rings_.fill(block_, body);
    }

    /// The same memory seen through another loader.
    template <class OtherLoader>
    lean(const lean<P, OtherLoader>& other, Loader loader)
        : Base(other, loader), vertices_(other.vertices_) {}

    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const {
        return cast<Compute>(this->loader_.load(vertices_[v], Field::vertex));
    }

  private:
    template <Precision, class>
    friend class lean;

    const Vec3<Stored>* vertices_ = nullptr;
};

}  // namespace edgewise
