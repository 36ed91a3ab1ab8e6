// SPDX-License-Identifier: MIT
#include "edgewise/probes/bytes.hpp"

#include <map>
#include <stdexcept>
#include <utility>

#include "edgewise/scene/shapes.hpp"

namespace edgewise::probes {

TableBytes table_bytes(const Ledger& ledger, const Polyhedron& body) {
    TableBytes result;
    result.vertices = body.vertex_count();
    result.edges = body.edge_count();
    for (std::size_t i = 0; i < component_names.size(); ++i) {
        result.components.push_back({std::string(component_names[i]), static_cast<double>(ledger.bytes[i])});
    }
    result.paper_subtotal = static_cast<double>(ledger.paper_subtotal());
    result.total = static_cast<double>(ledger.total());
    return result;
}

namespace {

std::vector<Polyhedron> growing_spheres() {
    std::vector<Polyhedron> bodies;
    for (const char* name : {"sphere8", "sphere18", "sphere38", "sphere66", "sphere102", "sphere218",
                             "sphere386", "sphere1538"}) {
        auto body = scene::make_shape(name);
        if (!body) throw std::logic_error(body.error);
        bodies.push_back(std::move(*body));
    }
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
            if (!stored) throw std::logic_error(stored.error);
            place->second.push_back(table_bytes(type.ledger(*stored, parts), *stored));
        }
    }
    return place->second;
}

}  // namespace edgewise::probes
