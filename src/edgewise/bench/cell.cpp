// SPDX-License-Identifier: MIT
#include "edgewise/bench/cell.hpp"

#include <fmt/format.h>

#include <bit>
#include <nlohmann/json.hpp>

#include "edgewise/bench/registry.hpp"

namespace edgewise::bench {

Fingerprint& Fingerprint::add(std::string_view text) {
    for (const char c : text) state_ = (state_ ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    return add(std::uint64_t{text.size()});  // so that "ab","c" is not "a","bc"
}

Fingerprint& Fingerprint::add(std::uint64_t number) {
    for (int byte = 0; byte < 8; ++byte) state_ = (state_ ^ (number >> 8 * byte & 0xff)) * 0x100000001b3;
    return *this;
}

Fingerprint& Fingerprint::add(double number) { return add(std::bit_cast<std::uint64_t>(number)); }

Fingerprint& Fingerprint::add(const Polyhedron& body) {
    for (const Vec3d& v : body.vertices) add(v.x()).add(v.y()).add(v.z());
    for (const HalfEdge h : body.face_ring) add(std::uint64_t{h});
    return *this;
}

std::string Fingerprint::hex() const { return fmt::format("{:016x}", state_); }

std::string parameters_json(const scene::SceneParameters& parameters) {
    return nlohmann::json(parameters).dump();
}

void describe_cell(store::CellRow& cell, const TableType& type, const Polyhedron& body) {
    cell.layout = type.layout;
    cell.precision = type.precision;
    cell.table = type.name;
    cell.vertices = static_cast<std::int64_t>(body.vertex_count());
    cell.edges = static_cast<std::int64_t>(body.edge_count());
    cell.faces = static_cast<std::int64_t>(body.face_count());
}

void name_cell(store::CellRow& cell, const Polyhedron& body) {
    Fingerprint print;
    print.add(cell.scene)
        .add(cell.scene_parameters)
        .add(cell.shape)
        .add(cell.algorithm)
        .add(cell.table)
        .add(cell.axes);
    if (!cell.scene_kind.empty()) print.add(cell.scene_kind);
    if (cell.run != store::sweep_run) print.add(cell.run);
    cell.hash = print.add(cell.seed).add(static_cast<std::uint64_t>(cell.queries)).add(body).hex();
}

}  // namespace edgewise::bench
