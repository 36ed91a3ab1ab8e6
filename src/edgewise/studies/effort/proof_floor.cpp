// SPDX-License-Identifier: MIT
#include "edgewise/studies/effort/proof_floor.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/table/canonical.hpp"

namespace edgewise::studies {

namespace {

constexpr double line_bytes = 64;
constexpr double dot_flops = 5, turn_flops = 15, offset_flops = 7;
constexpr int contact_vertices = 5;
constexpr double contact_flops = 3 * (2 * contact_vertices - 2) + 18;

double lines_of(double bytes) { return std::ceil(bytes / line_bytes); }

/// Returns the fewest lines over all ways to divide the five between the bodies, at least one each.
double contact_lines(double vertex_bytes) {
    double fewest = lines_of(contact_vertices * vertex_bytes) + 1;
    for (int of_a = 1; of_a < contact_vertices; ++of_a)
        fewest = std::min(fewest,
                          lines_of(of_a * vertex_bytes) + lines_of((contact_vertices - of_a) * vertex_bytes));
    return fewest;
}

ProofFloor separated_floor(const Polyhedron& a, const Polyhedron& b, const Vec3d& normal,
                           const Transform<double>& a_from_b, const ProofReads& reads) {
    const auto of_a = static_cast<double>(proof_vertices(a, normal, reads.knows_neighbours));
    const auto of_b = static_cast<double>(
        proof_vertices(b, a_from_b.direction_back(Vec3d(-normal)), reads.knows_neighbours));
    return {of_a + of_b, dot_flops * (of_a + of_b) + turn_flops + offset_flops,
            lines_of(of_a * reads.vertex_bytes) + lines_of(of_b * reads.vertex_bytes)};
}

ProofFloor query_floor(const Polyhedron& a, const Polyhedron& b, const scene::Query& query,
                       const ProofReads& reads) {
    const Transform<double> a_from_b = relative_pose(query.pose_a, query.pose_b);
    SimplexPair<Canonical, Canonical> cold;
    const Distance answer = Gjk::query(Canonical(a), Canonical(b), a_from_b, cold);
    if (answer.status == Status::separated) return separated_floor(a, b, answer.normal, a_from_b, reads);
    return {contact_vertices, contact_flops, contact_lines(reads.vertex_bytes)};
}

}  // namespace

std::size_t proof_vertices(const Polyhedron& body, const Vec3d& direction, bool knows_neighbours) {
    const std::size_t count = body.vertex_count();
    if (!knows_neighbours) return count;
    std::vector<double> heights;
    double reach = 0;
    for (const Vec3d& v : body.vertices) {
        heights.push_back(dot(v, direction));
        reach = std::max(reach, max_abs(v));
    }
    const double level = Tolerance<double>::level * reach * max_abs(direction);
    const double top = *std::max_element(heights.begin(), heights.end());
    std::size_t fewest = count;
    for (Index v = 0; v < count; ++v)
        if (heights[v] >= top - level) fewest = std::min(fewest, 1 + body.ring_of_vertex(v).size());
    return fewest;
}

measure::Expected<ProofFloor> proof_floor(const scene::Workload& workload, std::span<const Polyhedron> bodies,
                                          const ProofReads& reads) {
    if (workload.queries.empty()) return measure::Refusal{"there are no queries"};
    ProofFloor sum;
    for (const scene::Query& query : workload.queries) {
        const ProofFloor one = query_floor(bodies[query.body_a], bodies[query.body_b], query, reads);
        sum.vertices += one.vertices;
        sum.flops += one.flops;
        sum.lines += one.lines;
    }
    const auto queries = static_cast<double>(workload.queries.size());
    return {ProofFloor{sum.vertices / queries, sum.flops / queries, sum.lines / queries}};
}

}  // namespace edgewise::studies
