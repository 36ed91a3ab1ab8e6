// SPDX-License-Identifier: MIT
//
// Validation and exact normalisation of point sets. Recentring is exact by Sterbenz' lemma: p - c has no
// rounding when p/2 <= c <= 2p, so an axis is recentred only when all its coordinates have one sign and lie
// within a factor of two; nearer to the origin there is nothing to gain. Scaling is by powers of two.
#include "edgewise/geometry/hull/point_set.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "edgewise/geometry/aabb.hpp"
#include "edgewise/geometry/hull/extreme_frame.hpp"
#include "edgewise/geometry/message.hpp"
#include "edgewise/geometry/tolerance.hpp"

namespace edgewise {
namespace {

/// Returns all indices, equal points next to each other with the lowest index first.
std::vector<Index> sorted_indices(std::span<const Vec3d> points) {
    std::vector<Index> order(points.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::ranges::sort(order, {},
                      [&](Index i) { return std::tuple(points[i].x(), points[i].y(), points[i].z(), i); });
    return order;
}

/// Says why a coordinate is unusable, to follow its value; empty for a usable one.
std::string value_error(double value) {
    if (!std::isfinite(value)) return "; every coordinate must be a finite number";
    if (std::abs(value) <= largest_coordinate) return {};
    return message(" is beyond ", largest_coordinate, "; scale the body down");
}

/// Returns a number that can be subtracted without rounding from all from low to high; 0 if there is none.
double exact_centre(double low, double high) {
    const bool one_sign = low > 0 || high < 0;
    const double small = std::min(std::abs(low), std::abs(high));
    const double large = std::max(std::abs(low), std::abs(high));
    if (!one_sign || large > 2 * small) return 0;
    return low + (high - low) / 2;
}

}  // namespace

double widest_extent(std::span<const Vec3d> points) { return max_abs(box_of(points).sides()); }

std::string coordinate_error(std::span<const Vec3d> points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            const std::string why = value_error(points[i][axis]);
            if (!why.empty()) {
                return message("vertex ", i, ": ", "xyz"[axis], " = ", points[i][axis], why);
            }
        }
    }
    const double width = widest_extent(points);
    if (!(width > 0) || width >= smallest_extent) return {};
    const auto far =
        std::find_if(points.begin(), points.end(), [&](const Vec3d& p) { return p != points[0]; });
    return message("vertex ", far - points.begin(), ": (", far->x(), ", ", far->y(), ", ", far->z(),
                   ") makes a body ", width, " wide, below ", smallest_extent, "; scale the body up");
}

std::vector<Index> first_of_equals(std::span<const Vec3d> points) {
    const std::vector<Index> order = sorted_indices(points);
    std::vector<Index> first(points.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
        const bool same = k > 0 && points[order[k]] == points[order[k - 1]];
        first[order[k]] = same ? first[order[k - 1]] : order[k];
    }
    return first;
}

std::vector<Index> distinct_points(std::span<const Vec3d> points) {
    std::vector<Index> order = sorted_indices(points);
    const auto same = [&](Index i, Index j) { return points[i] == points[j]; };
    order.erase(std::unique(order.begin(), order.end(), same), order.end());
    return order;
}

double scale_to_unit(double size) {
    if (!(size > 0)) return 1;
    int exponent = 0;
    (void)std::frexp(size, &exponent);
    return std::ldexp(1.0, -exponent);
}

double unit_scale(std::span<const Vec3d> points) { return scale_to_unit(widest_extent(points)); }

std::vector<Vec3d> normalised(std::span<const Vec3d> points, std::span<const Index> chosen) {
    const Aabb box = box_of(points);
    Vec3d centre, scale;
    for (int axis = 0; axis < 3; ++axis) {
        centre[axis] = exact_centre(box.low[axis], box.high[axis]);
        scale[axis] = scale_to_unit(box.sides()[axis]);
    }
    std::vector<Vec3d> result;
    result.reserve(chosen.size());
    for (const Index i : chosen) result.push_back((points[i] - centre).cwiseProduct(scale));
    return result;
}

std::string flatness_error(std::span<const Vec3d> points, std::span<const Index> distinct) {
    if (points.empty()) return "no vertices";
    if (distinct.size() == 1) {
        return points.size() == 1 ? std::string("flat: a single point has no volume")
                                  : message("flat: all ", points.size(), " vertices are the same point");
    }
    if (distinct.size() < 4) {
        return message("flat: ", distinct.size(), " distinct vertices, a solid needs at least 4");
    }
    const ExtremeFrame frame = extreme_frame(points, distinct);
    if (frame.across_line < flat_thickness) {
        return message("flat: all ", points.size(), " vertices lie on one line");
    }
    if (frame.across_plane >= flat_thickness) return {};
    return message("flat: all ", points.size(), " vertices lie in one plane (thickness ",
                   rounded(frame.across_plane), " of the extent, a solid needs ", rounded(flat_thickness),
                   ")");
}

}  // namespace edgewise
