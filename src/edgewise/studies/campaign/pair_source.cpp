// SPDX-License-Identifier: MIT
#include "edgewise/studies/campaign/pair_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "edgewise/bench/cell.hpp"
#include "edgewise/geometry/message.hpp"
#include "edgewise/geometry/split_mix.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/input/known_names.hpp"
#include "edgewise/input/shown_text.hpp"
#include "edgewise/scene/motion.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/truth/exact_body.hpp"
#include "edgewise/truth/filter/float_proof.hpp"

namespace edgewise::studies::campaign {

namespace {

/// Seeds of a campaign's generators: of a block from the campaign's seed, of a pair from its block's. Returns
/// child `number` of a seed; children of neighbouring numbers are unrelated.
std::uint64_t child_seed(std::uint64_t seed, std::uint64_t number) {
    std::uint64_t state = seed ^ (number * 0xd1342543de82ef95);
    const std::uint64_t first = split_mix(state);
    return first ^ split_mix(state);
}

/// The shortest connection of two posed bodies as double computes it; poses are moved along it.
struct Separation {
    double distance = 0;
    Vec3d towards_b;  ///< unit, in the world
};

/// Returns nothing for bodies in contact, or for numbers that double cannot represent.
std::optional<Separation> separation_of(truth::ScannedBody& a, truth::ScannedBody& b,
                                        const std::pair<Pose, Pose>& poses) {
    const double as_good_as_it_gets = Tolerance<double>::eps * (a.extent() + b.extent());
    const truth::FloatProof proof =
        truth::prove_distance(a, poses.first, b, poses.second, Vec3d::Zero(), as_good_as_it_gets);
    const double distance = norm(proof.separation);
    if (!(proof.lower > 0 && distance > 0)) return std::nullopt;
    return Separation{distance, Vec3d(proof.separation / -distance)};
}

/// Poses that share what costs most to find: where the bodies are nearest.
constexpr std::uint64_t group = 64;

enum class Relation { generic, nearly_parallel, parallel, lattice };

/// Returns a rotation that rounds nothing.
Mat3d quarter_turns(scene::Rng& rng) {
    Mat3d turn = Mat3d::Zero();
    const auto first = static_cast<int>(rng.below(3));
    for (int row = 0; row < 3; ++row) turn(row, (row + first) % 3) = 1;
    if (rng.below(2) == 0) turn.topRows(2) *= -1;
    return turn;
}

/// Returns a number from 2^-high to 2^-low, each octave with equal probability.
double power(scene::Rng& rng, int low, int high) {
    const auto exponent = low + static_cast<int>(rng.below(static_cast<std::uint64_t>(high - low)));
    return std::ldexp(rng.uniform(0.5, 1), -exponent);
}

/// Random poses of two bodies in the regimes that matter: free poses, and groups of poses that share their
/// orientation, or nearly. Gaps and depths range from three sizes to 2^-36 of one. Of ten groups, two are
/// nearly parallel, one is parallel, one is on a lattice.
class RandomPoses {
  public:
    RandomPoses(const Polyhedron& a, const Polyhedron& b, std::uint64_t seed)
        : a_(a.vertices), b_(b.vertices), seed_(seed), size_(std::max(a_.extent(), b_.extent())) {}

    std::pair<Pose, Pose> pose(std::uint64_t number) {
        scene::Rng rng(child_seed(seed_, number));
        if (number % group == 0) start_group(rng, number / group);
        if (relation_ == Relation::lattice) return on_lattice(rng);
        return rng.below(4) == 0 ? free(rng) : at_gap(rng);
    }

  private:
    void start_group(scene::Rng& rng, std::uint64_t group_number) {
        const std::uint64_t turn = group_number % 10;
        relation_ = turn < 6   ? Relation::generic
                    : turn < 8 ? Relation::nearly_parallel
                    : turn < 9 ? Relation::parallel
                               : Relation::lattice;
        of_a_ = rng.orientation();
        of_b_ = relation_ == Relation::generic ? rng.orientation() : of_a_;
        base_.first = {scene::rotation_matrix(of_a_), rng.in_cube(4)};
        base_.second = {scene::rotation_matrix(of_b_), base_.first.translation};
        towards_b_ = rng.on_sphere();
        // Far apart, closest points are nearly always vertices; at small gaps, edges and faces too.
        const bool starts_far = group_number % 3 == 0;
        const double offset = starts_far ? 4 * size_ : reach_along(towards_b_) + size_ / 50;
        base_.second.translation += towards_b_ * offset;
        const auto found = separation_of(a_, b_, base_);
        distance_ = found ? found->distance : 0;
        if (found) towards_b_ = found->towards_b;
    }

