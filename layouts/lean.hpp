// SPDX-License-Identifier: MIT
//
// The least that still answers: rings of vertex indices, as narrow as the body allows, and vertex
// coordinates. Every plane is worked out when it is asked for. At 386 vertices 12.8 bytes an edge in double
// and 8.8 in single, topology included, where the paper's record takes 168 and 84 without it.
#pragma once

#include "edgewise/layout_parts/derived_table.hpp"

namespace edgewise {

template <Precision P, class Loader = Direct>
class lean : public DerivedTable<lean<P, Loader>, P, Loader> {
    using Base = DerivedTable<lean, P, Loader>;

  public:
    using typename Base::Compute;
    using typename Base::Stored;
    using typename Base::Vertex;

    static constexpr std::string_view name = "lean";
    static constexpr std::string_view stores = "vertex coordinates and neighbour rings of 8, 16 or 32 bits";
    static constexpr std::string_view derives = "edges, faces and every plane";

    lean(const Polyhedron& body, Parts parts, Loader loader = {}) : Base(loader) {
        vertices_ = this->template build<Vec3<Stored>>(body, parts);
        write_geometry(*this, body);
    }

    /// The same memory seen through another loader.
    template <class OtherLoader>
    lean(const lean<P, OtherLoader>& other, Loader loader)
        : Base(other, loader), vertices_(other.vertices_) {}

    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const {
        return cast<Compute>(this->loader_.load(vertices_[v], Field::vertex));
    }

    void write_vertex(Index v, const Vec3d& point) { vertices_[v] = cast<Stored>(point); }

  private:
    template <Precision, class>
    friend class lean;

    Vec3<Stored>* vertices_ = nullptr;
};

}  // namespace edgewise
