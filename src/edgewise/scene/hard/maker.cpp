// SPDX-License-Identifier: MIT
#include "edgewise/scene/hard/families.hpp"

#include <cmath>
#include <numbers>

#include "edgewise/scene/angle.hpp"
#include "edgewise/scene/kinds/scene_setup.hpp"
#include "edgewise/scene/motion.hpp"
#include "edgewise/truth/exact_distance.hpp"

namespace edgewise::scene::hard {

namespace {

double far_off(const CaseBody& a, const CaseBody& b) {
    return 1.5 * (reach(a.vertices, Vec3d::Zero()) + reach(b.vertices, Vec3d::Zero()));
}

}  // namespace

double Maker::spread(int low, int high) {
    const auto octaves = static_cast<std::uint64_t>(high - low + 1);
    return std::ldexp(1 + rng.uniform(), low + static_cast<int>(rng.below(octaves)));
}

Mat3d Maker::quarter_turn() {
    int axis[3] = {0, 1, 2};
    for (std::uint64_t i = 2; i > 0; --i) std::swap(axis[i], axis[rng.below(i + 1)]);
    const bool odd = (axis[1] + 3 - axis[0]) % 3 == 2;  // an odd permutation mirrors, unless signs do too
    double sign[3];
    for (double& s : sign) s = rng.below(2) == 0 ? 1 : -1;
    sign[2] = (odd ? -1 : 1) * sign[0] * sign[1];
    Mat3d result = Mat3d::Zero();
    for (int i = 0; i < 3; ++i) result(i, axis[i]) = sign[i];
    return result;
}

Mat3d Maker::turn(const Vec3d& axis, double angle) {
    return rotation_matrix(rotation_about(Vec3d(axis / norm(axis)), angle));
}

Mat3d Maker::common_rotation() {
    const auto kind = rng.below(3);
    if (kind == 0) return Mat3d::Identity();
    if (kind == 2) return rng.rotation();
    return turn(Vec3d(Vec3d::Unit(static_cast<Eigen::Index>(rng.below(3)))), std::numbers::pi / 4);
}

std::vector<Vec3d> Maker::box(double x, double y, double z) {
    std::vector<Vec3d> points;
    for (int i = 0; i < 8; ++i) points.push_back({i & 1 ? x : -x, i & 2 ? y : -y, i & 4 ? z : -z});
    return points;
}

std::vector<Vec3d> Maker::prism(int corners, double half_height) {
    std::vector<Vec3d> points;
    for (int i = 0; i < corners; ++i) {
        const SineCosine at = sine_cosine(2 * std::numbers::pi * i / corners);
        points.push_back({at.cosine, at.sine, half_height});
        points.push_back({at.cosine, at.sine, -half_height});
    }
    return points;
}

std::vector<Vec3d> Maker::octahedron() {
    return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
}

std::vector<Vec3d> Maker::icosahedron() {
    const double golden = (1 + std::sqrt(5.0)) / 2;
    std::vector<Vec3d> points;
    for (int i = 0; i < 4; ++i) {
        const double one = i & 1 ? 1 : -1, long_side = i & 2 ? golden : -golden;
        points.push_back({0, one, long_side});
        points.push_back({one, long_side, 0});
        points.push_back({long_side, 0, one});
    }
    return points;
}

std::vector<Vec3d> Maker::random_points(std::size_t count, const Vec3d& half) {
    std::vector<Vec3d> points;
    for (std::size_t i = 0; i < count; ++i) points.push_back(rng.on_sphere().cwiseProduct(half));
    return points;
}

std::vector<Vec3d> Maker::any_solid() {
    const auto kind = rng.below(3);
    if (kind == 0) return box(rng.uniform(0.2, 1), rng.uniform(0.2, 1), rng.uniform(0.2, 1));
    if (kind == 1) return prism(3 + static_cast<int>(rng.below(10)), rng.uniform(0.2, 1));
    return random_points(4 + rng.below(29), Vec3d(1, 1, 1));
}

void set_gap(const CaseBody& a, const Pose& pose_a, const CaseBody& b, Pose& pose_b, const Vec3d& away,
             double gap) {
    auto exact = truth::exact_distance(a.vertices, pose_a, b.vertices, pose_b);
    if (exact->distance == 0) {
        pose_b.translation = pose_a.translation + away * far_off(a, b);
        exact = truth::exact_distance(a.vertices, pose_a, b.vertices, pose_b);
    }
    if (exact->distance == 0) return;
    const Vec3d towards_a = exact->separation / norm(exact->separation);
    pose_b.translation += towards_a * (exact->distance - gap);
}

Pair at_gap(Maker& maker, CaseBody a, CaseBody b, const Mat3d& rotation_a, const Mat3d& rotation_b,
            double gap) {
    Pose pose_a{rotation_a, Vec3d::Zero()}, pose_b{rotation_b, Vec3d::Zero()};
    const Vec3d away = maker.rng.on_sphere();
    pose_b.translation = away * far_off(a, b);
    set_gap(a, pose_a, b, pose_b, away, gap);
    return {std::move(a), std::move(b), {{pose_a, pose_b}}};
}

}  // namespace edgewise::scene::hard
