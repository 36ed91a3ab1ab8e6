// SPDX-License-Identifier: MIT
#include "edgewise/sweep/cell_run.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "edgewise/bench/cell.hpp"

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

CellRun::CellRun(const bench::TableType& type, const std::string& algorithm, const Axes& axes,
                 store::CellRow row, const Polyhedron& body)
    : cell_(type, algorithm, axes), axes_(axes), row_(std::move(row)) {
    row_.axes = axes.text();
    row_.algorithm = algorithm;
    row_.layout = type.layout;
    row_.precision = type.precision;
    row_.table = type.name;
    bench::name_cell(row_, body);
}

void CellRun::make_unavailable(const std::string& reason) {
    row_.status = store::CellStatus::unavailable;
    row_.reason = reason;
}

void CellRun::verify(SharedQueries& shared) {
    const scene::Workload& workload = axes_.starts_cold ? shared.cold_workload() : shared.workload();
    if (cell_.type().is_peer && axes_.needs == Needs::nearer) {
        make_unavailable("other libraries are not asked whether bodies are nearer than a margin");
        return;
    }
    if (const std::string error = cell_.load(workload); !error.empty()) {
        make_unavailable(error);
        return;
    }
    shared_ = &shared;
    row_.queries = workload.queries.size();  // more than the plan's number if the scene needs more steps
    cell_.check(shared);
    row_.reason = cell_.wrong();
    // A peer's errors, and those of V-Clip as published, are figures; they are no failure of this program.
    row_.status = cell_.type().is_peer || !axes_.query.hardened ? store::CellStatus::judged
                  : row_.reason.empty()                         ? store::CellStatus::verified
                                                                : store::CellStatus::failed;
}

void CellRun::measure(Stage stage, std::span<const measure::Round> rounds) {
    if (!shared_) return;
    const bench::ProbedCell cell{.type = cell_.type(),
                                 .algorithm = bench::algorithm_called(row_.algorithm),
                                 .runner = cell_.runner(),
                                 .workload = cell_.workload(),
                                 .plain = row_.axes.empty(),
                                 .needs = axes_.needs,
                                 .verified = verified(),
                                 .checked_positions = shared_->checked(),
                                 .checked = cell_.checked(),
                                 .counts = cell_.counts(),
                                 .rounds = rounds,
                                 .caches = caches_};
    for (const bench::Probe& probe : bench::registered_probes()) {
        if (probe.beside_others != (stage == Stage::beside_others)) continue;
        if (cell_.type().is_peer && !probe.of_peers) continue;
        if (!only_.empty() && std::ranges::find(only_, probe.name) == only_.end()) continue;
        bench::Findings found = probe.measure(cell);
        if (found.passed) hold_against_answers(*found.passed, probe.name);
        for (measure::Figure& figure : found.figures)
            figures_.push_back({std::move(figure), std::string(probe.name)});
    }
}

std::string CellRun::heat_on_body() const {
    const bench::Runner& runner = cell_.runner();
    const bool of_one_body = row_.scene_kind != scene::recorded_kind;
    const bool traced = !caches_.machines.empty() && runner.table_allocator().base() && of_one_body;
    if (!verified() || !shared_ || !row_.axes.empty() || !traced || !shows_heat(cell_.type(), row_.vertices))
        return {};
    bench::FeatureHeat heat(runner.memory_maps());
    static_cast<void>(runner.trace(caches_.queries > 0 ? bench::TraceExtent(caches_.queries, caches_.steps)
                                                       : bench::TraceExtent::everything(),
                                   heat));
    return heat_json(heat);
}

void CellRun::hold_against_answers(const bench::PassSum& sum, std::string_view probe) {
    const double expected = cell_.distances(sum.queries);
    if (sum.queries > 0 && expected == sum.distances) return;
    row_.status = store::CellStatus::failed;
    row_.reason = fmt::format("the pass of probe {} gave other answers: distances add up to {}, not {}",
                              probe, sum.distances, expected);
}

}  // namespace edgewise::sweep
