// SPDX-License-Identifier: MIT
//
// One pass in order of error, then time (Kung, Luccio and Preparata, "On Finding the Maxima of a Set of
// Vectors", 1975, of two dimensions): a point is on the front if it is faster than all before it, or equal to
// the last that was.
#include "edgewise/reports/tables/pareto_front.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

namespace edgewise::reports {

std::vector<bool> pareto_front(std::span<const SpeedError> points) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!std::isnan(points[i].ns) && !std::isnan(points[i].error)) order.push_back(i);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::tie(points[a].error, points[a].ns) < std::tie(points[b].error, points[b].ns);
    });
    std::vector<bool> on_front(points.size());
    std::optional<SpeedError> last;
    for (const std::size_t i : order) {
        const SpeedError& point = points[i];
        const bool equal = last && point.ns == last->ns && point.error == last->error;
        if (last && !equal && point.ns >= last->ns) continue;
        on_front[i] = true;
        last = point;
    }
    return on_front;
}

}  // namespace edgewise::reports
