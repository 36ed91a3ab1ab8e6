// SPDX-License-Identifier: MIT
#include "edgewise/sweep/table_bytes.hpp"

#include <stdexcept>

#include "edgewise/scene/shapes.hpp"

namespace edgewise::sweep {

measure::TableBytes table_bytes(const Ledger& ledger, const Polyhedron& body) {
    measure::TableBytes result;
    result.vertices = body.vertex_count();
    result.edges = body.edge_count();
    for (std::size_t i = 0; i < component_names.size(); ++i) {
        result.components.push_back({std::string(component_names[i]), static_cast<double>(ledger.bytes[i])});
    }
    result.paper_subtotal = static_cast<double>(ledger.paper_subtotal());
    result.total = static_cast<double>(ledger.total());
    return result;
}

SizeFamily::SizeFamily() {
    for (const char* name : {"sphere8", "sphere18", "sphere38", "sphere66", "sphere102", "sphere218",
                             "sphere386", "sphere1538"}) {
        auto body = scene::make_shape(name);
        if (!body) throw std::logic_error(body.error);
        bodies_.push_back(std::move(*body));
    }
}

const std::vector<measure::TableBytes>& SizeFamily::of(const bench::TableType& type, Parts parts) {
    auto [place, is_new] = known_.try_emplace({type.name, parts});
    if (is_new) {
        for (const Polyhedron& body : bodies_) {
            const auto stored = type.stored_body(body);
            if (!stored) throw std::logic_error(stored.error);
            place->second.push_back(table_bytes(type.ledger(*stored, parts), *stored));
        }
    }
    return place->second;
}

}  // namespace edgewise::sweep
