// SPDX-License-Identifier: MIT
#include "edgewise/sweep/group.hpp"

#include <stdexcept>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/sweep/cell.hpp"
#include "edgewise/table/canonical.hpp"

namespace edgewise {

namespace {

/// Good enough to place pairs by; what is placed is then checked exactly like everything else.
double placing_distance(const Polyhedron& a, const Pose& pose_a, const Polyhedron& b, const Pose& pose_b) {
    SimplexPair<Canonical, Canonical> cold;
    return Gjk::query(Canonical(a), Canonical(b), relative_pose(pose_a, pose_b), cold).distance;
}

}  // namespace

Group::Group(const Plan& plan, const SceneChoice& scene, const NamedShape& shape) {
    auto parameters = complete_parameters(scene.name, scene.parameters);
    if (!parameters) throw std::invalid_argument(parameters.error);
    parameters_ = std::move(*parameters);
    auto workload =
        make_scene(scene.name, shape.body, parameters_, plan.seed, plan.queries, placing_distance);
    if (!workload) throw std::invalid_argument(workload.error);
    workload_ = std::move(*workload);
    const std::size_t wanted = std::min(plan.checked, workload_.queries.size());
    for (std::size_t k = 0; k < wanted; ++k) checked_.push_back(k * workload_.queries.size() / wanted);
}

const std::vector<ExactDistance>& Group::exact(std::span<const Polyhedron> bodies) {
    Fingerprint print;
    for (const Polyhedron& body : bodies) print.add(body);
    auto [place, is_new] = exact_.try_emplace(print.hex());
    if (!is_new) return place->second;
    for (const std::size_t i : checked_) {
        const Query& query = workload_.queries[i];
        const auto answer = exact_distance(bodies[query.body_a].vertices, query.pose_a,
                                           bodies[query.body_b].vertices, query.pose_b);
        if (!answer) throw std::logic_error(answer.error);
        place->second.push_back(*answer);
    }
    return place->second;
}

}  // namespace edgewise
