// SPDX-License-Identifier: MIT
#include "edgewise/algorithms/penetration.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

#include "edgewise/algorithms/johnson.hpp"
#include "edgewise/algorithms/penetration/tetrahedron.hpp"
#include "edgewise/algorithms/penetration/witness.hpp"

namespace edgewise {

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
