// SPDX-License-Identifier: MIT
#include "edgewise/algorithms/penetration.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

#include "edgewise/algorithms/johnson.hpp"
#include "edgewise/algorithms/penetration/tetrahedron.hpp"
#include "edgewise/geometry/double_double.hpp"
#include "edgewise/table/small_array.hpp"

namespace edgewise {

namespace epa {
namespace {

/// A point of the polytope's surface.
struct Witness {
    SmallArray<Id, 3> vertex{};
    SmallArray<double, 3> weight{};                             ///< none negative; they sum to one
    double distance = std::numeric_limits<double>::infinity();  ///< from the foot
};

/// Finds the place of the origin's foot on the polytope, once the nearest plane is known. That plane may hold
/// many triangles, and the foot need not be in the one that was found first. Not Johnson's sub-distance: its
/// cofactors lose digits with the square of a triangle's thinness, and edges that cross at a small angle make
/// thin triangles. Areas in double the digits, once a query, lose none.
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
[[nodiscard]] Witness find_witness(const Polytope& polytope, const Face& nearest, double distance,
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

}  // namespace
}  // namespace epa

namespace {

class EpaRun {
  public:
    using Corner = epa::Corner;

    EpaRun(const epa::Difference& difference, PenetrationSpace& space)
        : difference_(difference), polytope_(space.polytope), corners_(space.corners), space_(space) {}

    [[nodiscard]] Penetration run(std::span<const Corner> start) {
        const epa::Tetrahedron tetrahedron(difference_, start);
        if (!tetrahedron.is_solid()) return flat(tetrahedron);
        begin(tetrahedron);
        for (std::size_t step = 0; step <= space_.face_limit; ++step) {
            ++answer_.steps;
            const epa::Id face = polytope_.nearest();
            const epa::Face& nearest = polytope_.faces()[face];
            const Corner corner = difference_.support(nearest.normal, corners_[nearest.vertex[0]]);
            const Vec3d point = take(corner);
            const double gain = dot(nearest.normal, Vec3d(point - polytope_.point(nearest.vertex[0])));
            if (!(gain > noise()) || !polytope_.is_above(point, nearest)) return finish(nearest, gain);
            note_bound(nearest, gain, corner);
            if (polytope_.faces_made() >= space_.face_limit) return answer_;
            polytope_.expand(point, face);
            corners_.push_back(corner);
        }
        assert(false && "each step makes three faces or more");
        return answer_;
    }

  private:
    void begin(const epa::Tetrahedron& tetrahedron) {
        assert(space_.face_limit >= 4 && "a tetrahedron must fit");
        scale_ = tetrahedron.scale();
        corners_.assign(tetrahedron.corners().begin(), tetrahedron.corners().end());
        for (const Corner& corner : corners_) take(corner);
        polytope_.start(tetrahedron.points());
        answer_.depth = std::numeric_limits<double>::infinity();
    }

    /// Takes the corner as a point of the polytope.
    Vec3d take(const Corner& corner) {
        size_ = std::max(size_, corner.size() * scale_);
        return corner.point(scale_);
    }

    /// Rounding noise of the products along a unit direction.
    [[nodiscard]] double noise() const { return difference_.support_noise() * size_; }

    /// The difference ends at its support plane along any direction: no longer translation is needed.
    void note_bound(const epa::Face& face, double gain, const Corner& corner) {
        const double bound = std::max(0.0, (face.distance + gain) / scale_);
        if (bound >= answer_.depth) return;
        answer_.depth = bound;
        answer_.normal = face.normal;
        answer_.point_a = corner.on_a;
        answer_.point_b = corner.on_b;
    }

    [[nodiscard]] Penetration finish(const epa::Face& nearest, double gain) {
        const bool in_plane = polytope_.side_of(nearest, Vec3d::Zero()) == 0;
        const double distance = in_plane ? 0 : nearest.distance;
        const auto witness = epa::find_witness(polytope_, nearest, distance, noise());
        answer_.depth = std::max(0.0, (gain > noise() ? distance + gain : distance) / scale_);
        answer_.normal = nearest.normal;
        answer_.point_a = answer_.point_b = Vec3d::Zero();
        for (int i = 0; i < 3; ++i) {
            const Corner& corner = corners_[witness.vertex[i]];
            answer_.point_a += witness.weight[i] * corner.on_a;
            answer_.point_b += witness.weight[i] * corner.on_b;
        }
        assert(witness.distance < std::numeric_limits<double>::infinity());
        answer_.converged = true;
        return answer_;
    }

    /// A difference without volume has no depth: any step across it separates the bodies. Solids look like
    /// that only when an offset swallows their digits; then they are separated already.
    [[nodiscard]] Penetration flat(const epa::Tetrahedron& tetrahedron) {
        const auto closest = Johnson<double>(tetrahedron.points(), tetrahedron.count()).closest();
        const double distance = norm(closest.point);
        const Vec3d direct = distance > 0 ? Vec3d(closest.point / -distance) : Vec3d(Vec3d::Zero());
        answer_.normal = ends_at_origin(direct, tetrahedron) ? direct : tetrahedron.across();
        for (int i = 0; i < tetrahedron.count(); ++i) {
            answer_.point_a += closest.weight[i] * tetrahedron.corners()[i].on_a;
            answer_.point_b += closest.weight[i] * tetrahedron.corners()[i].on_b;
        }
        answer_.converged = true;
        return answer_;
    }

    /// Returns true if the difference does not continue beyond the origin along a unit direction. A distance
    /// of some rounding steps has a direction that is noise, and may lie within the difference's own plane.
    [[nodiscard]] bool ends_at_origin(const Vec3d& direction, const epa::Tetrahedron& tetrahedron) const {
        if (max_abs(direction) == 0) return false;
        const Corner& first = tetrahedron.corners()[0];
        const double scale = tetrahedron.scale();
        const Corner highest = difference_.support(direction, first);
        const double size = std::max(first.size(), highest.size()) * scale;
        return dot(direction, highest.point(scale)) <= difference_.support_noise() * size;
    }

    const epa::Difference& difference_;
    epa::Polytope& polytope_;
    std::vector<Corner>& corners_;
    const PenetrationSpace& space_;
    Penetration answer_;
    double scale_ = 1;
    double size_ = 0;  ///< longest coordinate seen, scaled
};

}  // namespace

Penetration penetration(const epa::Difference& difference, std::span<const epa::Corner> start,
                        PenetrationSpace& space) {
    return EpaRun(difference, space).run(start);
}

}  // namespace edgewise
