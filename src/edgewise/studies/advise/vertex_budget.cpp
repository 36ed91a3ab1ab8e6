// SPDX-License-Identifier: MIT
#include "edgewise/studies/advise/vertex_budget.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

#include "edgewise/bench/parallel.hpp"
#include "edgewise/geometry/hull/point_set.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/studies/single_cell.hpp"
#include "edgewise/studies/table_memory_cost.hpp"
#include "edgewise/truth/exact_distance.hpp"

namespace edgewise::studies::advise {

namespace {

double distance_from_hull(const Vec3d& point, std::span<const Vec3d> subset) {
    return truth::exact_distance(std::span(&point, 1), {}, subset, {}).or_throw().distance;
}

/// Returns the point for which `size` is largest, the first among equals.
template <class Size>
const Vec3d& largest(const std::vector<Vec3d>& points, const Size& size) {
    return *std::ranges::max_element(points, {}, size);
}

/// Returns vertices that span a solid: a cube's farthest four in turn may lie in one plane.
std::vector<Vec3d> spanning_four(const std::vector<Vec3d>& points) {
    const auto from = [&](const Vec3d& end) {
        return [&](const Vec3d& point) { return squared_norm(point - end); };
    };
    const Vec3d& a = largest(points, from(points.front()));
    const Vec3d& b = largest(points, from(a));
    const Vec3d line = b - a;
    const Vec3d& c =
        largest(points, [&](const Vec3d& point) { return squared_norm(cross(Vec3d(point - a), line)); });
    const Vec3d normal = cross(line, Vec3d(c - a));
    const Vec3d& d =
        largest(points, [&](const Vec3d& point) { return std::abs(dot(Vec3d(point - a), normal)); });
    return {a, b, c, d};
}

constexpr std::size_t fewest = 4;  ///< vertices at least

/// Vertices in the order in which the farthest is added, with the distance that each had then.
class FarthestFirst {
  public:
    explicit FarthestFirst(std::vector<Vec3d> points) : points_(std::move(points)) {
        chosen_ = spanning_four(points_);
        for (const Vec3d& point : points_) {
            if (std::ranges::find(chosen_, point) == chosen_.end())
                bounds_.push({distance_from_hull(point, chosen_), point});
        }
    }

    /// Adds the farthest vertex; returns false if none is left outside. Distances only shrink as points are
    /// added, so an old one is an upper bound, and the queue's top is the farthest once it is up to date.
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
        std::size_t of = fewest;  ///< how many were chosen when it was computed
        bool operator<(const Bound& other) const { return distance < other.distance; }
    };

    std::vector<Vec3d> points_, chosen_;
    std::priority_queue<Bound> bounds_;
};

bool is_solid(const std::vector<Vec3d>& points) {
    return flatness_error(points, distinct_points(points)).empty();
}

/// Returns true if every point lies within the tolerance of the subset's hull.
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

SmallerBody within_count(const Polyhedron& body, std::size_t most) {
    if (most >= body.vertex_count()) return {body.vertices, 0};
    FarthestFirst order(body.vertices);
    while (order.chosen().size() < most && order.add()) continue;
    return {order.chosen(), worst_error_of(body.vertices, order.chosen())};
}

SmallerBody within_tolerance(const Polyhedron& body, double tolerance) {
    FarthestFirst order(body.vertices);
    while (!holds(body.vertices, order.chosen(), tolerance)) {
        if (!order.add()) break;
    }
    std::vector<Vec3d> subset = order.chosen();
    // The vertices that were added last are the most needed.
    for (std::size_t i = 0; i < subset.size() && subset.size() > fewest;) {
        std::vector<Vec3d> fewer = subset;
        fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
        if (is_solid(fewer) && holds(body.vertices, fewer, tolerance)) {
            subset = std::move(fewer);
        } else {
            ++i;
        }
    }
    return {subset, worst_error_of(body.vertices, subset)};
}

std::vector<BodyCost> costs_of(std::span<const Polyhedron> bodies, const bench::TableType& type,
                               const std::string& algorithm) {
    constexpr int rounds = 7;
    std::vector<SingleCell> cells;
    std::vector<BodyCost> costs(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        // One answer is checked: a checked cell knows which queries are in contact, and times them apart.
        cells.emplace_back(CellChoice{.table = type.name,
                                      .algorithm = algorithm,
                                      .scene = "cold",
                                      .queries = 2000,
                                      .checked = 1,
                                      .body = scene::NamedShape{"budget", "given", bodies[i], {}}});
        costs[i].table_bytes = static_cast<double>(cells[i].runner().ledger().total());
        const auto touched = studies::lines_in_tumble(type, algorithm, bodies[i]);
        if (touched)
            costs[i].lines = static_cast<double>(touched->lines) / static_cast<double>(touched->queries);
    }
    const double clock_cost_ns = measure::calibrate();
    for (int round = 0; round < rounds; ++round) {
        sweep::take_turns(bodies.size(), static_cast<std::uint64_t>(round), [&](std::size_t i) {
            const auto ns = cells[i].prepared().time(clock_cost_ns).all();
            if (ns && (round == 0 || *ns < costs[i].ns)) costs[i].ns = *ns;
        });
    }
    return costs;
}

}  // namespace edgewise::studies::advise
