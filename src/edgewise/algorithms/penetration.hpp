// SPDX-License-Identifier: MIT
//
// How deep two bodies overlap: the shortest translation that separates them, by the expanding polytope
// algorithm (EPA). A polytope inside the Minkowski difference A - B grows by support points along the normal
// of its face nearest to the origin, until that face cannot be pushed out any further.
//
// van den Bergen, "Proximity queries and penetration depth computation on 3D game objects", 2001. Departures:
// - the polytope is the exact hull of its points (penetration/polytope.hpp) and computes in double whatever
//   the tables hold, so neither coplanar faces nor slivers need a tolerance;
// - it starts from any tetrahedron with volume, whether or not it holds the origin;
// - it ends when the gain along the nearest face's normal is within the rounding of the support products, or
//   when the farthest point is not above that face; every other step takes in a new vertex of A - B, so it
//   ends;
// - every support plane bounds the depth from above, and the least bound seen is the answer if the work space
//   is full: still a translation that separates the bodies.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <limits>
#include <vector>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/penetration/difference.hpp"
#include "edgewise/algorithms/penetration/polytope.hpp"
#include "edgewise/algorithms/penetration/tetrahedron.hpp"
#include "edgewise/algorithms/penetration/witness.hpp"

namespace edgewise {

/// All in A's frame. B moved by depth * normal touches A. Always <normal, point_a - point_b> = depth; when
/// converged, point_a - point_b = depth * normal, both to rounding: point_a is the point of A deepest in B,
/// point_b that of B deepest in A.
struct Penetration {
    double depth = 0;              ///< 0: touching, or separated (then along the normal, the points are void)
    Vec3d normal = Vec3d::Zero();  ///< unit; where B must go, outward from A
    Vec3d point_a = Vec3d::Zero();  ///< on the surface of A
    Vec3d point_b = Vec3d::Zero();  ///< on the surface of B
    int steps = 0;                  ///< faces looked at
    bool converged = false;         ///< false: the work space was full; the depth is an upper bound
};

/// What a query needs beside the stack. Reused from one query to the next, it allocates only when a query
/// needs more than any before it.
template <SupportTable TableA, SupportTable TableB>
struct PenetrationSpace {
    static constexpr std::size_t first_faces = 256;

    /// A query stops when it has made so many faces (some 100 bytes each). Shallow pairs make
    /// some dozen; two concentric spheres, all of whose surface is about equally deep, make 4000 with 386
    /// vertices each and 13000 with 1538.
    std::size_t face_limit = 65536;

    epa::Polytope polytope;
    std::vector<epa::Corner<TableA, TableB>> corners;  ///< of the polytope's points

    PenetrationSpace() {
        polytope.reserve(first_faces);
        corners.reserve(first_faces);
    }
};

template <SupportTable TableA, SupportTable TableB>
class EpaRun {
  public:
    using Scalar = ComputeOf<TableA>;
    using Space = PenetrationSpace<TableA, TableB>;

    EpaRun(const TableA& a, const TableB& b, const Transform<Scalar>& a_from_b, Space& space)
        : difference_(a, b, a_from_b), polytope_(space.polytope), corners_(space.corners), space_(space) {}

    [[nodiscard]] Penetration run(const SimplexPair<TableA, TableB>& start) {
        const epa::Tetrahedron<TableA, TableB> tetrahedron(difference_, start);
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
    using Corner = epa::Corner<TableA, TableB>;

    void begin(const epa::Tetrahedron<TableA, TableB>& tetrahedron) {
        assert(space_.face_limit >= 4 && "a tetrahedron must fit");
        scale_ = tetrahedron.scale();
        corners_.assign(tetrahedron.corners().begin(), tetrahedron.corners().end());
        for (const Corner& corner : corners_) take(corner);
        polytope_.start(tetrahedron.points());
        answer_.depth = std::numeric_limits<double>::infinity();
    }

    /// The corner as a point of the polytope.
    Vec3d take(const Corner& corner) {
        size_ = std::max(size_, corner.size() * scale_);
        return corner.point(scale_);
    }

    /// Of the products along a unit direction.
    [[nodiscard]] double noise() const {
        return static_cast<double>(Tolerance<Scalar>::support_noise) * size_;
    }

    /// Along any direction the difference ends at its support plane: no translation beyond that is needed.
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

    /// A difference without volume has no depth: any step across it separates the bodies. Solids only look
    /// like that when an offset swallows their digits; then they are separated already.
    [[nodiscard]] Penetration flat(const epa::Tetrahedron<TableA, TableB>& tetrahedron) {
        const auto closest = Johnson<double>(tetrahedron.points(), tetrahedron.count()).closest();
        const double distance = norm(closest.point);
        answer_.normal = distance > 0 ? Vec3d(closest.point / -distance) : tetrahedron.across();
        for (int i = 0; i < tetrahedron.count(); ++i) {
            answer_.point_a += closest.weight[i] * tetrahedron.corners()[i].on_a;
            answer_.point_b += closest.weight[i] * tetrahedron.corners()[i].on_b;
        }
        answer_.converged = true;
        return answer_;
    }

    epa::Difference<TableA, TableB> difference_;
    epa::Polytope& polytope_;
    std::vector<Corner>& corners_;
    const Space& space_;
    Penetration answer_;
    double scale_ = 1;
    double size_ = 0;  ///< longest coordinate seen, scaled
};

/// Depth of two bodies that GJK found touching or overlapping; `start` is what that query left (any other,
/// or an empty one, costs steps only). `a_from_b` takes B's points into A's frame.
template <SupportTable TableA, SupportTable TableB>
[[nodiscard]] Penetration penetration(const TableA& a, const TableB& b, const Transform<double>& a_from_b,
                                      const SimplexPair<TableA, TableB>& start,
                                      PenetrationSpace<TableA, TableB>& space) {
    const auto transform = cast<ComputeOf<TableA>>(a_from_b);
    EpaRun<TableA, TableB> run(a, b, transform, space);
    return run.run(start.belongs_to(a, b) ? start : SimplexPair<TableA, TableB>(a, b));
}

}  // namespace edgewise