    /// Returns how far both bodies together reach along a direction.
    double reach_along(const Vec3d& direction) {
        const Vec3d in_a = multiply_transposed(base_.first.rotation, direction);
        const Vec3d in_b = multiply_transposed(base_.second.rotation, direction);
        return a_.highest(in_a).height + b_.highest(-in_b).height;
    }

    std::pair<Pose, Pose> free(scene::Rng& rng) {
        std::pair<Pose, Pose> poses = base_;
        poses.second.rotation = rng.rotation();
        poses.second.translation = poses.first.translation + rng.in_ball() * (1.5 * size_);
        return poses;
    }

    std::pair<Pose, Pose> on_lattice(scene::Rng& rng) {
        std::pair<Pose, Pose> poses;
        poses.first.rotation = quarter_turns(rng);
        poses.second.rotation = quarter_turns(rng);
        const Vec3d steps = rng.in_cube(9.5).array().round();
        poses.second.translation = steps * (std::max(a_.reach(), b_.reach()) / 4);
        return poses;
    }

    std::pair<Pose, Pose> at_gap(scene::Rng& rng) {
        std::pair<Pose, Pose> poses = base_;
        const bool tilts = relation_ == Relation::nearly_parallel || rng.below(2) == 0;
        if (tilts && relation_ != Relation::parallel) {
            const scene::Quaternion tilt = scene::rotation_about(rng.on_sphere(), power(rng, 2, 54));
            poses.second.rotation = scene::rotation_matrix(normalised(tilt * of_b_));
        }
        poses.second.translation += towards_b_ * (wanted_gap(rng) - distance_);
        return poses;
    }

    double wanted_gap(scene::Rng& rng) const {
        const auto kind = rng.below(8);
        if (kind == 0) return size_ * rng.uniform(0.1, 3);
        if (kind <= 2) return size_ * power(rng, 3, 10);
        if (kind <= 4) return size_ * power(rng, 10, 36);
        if (kind == 5) return -size_ * rng.uniform(0, 0.2);
        return -size_ * (kind == 6 ? power(rng, 3, 10) : power(rng, 10, 36));
    }

    truth::ScannedBody a_, b_;
    std::uint64_t seed_;
    double size_, distance_ = 0;
    Relation relation_ = Relation::generic;
    scene::Quaternion of_a_, of_b_;
    std::pair<Pose, Pose> base_;
    Vec3d towards_b_;
};

using scene::hard::Maker;

/// Poses near those that a hard family made: hard cases come in neighbourhoods, and the next one may be a
/// rounding step away from the known case.
class NearPoses {
  public:
    NearPoses(const Polyhedron& a, const Polyhedron& b, const std::vector<std::pair<Pose, Pose>>& made,
              std::uint64_t seed)
        : a_(a.vertices),
          b_(b.vertices),
          made_(made),
          known_(made.size()),
          seed_(seed),
          size_(std::min(a_.extent(), b_.extent())) {
        if (!(size_ > 0)) size_ = std::max(a_.extent(), b_.extent());
        if (!(size_ > 0)) size_ = 1;
    }

    std::pair<Pose, Pose> pose(std::uint64_t number) {
        const std::size_t of = number % made_.size();
        std::pair<Pose, Pose> poses = made_[of];
        if (number < made_.size()) return poses;
        Maker maker(child_seed(seed_, number), false, {});
        const auto how = maker.rng.below(8);
        if (how < 4) move_to_gap(maker, of, poses.second);
        if (how == 3 || how == 4)
            poses.second.translation += maker.rng.on_sphere() * (size_ * maker.spread(-54, -2));
        if (how == 5 || how == 6) tilt(maker, poses.second);
        if (how >= 6) carry_off(maker, poses);
        return poses;
    }

  private:
    struct Known {
        bool is_asked = false;
        std::optional<Separation> separation;
    };

    const std::optional<Separation>& separation(std::size_t of) {
        Known& known = known_[of];
        if (!known.is_asked) known = {true, separation_of(a_, b_, made_[of])};
        return known.separation;
    }

