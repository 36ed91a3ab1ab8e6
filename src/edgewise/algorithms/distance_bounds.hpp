// SPDX-License-Identifier: MIT
//
// Bounds of the distance of a moving pair. They need neither body: they are proven at one pose, and hold at
// another for the distance by which body B can have moved since. No point of B moves farther than its
// translation and, of a turn, the Frobenius norm of R - R0 times its distance from B's origin; the distance
// changes by no more than that (Mirtich, "Impulse-based Dynamic Simulation", 1996, bounds times of impact in
// this way). It holds for any two matrices: for two exact rotations a root of two less would do, for
// rotations in single it would not. Most pairs of a scene are far from each other or well within a margin:
// they are answered in some nanoseconds, and no line of a table is read.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

#include "edgewise/geometry/pose.hpp"

namespace edgewise {

/// The distance is in [least, most]. All lengths in the bodies' unit.
struct DistanceInterval {
    double least = 0;
    double most = std::numeric_limits<double>::infinity();
};

/// Bounds of one pair's distance at one pose; from these follow bounds at any other pose, and whether the
/// bodies are nearer than a given distance there, where the bounds decide it.
class DistanceBounds {
  public:
    /// Bounds of a pair about which nothing is known.
    DistanceBounds() = default;

    /// Bounds known at this pose of B in A's frame; `radius_b`: radius of B about its own origin (radius_of).
    DistanceBounds(const DistanceInterval& known, const Transform<double>& a_from_b, double radius_b)
        : known_(known), at_(a_from_b), squared_radius_(radius_b * radius_b) {
        assert(known.least <= known.most && radius_b >= 0);
    }

    /// Bounds at another pose.
    [[nodiscard]] DistanceInterval at(const Transform<double>& a_from_b) const {
        const double moved = motion_to(a_from_b).most();
        return {std::max(0.0, known_.least - moved), known_.most + moved};
    }

    /// Returns true if the bodies are nearer than `distance`; nothing where the bounds do not decide.
    [[nodiscard]] std::optional<bool> nearer_than(double distance, const Transform<double>& a_from_b) const {
        if (distance <= 0) return false;
        const double above = known_.least - distance, below = distance - known_.most;
        const Motion motion = motion_to(a_from_b);
        const double room = std::max(above, below);
        if (!(room > 0) || !motion.is_within(room)) return std::nullopt;
        return below > 0;
    }

  private:
    /// Squared bounds: no point of B has moved farther than the sum of their roots.
    struct Motion {
        double squared_shift, squared_turn;

        [[nodiscard]] double most() const {
            return (std::sqrt(squared_shift) + std::sqrt(squared_turn)) * rounding;
        }
        /// Computes roots only where the mean of the squares, which is no less than the squared mean, does
        /// not decide.
        [[nodiscard]] bool is_within(double room) const {
            const double left = (2 - rounding) * room;
            return 2 * (squared_shift + squared_turn) < left * left || most() <= room;
        }
    };

    /// Differences of given numbers have only their own relative error.
    static constexpr double rounding = 1 + 16 * std::numeric_limits<double>::epsilon();

    [[nodiscard]] Motion motion_to(const Transform<double>& to) const {
        double turned = 0;
        // Component by component: whole Eigen vectors would go through memory, and sum in packets.
        for (int i = 0; i < 3; ++i) turned += squared_norm(to.rotation.col(i) - at_.rotation.col(i));
        return {squared_norm(to.translation - at_.translation), turned * squared_radius_};
    }

    DistanceInterval known_;
    Transform<double> at_{Mat3d::Identity(), Vec3d::Zero()};
    double squared_radius_ = 0;
};

}  // namespace edgewise
