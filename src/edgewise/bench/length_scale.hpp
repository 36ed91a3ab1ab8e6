// SPDX-License-Identifier: MIT
//
// The unit a runner computes in. Algorithms multiply up to four coordinates, which single precision holds
// only around 1; so bodies that are far from it are scaled by an exact power of two, poses with them, and
// answers back. Near 1 nothing is scaled: arithmetic without absolute tolerances gives the same bits either
// way.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "edgewise/algorithms/query_options.hpp"
#include "edgewise/bench/named_answer.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/scene/workload.hpp"

namespace edgewise::bench {

/// Binary places around 1 within which bodies are taken as they are.
inline constexpr int places_as_given = 10;

/// Most that is scaled by: the bodies that hulls accept come within 2^10 of 1, and offsets stay in range
/// together with points of denormal coordinates.
inline constexpr int most_places = 190;

class LengthScale {
  public:
    LengthScale() = default;
    /// Chooses the scale from the largest coordinate of the bodies.
    explicit LengthScale(std::span<const Polyhedron> bodies) {
        double largest = 0;
        for (const Polyhedron& body : bodies) {
            for (const Vec3d& v : body.vertices) largest = std::max(largest, max_abs(v));
        }
        if (!(largest > 0) || !std::isfinite(largest)) return;
        const int exponent = std::clamp(std::ilogb(largest), -most_places, most_places);
        if (std::abs(exponent) > places_as_given) factor_ = std::ldexp(1.0, -exponent);
        reach_ = largest * factor_;
    }

    [[nodiscard]] bool is_one() const { return factor_ == 1; }

    /// The largest coordinate of the bodies, in the unit.
    [[nodiscard]] double reach() const { return reach_; }

    /// Into the unit, and back.
    [[nodiscard]] Vec3d into(const Vec3d& v) const { return v * factor_; }
    [[nodiscard]] Vec3d back(const Vec3d& v) const { return v / factor_; }
    [[nodiscard]] double into(double length) const { return length * factor_; }
    [[nodiscard]] double back(double length) const { return length / factor_; }
    [[nodiscard]] Polyhedron into(const Polyhedron& body) const {
        return is_one() ? body : scene::scaled(body, factor_);
    }
    [[nodiscard]] Polyhedron back(const Polyhedron& body) const {
        return is_one() ? body : scene::scaled(body, 1 / factor_);
    }
    [[nodiscard]] scene::Query into(scene::Query query) const {
        query.pose_a.translation *= factor_;
        query.pose_b.translation *= factor_;
        return query;
    }
    [[nodiscard]] QueryOptions into(QueryOptions options) const {
        options.contact_tolerance *= factor_;
        options.cutoff *= factor_;
        return options;
    }
    [[nodiscard]] Distance back(Distance answer) const {
        answer.distance /= factor_;
        answer.point_a /= factor_;
        answer.point_b /= factor_;
        return answer;
    }
    [[nodiscard]] PassSum back(PassSum sum) const {
        sum.distances /= factor_;
        return sum;
    }
    [[nodiscard]] NamedAnswer back(NamedAnswer answer) const {
        answer.distance = back(answer.distance);
        answer.depth /= factor_;
        return answer;
    }

  private:
    double factor_ = 1, reach_ = 0;
};

}  // namespace edgewise::bench
