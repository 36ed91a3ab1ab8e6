// SPDX-License-Identifier: MIT
//
// Planes of faces with thin corners, where nothing but corners is stored.
//
// A cross product of two sides is off by a rounding step of the product of their lengths: relative to its own
// length, by that over the sine of the angle. A face with corners within 1e-12 of a line has a plane, and
// sides perpendicular to it, that are off by 1e-4 rad in plain arithmetic; a point a thousandth outside of
// the body is then called inside. Stored planes were computed in wider arithmetic once
// (geometry/polyhedron_builder.cpp). Derived planes of faces use wider arithmetic here, only where a corner
// is thin, and are then as accurate as stored ones. Planes through sides may be a little less so, in a way
// that distances do not feel (Tolerance::tilting_corner).
#pragma once

#include <algorithm>
#include <type_traits>

#include "edgewise/geometry/double_double.hpp"
#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/tolerance.hpp"

namespace edgewise {

/// Newell's sum over the corners of a face, seen from its first: twice its area along its normal.
template <class Scalar>
class NewellSum {
  public:
    void add(const Vec3<Scalar>& corner) {
        normal_ += cross(before_, corner);
        before_ = corner;
    }
    [[nodiscard]] const Vec3<Scalar>& normal() const { return normal_; }

  protected:
    Vec3<Scalar> normal_ = Vec3<Scalar>::Zero(), before_ = Vec3<Scalar>::Zero();
};

/// Newell's sum in plain arithmetic, with a measure of its accuracy.
template <class Scalar>
class PlainNewellSum : public NewellSum<Scalar> {
  public:
    void add(const Vec3<Scalar>& corner) {
        largest_ = std::max(largest_, squared_norm(this->before_) * squared_norm(corner));
        NewellSum<Scalar>::add(corner);
    }
    /// Returns true if it keeps all but four binary digits; false where products vanish.
    [[nodiscard]] bool is_fair() const {
        return squared_norm(this->normal_) > Tolerance<Scalar>::fair_corner * largest_;
    }

  private:
    Scalar largest_ = 0;
};

/// a - b: exact for doubles, and for singles up to a rounding step of doubles.
template <class Scalar>
[[nodiscard]] Vec3<Wider<Scalar>> wide_difference(const Vec3<Scalar>& a, const Vec3<Scalar>& b) {
    if constexpr (std::is_same_v<Scalar, float>)
        return cast<double>(a) - cast<double>(b);
    else
        return exact_difference(a, b, 1);
}

/// The part of `aside` that is perpendicular to `along`, times the square of the latter.
template <class Vector>
[[nodiscard]] Vector perpendicular_part(const Vector& along, const Vector& aside) {
    return squared_norm(along) * aside - dot(along, aside) * along;
}

/// The part of `base` to `other` that is perpendicular to `base` to `end`, times the square of the latter. At
/// a fair corner in plain arithmetic. At a thinner one the part of the part is taken, without what rounding
/// left along the side (Parlett, The Symmetric Eigenvalue Problem, 1980, 6.9: twice is enough): the plane
/// holds the side, and is tilted about it (Tolerance::tilting_corner). Thinner still: in the next wider
/// arithmetic, and rounded at the end.
template <class Scalar>
[[nodiscard]] [[gnu::noinline]] Vec3<Scalar> perpendicular_at(const Vec3<Scalar>& base,
                                                              const Vec3<Scalar>& end,
                                                              const Vec3<Scalar>& other) {
    const Vec3<Scalar> along = end - base, aside = other - base;
    const Scalar squared_sine = squared_norm(cross(along, aside)),
                 most = squared_norm(along) * squared_norm(aside);
    if (squared_sine > Tolerance<Scalar>::tilting_corner * most) {
        const Vec3<Scalar> plain = perpendicular_part(along, aside);
        if (squared_sine > Tolerance<Scalar>::fair_corner * most) return plain;
        return plain - dot(along, plain) / squared_norm(along) * along;
    }
    return cast<Scalar>(perpendicular_part(wide_difference(end, base), wide_difference(other, base)));
}

/// Returns true if a plane that plain arithmetic of this scalar derives may be off by more than four binary
/// digits: two sides of a face meet, or a face is seen from a corner, at a sine below 1/16; or a side is so
/// short that rounding the body to this scalar may have made it so. `reach`: its largest coordinate.
template <class Scalar>
[[nodiscard]] bool has_thin_corners(const Polyhedron& body, double reach) {
    const double shortest = double{Tolerance<Scalar>::rounded_side} * reach;
    const auto is_thin = [&](Index f) {
        const auto ring = body.ring_of_face(f);
        const Vec3d base = body.vertices[body.tail(ring[0])];
        Vec3d before = body.vertices[body.head(ring.back())] - body.vertices[body.tail(ring.back())];
        PlainNewellSum<double> whole;
        for (const HalfEdge h : ring) {
            const Vec3d side = body.vertices[body.head(h)] - body.vertices[body.tail(h)];
            PlainNewellSum<double> corner;
            corner.add(before);
            corner.add(side);
            if (!corner.is_fair() || max_abs(side) < shortest) return true;
            whole.add(Vec3d(body.vertices[body.tail(h)] - base));
            before = side;
        }
        return !whole.is_fair();
    };
    for (Index f = 0; f < body.face_count(); ++f) {
        if (is_thin(f)) return true;
    }
    return false;
}

}  // namespace edgewise
