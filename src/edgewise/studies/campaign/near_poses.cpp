// SPDX-License-Identifier: MIT
#include "edgewise/studies/campaign/near_poses.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "edgewise/scene/hard/families.hpp"
#include "edgewise/studies/campaign/block_seed.hpp"
#include "edgewise/studies/campaign/separation.hpp"

namespace edgewise::studies::campaign {

namespace {

using scene::hard::Maker;

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

}  // namespace

std::vector<std::pair<Pose, Pose>> near_poses(const Polyhedron& a, const Polyhedron& b,
                                              const std::vector<std::pair<Pose, Pose>>& made,
                                              std::uint64_t seed, std::uint64_t count) {
    NearPoses maker(a, b, made, seed);
    std::vector<std::pair<Pose, Pose>> poses;
    poses.reserve(count);
    for (std::uint64_t i = 0; i < count; ++i) poses.push_back(maker.pose(i));
    return poses;
}

}  // namespace edgewise::studies::campaign
