// SPDX-License-Identifier: MIT
#include "edgewise/probes/bytes.hpp"

#include <map>
#include <utility>

#include "edgewise/scene/shapes.hpp"

namespace edgewise::probes {

namespace {

std::vector<Polyhedron> growing_spheres() {
    std::vector<Polyhedron> bodies;
    for (const char* name :
         {"sphere8", "sphere18", "sphere38", "sphere66", "sphere102", "sphere218", "sphere386", "sphere1538"})
        bodies.push_back(scene::make_shape(name).or_throw());
    return bodies;
}

}  // namespace

std::span<const TableBytes> size_family(const bench::TableType& type, Parts parts) {
    static const std::vector<Polyhedron> bodies = growing_spheres();
    static std::map<std::pair<std::string, Parts>, std::vector<TableBytes>> known;
    auto [place, is_new] = known.try_emplace({type.name, parts});
    if (is_new) {
        for (const Polyhedron& body : bodies) {
            const auto stored = type.stored_body(body);
            if (!stored) continue;  // too large for the layout
            place->second.push_back(
                {stored->vertex_count(), stored->edge_count(), type.ledger(*stored, parts)});
        }
    }
    return place->second;
}

}  // namespace edgewise::probes
