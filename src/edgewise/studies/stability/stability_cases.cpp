// SPDX-License-Identifier: MIT
#include "edgewise/studies/stability/stability_cases.hpp"

#include "edgewise/truth/exact_body.hpp"
#include "edgewise/truth/moore_wilhelms.hpp"

namespace edgewise::studies {

namespace {

bool same_bodies(const scene::hard::Pair& p, const scene::hard::Pair& q) {
    return p.a.vertices == q.a.vertices && p.b.vertices == q.b.vertices && p.a.faces == q.a.faces &&
           p.b.faces == q.b.faces;
}

}  // namespace

StabilityCases::StabilityCases(const scene::HardFamily& family, std::size_t count, std::uint64_t seed,
                               bool single, std::span<const Polyhedron> real) {
    scene::hard::Maker maker(seed, single, real);
    scene::hard::Pair last;
    for (std::size_t poses = 0; poses < count;) {
        scene::hard::Pair pair = family.make(maker);
        poses += pair.poses.size();
        if (!family.warm && !cases_.empty() && same_bodies(pair, last)) {
            auto& known = cases_.back().poses;
            known.insert(known.end(), pair.poses.begin(), pair.poses.end());
            truths_.back().resize(known.size());
            continue;
        }
        auto a = scene::body_from_case(pair.a);
        auto b = scene::body_from_case(pair.b);
        std::string error = !a ? a.error : !b ? b.error : "";
        for (const auto& [pose_a, pose_b] : pair.poses) {
            if (error.empty()) error = truth::pair_error(a->vertices, pose_a, b->vertices, pose_b);
        }
        if (error.empty()) {
            truths_.emplace_back(pair.poses.size());
            cases_.push_back({std::move(*a), std::move(*b), pair.poses});
            last = std::move(pair);
        } else {
            refused_ += pair.poses.size();
            if (first_refusal_.empty()) first_refusal_ = error;
        }
    }
}

std::optional<bool> StabilityCases::control(StabilityPose at, std::span<const Polyhedron> stored) {
    std::optional<std::optional<bool>>& known = truth_of(at).control;
    const auto& [pose_a, pose_b] = poses_of(at);
    if (!known) known = truth::moore_wilhelms(stored[0], stored[1], relative_pose(pose_a, pose_b));
    return *known;
}

}  // namespace edgewise::studies
