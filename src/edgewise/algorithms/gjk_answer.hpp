// SPDX-License-Identifier: MIT
//
// Distance, witness points and normal from GJK's last simplex.
#pragma once

#include "edgewise/algorithms/distance.hpp"
#include "edgewise/algorithms/subset.hpp"
#include "edgewise/geometry/vec.hpp"

namespace edgewise {

/// `simplex`: on_a(i), on_b(i), in A's frame, of `count` points. Witness points are weighted sums of them.
/// Weights on a thin triangle are less accurate than its foot: the difference of the witnesses of separated
/// bodies from it is shared out, so that they are separated by the reported distance.
template <class Points, class Scalar>
[[nodiscard]] Distance gjk_answer(const Points& simplex, const ClosestOfSimplex<Scalar>& closest,
                                  Status status, int steps) {
    Vec3<Scalar> on_a = Vec3<Scalar>::Zero(), on_b = Vec3<Scalar>::Zero();
    for (int i = 0; i < simplex.count; ++i) {
        on_a += closest.weight[i] * simplex.on_a(i);
        on_b += closest.weight[i] * simplex.on_b(i);
    }
    Distance answer;
    answer.status = status;
    if (status == Status::separated) {
        const Vec3<Scalar> excess = Scalar(0.5) * (on_a - on_b - closest.point);
        on_a -= excess;
        on_b += excess;
        const Scalar distance = norm(closest.point);
        answer.distance = distance;
        answer.normal = Vec3<Scalar>(closest.point * (-1 / distance)).template cast<double>();
    }
    answer.point_a = on_a.template cast<double>();
    answer.point_b = on_b.template cast<double>();
    answer.steps = steps;
    return answer;
}

}  // namespace edgewise
