// SPDX-License-Identifier: MIT
#include "edgewise/studies/campaign/pair_source.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "edgewise/geometry/hull.hpp"
#include "edgewise/scene/mesh/mesh_file.hpp"
#include "edgewise/studies/campaign/poses.hpp"
#include "edgewise/truth/exact_body.hpp"

namespace edgewise::studies::campaign {

namespace {

constexpr const char* random_family = "random";
constexpr const char* real_family = "real_hulls_at_gaps";  // needs meshes, which others may not have

/// Returns the shape itself in every second block; else the shape stretched by factors of 24 bits, so that
/// single precision has to round the body.
std::vector<Vec3d> stretched(const Polyhedron& shape, scene::Rng& rng, bool stretches) {
    std::vector<Vec3d> points = shape.vertices;
    if (!stretches) return points;
    Vec3d factor;
    for (double& f : factor) f = std::ldexp(std::floor(std::ldexp(rng.uniform(0.25, 1.5), 24)), -24);
    for (Vec3d& v : points) v = v.cwiseProduct(factor);
    return points;
}

void set_bodies(Block& block) {
    const auto a = scene::body_from_case(block.case_a);
    const auto b = scene::body_from_case(block.case_b);
    if (!a || !b) {
        block.refusal = a ? b.error : a.error;
        return;
    }
    block.a = *a;
    block.b = *b;
}

/// Returns what is wrong with the poses: they must be finite, and extreme numbers are not always.
std::string wrong_poses(const Block& block, const std::vector<std::pair<Pose, Pose>>& made) {
    for (const auto& [pose_a, pose_b] : made) {
        std::string error = truth::pair_error(block.a.vertices, pose_a, block.b.vertices, pose_b);
        if (!error.empty()) return error;
    }
    return {};
}

}  // namespace

std::vector<std::string> campaign_families() {
    std::vector<std::string> names = {random_family};
    for (const scene::HardFamily& family : scene::hard_families())
        if (family.name != real_family) names.push_back(family.name);
    return names;
}

PairSource::PairSource(std::uint64_t seed, const std::vector<std::string>& families,
                       const std::vector<std::string>& shapes)
    : seed_(seed) {
    for (const std::string& family : families.empty() ? campaign_families() : families) add(family, shapes);
    if (names_.empty()) throw std::invalid_argument("no family of pairs: name a body with --shape");
}

void PairSource::add(const std::string& family, const std::vector<std::string>& shapes) {
    const std::vector<std::string> known = campaign_families();
    if (std::ranges::find(known, family) == known.end())
        throw std::invalid_argument(
            fmt::format("unknown family '{}'; known: {}", family, fmt::join(known, ", ")));
    if (family != random_family) {
        hard_[family] = &*std::ranges::find(scene::hard_families(), family, &scene::HardFamily::name);
        names_.push_back(family);
        return;
    }
    for (const std::string& shape : shapes) {
        const std::string name = std::string(random_family) + " " + shape;
        if (!shapes_.emplace(name, scene::named_shape(shape).or_throw().body).second)
            throw std::invalid_argument(fmt::format("shape '{}' is given twice: leave one out", shape));
        names_.push_back(name);
    }
}

Block PairSource::block(std::uint64_t number, std::uint64_t count) const {
    const std::uint64_t own = number / names_.size();
    Block block;
    block.family = names_[number % names_.size()];
    const std::uint64_t seed = child_seed(child_seed(seed_, number % names_.size()), own);
    if (const auto shape = shapes_.find(block.family); shape != shapes_.end()) {
        scene::Rng rng(seed);
        block.case_a = {"a", stretched(shape->second, rng, own % 4 == 3), {}};
        block.case_b = {"b", stretched(shape->second, rng, own % 2 == 1), {}};
        set_bodies(block);
        if (block.refusal.empty()) block.poses = random_poses(block.a, block.b, seed, count);
        return block;
    }
    scene::hard::Maker maker(seed, own % 2 == 1, {});
    scene::hard::Pair made = hard_.at(block.family)->make(maker);
    block.case_a = std::move(made.a);
    block.case_b = std::move(made.b);
    set_bodies(block);
    if (block.refusal.empty()) block.refusal = wrong_poses(block, made.poses);
    if (block.refusal.empty()) block.poses = near_poses(block.a, block.b, made.poses, seed, count);
    return block;
}

}  // namespace edgewise::studies::campaign
