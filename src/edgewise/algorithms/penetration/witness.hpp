// SPDX-License-Identifier: MIT
//
// Finds the place of the origin's foot on the polytope, once the nearest plane is known. That plane may hold
// many triangles, and the foot need not be in the one that was found first.
//
// Not Johnson's sub-distance: its cofactors lose digits with the square of a triangle's thinness, and edges
// that cross at a small angle make thin triangles. Areas in double the digits, once a query, lose none.
#pragma once

#include <algorithm>
#include <cassert>
#include <limits>

#include "edgewise/algorithms/penetration/polytope.hpp"
#include "edgewise/geometry/double_double.hpp"
#include "edgewise/table/small_array.hpp"

namespace edgewise::epa {

/// A point of the polytope's surface.
struct Witness {
    SmallArray<Id, 3> vertex{};
    SmallArray<double, 3> weight{};                             ///< none negative; they sum to one
    double distance = std::numeric_limits<double>::infinity();  ///< from the foot
};

class WitnessSearch {
  public:
    WitnessSearch(const Polytope& polytope, const Vec3d& foot) : polytope_(polytope), foot_(foot) {}

    [[nodiscard]] const Witness& best() const { return best_; }

    /// Takes the point of the face closest to the foot, if it is closer than the best so far.
    void consider(const Face& face) {
        const SmallArray<double, 3> area = corner_areas(face);
        const double sum = area[0] + area[1] + area[2];
        if (area[0] >= 0 && area[1] >= 0 && area[2] >= 0 && sum > 0) {
            keep_if_closer(face, {area[0] / sum, area[1] / sum, area[2] / sum});
            return;
        }
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3;
            const Vec3d from = polytope_.point(face.vertex[i]);
            const Vec3d edge = polytope_.point(face.vertex[j]) - from;
            SmallArray<double, 3> weight{};
            weight[j] = std::clamp(dot(Vec3d(foot_ - from), edge) / squared_norm(edge), 0.0, 1.0);
            weight[i] = 1 - weight[j];
            keep_if_closer(face, weight);
        }
    }

  private:
    /// Areas of the triangles of the foot with the edge opposite each corner, seen along the normal.
    [[nodiscard]] SmallArray<double, 3> corner_areas(const Face& face) const {
        SmallArray<DoubleDoubleVec, 3> spoke;
        for (int i = 0; i < 3; ++i) spoke[i] = exact_difference(polytope_.point(face.vertex[i]), foot_, 1);
        SmallArray<double, 3> area;
        for (int i = 0; i < 3; ++i) {
            area[i] = dot(face.normal, cast<double>(cross(spoke[(i + 1) % 3], spoke[(i + 2) % 3])));
        }
        return area;
    }

    void keep_if_closer(const Face& face, const SmallArray<double, 3>& weight) {
        Vec3d offset = -foot_;
        for (int i = 0; i < 3; ++i) offset += weight[i] * polytope_.point(face.vertex[i]);
        const double distance = norm(offset);
        if (distance < best_.distance) best_ = {face.vertex, weight, distance};
    }

    const Polytope& polytope_;
    Vec3d foot_;
    Witness best_;
};

/// The point of the polytope closest to the foot of the origin on the plane of its nearest face. Searches the
/// faces with planes that are not farther (to within noise): one of them holds it.
[[nodiscard]] inline Witness find_witness(const Polytope& polytope, const Face& nearest, double distance,
                                          double noise) {
    assert(noise >= 0 && nearest.live);
    WitnessSearch search(polytope, distance * nearest.normal);
    search.consider(nearest);
    for (const Face& face : polytope.faces()) {
        if (search.best().distance <= noise) break;
        const bool as_near = face.live && face.distance <= nearest.distance + noise;
        if (as_near && dot(face.normal, nearest.normal) > 0) search.consider(face);
    }
    return search.best();
}

}  // namespace edgewise::epa