    /// Moves B along the shortest connection; if the bodies touch, out by as little in some direction.
    void move_to_gap(Maker& maker, std::size_t of, Pose& pose_b) {
        const double gap = maker.either_sign(size_ * maker.spread(-54, 0));
        const auto& found = separation(of);
        if (found)
            pose_b.translation += found->towards_b * (gap - found->distance);
        else
            pose_b.translation += maker.rng.on_sphere() * gap;
    }

    /// Tilts B about a coordinate axis or about any axis.
    static void tilt(Maker& maker, Pose& pose_b) {
        const double angle = maker.either_sign(maker.spread(-54, -3));
        const Vec3d axis = maker.rng.below(2) == 0
                               ? Vec3d(Vec3d::Unit(static_cast<Eigen::Index>(maker.rng.below(3))))
                               : maker.rng.on_sphere();
        pose_b.rotation = multiply(Maker::turn(axis, angle), pose_b.rotation);
    }

    /// Turns the whole scene by a quarter turn, which rounds nothing, and moves it away, which may round.
    void carry_off(Maker& maker, std::pair<Pose, Pose>& poses) const {
        const Mat3d turn = maker.quarter_turn();
        const Vec3d shift =
            maker.rng.below(2) == 0 ? Vec3d(Vec3d::Zero()) : Vec3d(maker.rng.in_cube(4) * size_);
        for (Pose* pose : {&poses.first, &poses.second}) {
            pose->rotation = multiply(turn, pose->rotation);
            pose->translation = multiply(turn, pose->translation) + shift;
        }
    }

    truth::ScannedBody a_, b_;
    const std::vector<std::pair<Pose, Pose>>& made_;
    std::vector<Known> known_;
    std::uint64_t seed_;
    double size_;
};

/// Returns the first `count` poses of a block.
template <class Poses>
std::vector<std::pair<Pose, Pose>> first_poses(Poses maker, std::uint64_t count) {
    std::vector<std::pair<Pose, Pose>> poses;
    poses.reserve(count);
    for (std::uint64_t i = 0; i < count; ++i) poses.push_back(maker.pose(i));
    return poses;
}

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

/// Returns "random" and the hard families that need no meshes.
std::vector<std::string> campaign_families() {
    std::vector<std::string> names = {random_family};
    for (const scene::HardFamily& family : scene::hard_families())
        if (family.name != real_family) names.push_back(family.name);
    return names;
}

}  // namespace

PairSource::PairSource(std::uint64_t seed, const std::vector<std::string>& families,
                       const std::vector<std::string>& shapes, const scene::MeshReading& reading)
    : seed_(seed) {
    for (const std::string& family : families.empty() ? campaign_families() : families)
        add(family, shapes, reading);
    if (names_.empty()) throw std::invalid_argument("no family of pairs: name a body with --shape");
}

std::string PairSource::print() const {
    bench::Fingerprint print;
    for (const auto& [name, body] : shapes_) print.add(body);
    return print.hex();
}

void PairSource::add(const std::string& family, const std::vector<std::string>& shapes,
                     const scene::MeshReading& reading) {
    const std::vector<std::string> known = campaign_families();
    if (std::ranges::find(known, family) == known.end())
        throw std::invalid_argument(unknown_name("family", family, known));
    if (family != random_family) {
        hard_[family] = &*std::ranges::find(scene::hard_families(), family, &scene::HardFamily::name);
        names_.push_back(family);
        return;
    }
    for (const std::string& shape : shapes) {
        const std::string name = std::string(random_family) + " " + input::valid_utf8(shape);
        auto read = scene::named_shape(shape, reading);
        add_warning(warning_, read.warning);
        if (!shapes_.emplace(name, std::move(read).or_throw().body).second)
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
        if (block.refusal.empty()) block.poses = first_poses(RandomPoses(block.a, block.b, seed), count);
        return block;
    }
    scene::hard::Maker maker(seed, own % 2 == 1, {});
    scene::hard::Pair made = hard_.at(block.family)->make(maker);
    block.case_a = std::move(made.a);
    block.case_b = std::move(made.b);
    set_bodies(block);
    if (block.refusal.empty()) block.refusal = wrong_poses(block, made.poses);
    if (block.refusal.empty())
        block.poses = first_poses(NearPoses(block.a, block.b, made.poses, seed), count);
    return block;
}

}  // namespace edgewise::studies::campaign
