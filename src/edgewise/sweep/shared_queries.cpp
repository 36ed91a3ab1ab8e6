// SPDX-License-Identifier: MIT
#include "edgewise/sweep/shared_queries.hpp"

#include <algorithm>
#include <cmath>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/bench/cell.hpp"
#include "edgewise/bench/parallel.hpp"
#include "edgewise/scene/answer_claim.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/table/canonical.hpp"
#include "edgewise/truth/moore_wilhelms.hpp"

namespace edgewise::sweep {

namespace {

/// Good enough to place pairs by; what is placed is then checked exactly like everything else.
double placing_distance(const Polyhedron& a, const Pose& pose_a, const Polyhedron& b, const Pose& pose_b) {
    SimplexPair<Canonical, Canonical> cold;
    return Gjk::query(Canonical(a), Canonical(b), relative_pose(pose_a, pose_b), cold).distance;
}

/// The control holds every vertex and edge against every face: seconds per pair of the largest bodies. All
/// checked queries up to some 400 vertices, then as many as take as long.
std::size_t control_stride(const Polyhedron& body, std::size_t checked) {
    constexpr double most_work = 2000.0 * 386 * 768;  // vertices x faces
    const double work = static_cast<double>(checked) * static_cast<double>(body.vertex_count()) *
                        static_cast<double>(body.face_count());
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(work / most_work)));
}

std::string print_of(std::span<const Polyhedron> bodies) {
    bench::Fingerprint print;
    for (const Polyhedron& body : bodies) print.add(body);
    return print.hex();
}

}  // namespace

SharedQueries::SharedQueries(const Plan& plan, const SceneChoice& scene, const scene::NamedShape& shape)
    : asks_control_(plan.control) {
    const auto parameters = scene::complete_parameters(scene.name, scene.parameters).or_throw();
    workload_ =
        scene::make_scene(scene.name, shape.body, parameters, plan.seed, plan.queries, placing_distance)
            .or_throw();
    const std::size_t wanted = std::min(plan.checked, workload_.queries.size());
    for (std::size_t k = 0; k < wanted; ++k) checked_.push_back(k * workload_.queries.size() / wanted);
}

std::vector<truth::KnownPair>& SharedQueries::known(std::span<const Polyhedron> bodies) {
    auto [place, is_new] = known_.try_emplace(print_of(bodies));
    std::vector<truth::KnownPair>& pairs = place->second;
    if (!is_new) return pairs;
    pairs.resize(checked_.size());
    bench::for_each_index(checked_.size(), [&](std::size_t k) {
        pairs[k].exact(scene::placed(bodies, workload_.queries[checked_[k]]));
    });
    return pairs;
}

const scene::Workload& SharedQueries::cold_workload() {
    if (!workload_.warm) return workload_;
    if (!cold_workload_) {
        cold_workload_ = workload_;
        cold_workload_->warm = false;
    }
    return *cold_workload_;
}

const std::vector<std::optional<bool>>& SharedQueries::control(std::span<const Polyhedron> bodies) {
    auto [place, is_new] = control_.try_emplace(print_of(bodies));
    if (!is_new || !asks_control_) return place->second;
    std::vector<std::optional<bool>>& says = place->second;
    says.resize(checked_.size());
    const std::size_t stride = control_stride(bodies.front(), checked_.size());
    bench::for_each_index((checked_.size() + stride - 1) / stride, [&](std::size_t nth) {
        const std::size_t k = nth * stride;
        const scene::Query& query = workload_.queries[checked_[k]];
        says[k] = truth::moore_wilhelms(bodies[query.body_a], bodies[query.body_b],
                                        relative_pose(query.pose_a, query.pose_b));
    });
    return says;
}

}  // namespace edgewise::sweep
