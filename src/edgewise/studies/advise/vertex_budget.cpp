// SPDX-License-Identifier: MIT
#include "edgewise/studies/advise/vertex_budget.hpp"

#include <algorithm>
#include <queue>
#include <span>

#include "edgewise/bench/parallel.hpp"
#include "edgewise/truth/exact_distance.hpp"

namespace edgewise::studies::advise {

namespace {

double distance_from_hull(const Vec3d& point, std::span<const Vec3d> subset) {
    return truth::exact_distance(std::span(&point, 1), {}, subset, {}).or_throw().distance;
}

/// Vertices in the order in which the farthest is added, with the distance that each had then.
class FarthestFirst {
  public:
    explicit FarthestFirst(std::vector<Vec3d> points) : points_(std::move(points)) {
        const auto [low, high] =
            std::ranges::minmax_element(points_, {}, [](const Vec3d& v) { return v.x(); });
        chosen_ = {*low, *high};
        for (const Vec3d& point : points_) {
            if (point != *low && point != *high) bounds_.push({distance_from_hull(point, chosen_), point});
        }
    }

    /// Adds the farthest; false where none is left outside. Distances only shrink as points are added, so an
    /// old one is an upper bound, and the top of the queue is the farthest once it is a new one.
    bool add() {
        std::size_t fresh_at_top = 0;
        while (!bounds_.empty()) {
            Bound top = bounds_.top();
            if (top.distance == 0) return false;
            bounds_.pop();
            if (top.of == chosen_.size() || fresh_at_top > points_.size()) {
                chosen_.push_back(top.point);
                return true;
            }
            top.distance = distance_from_hull(top.point, chosen_);
            top.of = chosen_.size();
            ++fresh_at_top;
            bounds_.push(top);
        }
        return false;
    }

    [[nodiscard]] const std::vector<Vec3d>& chosen() const { return chosen_; }

  private:
    struct Bound {
        double distance;
        Vec3d point;
        std::size_t of = 2;  ///< how many were chosen when it was computed
        bool operator<(const Bound& other) const { return distance < other.distance; }
    };

    std::vector<Vec3d> points_, chosen_;
    std::priority_queue<Bound> bounds_;
};

/// Whether every point lies within the tolerance of the subset's hull.
bool holds(const std::vector<Vec3d>& points, const std::vector<Vec3d>& subset, double tolerance) {
    return std::ranges::all_of(
        points, [&](const Vec3d& point) { return distance_from_hull(point, subset) <= tolerance; });
}

}  // namespace

double worst_error_of(const std::vector<Vec3d>& points, const std::vector<Vec3d>& subset) {
    std::vector<double> distances(points.size());
    bench::for_each_index(points.size(),
                          [&](std::size_t i) { distances[i] = distance_from_hull(points[i], subset); });
    return distances.empty() ? 0 : *std::ranges::max_element(distances);
}

std::vector<SmallerBody> smaller_bodies(const Polyhedron& body, const std::vector<std::size_t>& counts) {
    FarthestFirst order(body.vertices);
    std::vector<SmallerBody> bodies;
    for (const std::size_t count : counts) {
        if (count >= body.vertex_count()) break;
        while (order.chosen().size() < count) {
            if (!order.add()) return bodies;
        }
        bodies.push_back({order.chosen(), worst_error_of(body.vertices, order.chosen())});
    }
    return bodies;
}

SmallerBody within_tolerance(const Polyhedron& body, double tolerance) {
    FarthestFirst order(body.vertices);
    constexpr std::size_t solid = 4;
    while (order.chosen().size() < solid || !holds(body.vertices, order.chosen(), tolerance)) {
        if (!order.add()) break;
    }
    std::vector<Vec3d> subset = order.chosen();
    // The last that were added are the most needed.
    for (std::size_t i = 0; i < subset.size() && subset.size() > solid;) {
        std::vector<Vec3d> fewer = subset;
        fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
        if (holds(body.vertices, fewer, tolerance)) {
            subset = std::move(fewer);
        } else {
            ++i;
        }
    }
    return {subset, worst_error_of(body.vertices, subset)};
}

}  // namespace edgewise::studies::advise
