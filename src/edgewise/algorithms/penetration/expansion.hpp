// SPDX-License-Identifier: MIT
//
// The side of a triangle's plane on which a point lies, and the triangle's normal, without error where that
// matters: a filter in floating point, and in doubtful cases sums of products of two or three differences of
// coordinates, without rounding. Shewchuk's grow-expansion ("Adaptive precision floating-point arithmetic and
// fast robust geometric predicates", 1997), without the stages between his filter and the full sum, since few
// points are in doubt. Exact as long as no digit of a product leaves the range of double: see
// smallest_coordinate.
#pragma once

#include <cassert>
#include <cmath>

#include "edgewise/geometry/double_double.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/table/small_array.hpp"

namespace edgewise::epa {

/// A sum of doubles without rounding: terms that do not overlap, the smallest first.
class Expansion {
  public:
    void add(double value) {
        int kept = 0;
        for (int i = 0; i < count_; ++i) {
            const DoubleDouble sum = exact_sum(value, term_[i]);
            value = sum.high;
            if (sum.low != 0) term_[kept++] = sum.low;
        }
        assert(kept < determinant_terms);
        if (value != 0) term_[kept++] = value;
        count_ = kept;
    }

    void add_product(double a, double b, double c) {
        const DoubleDouble ab = exact_product(a, b);
        for (const double part : {ab.low, ab.high}) {
            if (part == 0) continue;
            const DoubleDouble abc = exact_product(part, c);
            add(abc.low);
            add(abc.high);
        }
    }

    void add_product(const DoubleDouble& a, const DoubleDouble& b) {
        for (const double x : {a.low, a.high}) {
            for (const double y : {b.low, b.high}) {
                const DoubleDouble xy = exact_product(x, y);
                add(xy.low);
                add(xy.high);
            }
        }
    }

    void add_product(const DoubleDouble& a, const DoubleDouble& b, const DoubleDouble& c) {
        for (const double x : {a.low, a.high}) {
            for (const double y : {b.low, b.high}) {
                for (const double z : {c.low, c.high}) {
                    if (x != 0 && y != 0 && z != 0) add_product(x, y, z);
                }
            }
        }
    }

    /// Value of the sum, to a rounding step or two.
    [[nodiscard]] double value() const {
        double sum = 0;
        for (int i = 0; i < count_; ++i) sum += term_[i];
        return sum;
    }

    /// Sign of the sum: that of its largest term.
    [[nodiscard]] int sign() const {
        return count_ == 0 ? 0 : (term_[count_ - 1] > 0) - (term_[count_ - 1] < 0);
    }

  private:
    static constexpr int determinant_terms = 6 * 8 * 4;  ///< products, choices of parts, parts of each

    SmallArray<double, determinant_terms> term_;
    int count_ = 0;
};

/// Sign of the determinant of three corners and a point, from all of its terms.
[[nodiscard]] [[gnu::noinline]] inline int exact_side(const Vec3d& a, const Vec3d& b, const Vec3d& c,
                                                      const Vec3d& point) {
    const DoubleDoubleVec p = exact_difference(b, a, 1), q = exact_difference(c, a, 1);
    const DoubleDoubleVec r = exact_difference(point, a, 1);
    Expansion determinant;
    determinant.add_product(r.x(), p.y(), q.z());
    determinant.add_product(-r.x(), p.z(), q.y());
    determinant.add_product(r.y(), p.z(), q.x());
    determinant.add_product(-r.y(), p.x(), q.z());
    determinant.add_product(r.z(), p.x(), q.y());
    determinant.add_product(-r.z(), p.y(), q.x());
    return determinant.sign();
}

/// Returns 1 if the point is above the triangle (from there its corners run counter-clockwise), -1 if below,
/// 0 in its plane.
[[nodiscard]] inline int side(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& point) {
    const Vec3d p = b - a, q = c - a, r = point - a;
    const double yz = p.y() * q.z(), zy = p.z() * q.y();
    const double zx = p.z() * q.x(), xz = p.x() * q.z();
    const double xy = p.x() * q.y(), yx = p.y() * q.x();
    const double volume = r.x() * (yz - zy) + r.y() * (zx - xz) + r.z() * (xy - yx);
    const double permanent = std::abs(r.x()) * (std::abs(yz) + std::abs(zy)) +
                             std::abs(r.y()) * (std::abs(zx) + std::abs(xz)) +
                             std::abs(r.z()) * (std::abs(xy) + std::abs(yx));
    const double noise = Tolerance<double>::volume_noise * permanent;
    if (volume > noise) return 1;
    if (volume < -noise) return -1;
    return exact_side(a, b, c, point);
}

/// Exact cross product, rounded at the end; zero only if the corners lie on a line.
[[nodiscard]] [[gnu::noinline]] inline Vec3d exact_cross(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const DoubleDoubleVec p = exact_difference(b, a, 1), q = exact_difference(c, a, 1);
    const auto minor = [](const DoubleDouble& p1, const DoubleDouble& q2, const DoubleDouble& p2,
                          const DoubleDouble& q1) {
        Expansion sum;
        sum.add_product(p1, q2);
        sum.add_product(-p2, q1);
        return sum.value();
    };
    return {minor(p.y(), q.z(), p.z(), q.y()), minor(p.z(), q.x(), p.x(), q.z()),
            minor(p.x(), q.y(), p.y(), q.x())};
}

/// Unit normal, for corners that are not on a line, accurate to a few rounding steps even for a sliver: there
/// the cross product of plain differences is noise. Parallel edges of both bodies make three corners that are
/// collinear except for the last digit. Sometimes they are so nearly collinear that a product in double the
/// digits is noise too; hence the exact product.
[[nodiscard]] inline Vec3d triangle_normal(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const Vec3d p = b - a, q = c - a;
    Vec3d normal = cross(p, q);
    if (squared_norm(normal) < Tolerance<double>::fair_corner * squared_norm(p) * squared_norm(q)) {
        normal = exact_cross(a, b, c);
        assert(max_abs(normal) > 0 && "three corners on a line have no normal");
        normal /= max_abs(normal);  // its square may vanish
    }
    return normal / norm(normal);
}

}  // namespace edgewise::epa
