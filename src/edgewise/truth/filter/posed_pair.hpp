// SPDX-License-Identifier: MIT
//
// Two scanned bodies in the world, in double, with bounds of how wrong that is. Everything is relative to A's
// origin: the translations are subtracted first.
//
// Bounds, in units of u = 2^-53 (proof_rounding has a margin for terms of second order and for underflow).
// r: reach of a body; f: Frobenius norm of its rotation, which bounds the norm of |R|^T |n|; s: a bound of
// |R v| / |v|; t = t_B - t_A, rounded by 1u.
//   Height along n of a vertex: R^T n is off by 3u f |n|, its product with v by 3u |R^T n| |v|.
//   Height of t: 3u from the products and 1u from t itself, times |n| |t|.
//   A point of A - B: R v is off by 3u f r for either body; the two differences by u times what they give,
//   below s (r_A + r_B) and that plus |t|; t by u |t|.
#pragma once

#include "edgewise/geometry/pose.hpp"
#include "edgewise/truth/filter/scanned_body.hpp"
#include "edgewise/truth/minimum_norm.hpp"

namespace edgewise::truth {

/// The largest relative error of an operation in double: the unit of rounding, half of
/// Tolerance<double>::eps, with a margin of 1/128 for terms of second order and for underflow.
inline constexpr double proof_rounding = 0x1.02p-53;

/// The lowest point of A - B along a direction, and a height that none of its points is below.
struct ScannedLowest {
    VertexPair pair;
    Vec3d point;
    double least_height = 0;            ///< rounded downward
    double height_a = 0, height_b = 0;  ///< as scanned: A's along -direction, B's along direction
    double error_a = 0, error_b = 0;    ///< bounds of how far these are from the truth
};

class PosedPair {
  public:
    /// Keeps references.
    PosedPair(ScannedBody& a, const Pose& pose_a, ScannedBody& b, const Pose& pose_b);

    /// False where the bounds would not hold: lengths too long or short for products of eight of them.
    [[nodiscard]] bool is_usable() const { return usable_; }

    /// Along a direction about 1 long.
    [[nodiscard]] ScannedLowest lowest(const Vec3d& direction);

    /// x_A - x_B in the world; no component is off by more, nor is the vector, than point_error().
    [[nodiscard]] Vec3d difference(VertexPair pair) const {
        return difference(turned_a(pair.a), turned_b(pair.b));
    }
    /// x_A - x_B from vertices that were turned before, with the same bits.
    [[nodiscard]] Vec3d difference(const Vec3d& turned_a, const Vec3d& turned_b) const {
        return (turned_a - turned_b) - offset_;
    }
    [[nodiscard]] Vec3d turned_a(std::uint32_t i) const { return multiply(pose_a_.rotation, a_.vertex(i)); }
    [[nodiscard]] Vec3d turned_b(std::uint32_t i) const { return multiply(pose_b_.rotation, b_.vertex(i)); }
    [[nodiscard]] double point_error() const { return point_error_; }

    /// t_B - t_A, rounded.
    [[nodiscard]] const Vec3d& offset() const { return offset_; }
    /// A bound of every |x_A - x_B|.
    [[nodiscard]] double span() const { return span_; }
    /// How far the larger of the two rotations is from orthogonal.
    [[nodiscard]] double ortho() const { return ortho_; }

    [[nodiscard]] ScannedBody& a() { return a_; }
    [[nodiscard]] ScannedBody& b() { return b_; }
    [[nodiscard]] const ScannedBody& a() const { return a_; }
    [[nodiscard]] const ScannedBody& b() const { return b_; }
    [[nodiscard]] const Pose& pose_a() const { return pose_a_; }
    [[nodiscard]] const Pose& pose_b() const { return pose_b_; }

  private:
    ScannedBody& a_;
    ScannedBody& b_;
    const Pose& pose_a_;
    const Pose& pose_b_;
    Vec3d offset_;
    double stretch_a_ = 0, stretch_b_ = 0;  ///< Frobenius norms
    double offset_length_ = 0, ortho_ = 0, span_ = 0, point_error_ = 0;
    bool usable_ = false;
};

}  // namespace edgewise::truth
