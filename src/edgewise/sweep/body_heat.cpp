// SPDX-License-Identifier: MIT
#include "edgewise/sweep/body_heat.hpp"

#include <nlohmann/json.hpp>

namespace edgewise::sweep {

std::string body_json(const Polyhedron& body) {
    nlohmann::json vertices = nlohmann::json::array(), edges = nlohmann::json::array(),
                   faces = nlohmann::json::array();
    for (const Vec3d& vertex : body.vertices)
        for (int axis = 0; axis < 3; ++axis) vertices.push_back(vertex[axis]);
    for (const PolyhedronEdge& edge : body.edges) edges.push_back(edge.tail), edges.push_back(edge.head);
    for (Index f = 0; f < body.face_count(); ++f) {
        nlohmann::json face = nlohmann::json::array();
        for (const HalfEdge h : body.ring_of_face(f)) face.push_back(body.tail(h));
        faces.push_back(std::move(face));
    }
    return nlohmann::json{{"vertices", vertices}, {"edges", edges}, {"faces", faces}}.dump();
}

std::string heat_json(const bench::FeatureHeat& heat) {
    const auto reads = [&](FeatureKind kind) {
        const auto& counts = heat.reads(kind);
        return counts ? nlohmann::json(*counts) : nlohmann::json();
    };
    return nlohmann::json{{"queries", heat.queries()},
                          {"vertices", reads(FeatureKind::vertex)},
                          {"edges", reads(FeatureKind::edge)},
                          {"faces", reads(FeatureKind::face)}}
        .dump();
}

bool shows_heat(const bench::TableType& type, std::int64_t vertices) {
    constexpr std::int64_t most_vertices = 2000;
    return !type.is_peer && type.precision == "f64" && !type.input_order_bytes && vertices <= most_vertices;
}

}  // namespace edgewise::sweep
