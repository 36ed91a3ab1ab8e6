// SPDX-License-Identifier: MIT
//
// DoubleDouble sums throughout: in a needle the plane's normal is a difference of nearly equal products.
#include "edgewise/geometry/hull/extreme_frame.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "edgewise/geometry/aabb.hpp"
#include "edgewise/geometry/double_double.hpp"
#include "edgewise/geometry/hull/point_set.hpp"

namespace edgewise {
namespace {

/// The chosen index for which a measure is largest (the first of them), and that largest value.
template <class Measure>
std::pair<Index, double> farthest(std::span<const Index> chosen, const Measure& measure) {
    std::pair<Index, double> best{chosen.front(), -1};
    for (const Index i : chosen) {
        const double value = measure(i);
        if (value > best.second) best = {i, value};
    }
    return best;
}

Vec3d unit(const DoubleDoubleVec& v) {
    const Vec3d rounded = cast<double>(v);
    const double largest = max_abs(rounded);
    if (!(largest > 0)) return Vec3d::Zero();
    const Vec3d safe = rounded / largest;  // the square of a sliver's area may vanish
    return safe / norm(safe);
}

}  // namespace

ExtremeFrame extreme_frame(std::span<const Vec3d> points, std::span<const Index> chosen) {
    Eigen::Index axis = 0;
    box_of(points).sides().maxCoeff(&axis);
    const double scale = unit_scale(points);
    const auto along_axis = [&](Index i, Index j) { return points[i][axis] < points[j][axis]; };
    const auto [first, last] = std::minmax_element(chosen.begin(), chosen.end(), along_axis);
    const Vec3d& origin = points[*first];
    const auto from_origin = [&](Index i) { return exact_difference(points[i], origin, scale); };

    const DoubleDoubleVec line = from_origin(*last);
    const auto area_with = [&](Index i) { return norm(cast<double>(cross(line, from_origin(i)))); };
    const auto [third, area] = farthest(chosen, area_with);
    const DoubleDoubleVec normal = cross(line, from_origin(third));
    const auto volume_with = [&](Index i) { return std::abs(dot(normal, from_origin(i)).value()); };
    const double content = farthest(chosen, volume_with).second;

    ExtremeFrame frame;
    frame.origin = origin;
    const double length = norm(cast<double>(line));
    frame.across_line = area / (length * length);
    frame.across_plane = area > 0 ? content / area / length : 0;
    const Vec3d along = unit(line);
    const Vec3d across = unit(normal);
    frame.axes << along.transpose(), cross(across, along).transpose(), across.transpose();
    return frame;
}

std::vector<Vec3d> in_own_axes(std::span<const Vec3d> points, std::span<const Index> chosen) {
    const ExtremeFrame frame = extreme_frame(points, chosen);
    const double scale = unit_scale(points);
    std::vector<Vec3d> result(chosen.size());
    for (int row = 0; row < 3; ++row) {
        const Vec3d axis = frame.axes.row(row);
        for (std::size_t k = 0; k < chosen.size(); ++k) {
            const DoubleDoubleVec p = exact_difference(points[chosen[k]], frame.origin, scale);
            result[k][row] = dot(cast<DoubleDouble>(axis), p).value();
        }
    }
    const Vec3d factor = box_of(result).sides().unaryExpr(&scale_to_unit);
    for (Vec3d& p : result) p = p.cwiseProduct(factor);
    return result;
}

}  // namespace edgewise
