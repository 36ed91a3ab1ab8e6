// SPDX-License-Identifier: MIT
//
// The Minkowski difference A - B as EPA sees it: corners (a vertex of each body), and the farthest corner
// along a direction. Tables are read and climbed in the precision that computes; the corners themselves are
// handed on in double, where single points are exact.
#pragma once

#include <algorithm>
#include <cmath>

#include "edgewise/algorithms/support.hpp"
#include "edgewise/geometry/pose.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/table/contract.hpp"

namespace edgewise::epa {

template <SupportTable TableA, SupportTable TableB>
struct Corner {
    typename TableA::Vertex vertex_a;
    typename TableB::Vertex vertex_b;
    Vec3d on_a, on_b;  ///< both in A's frame

    /// In the difference, times a power of two.
    [[nodiscard]] Vec3d point(double scale) const {
        Vec3d point = (on_a - on_b) * scale;
        for (int i = 0; i < 3; ++i) {
            if (std::abs(point[i]) < smallest_coordinate) point[i] = 0;
        }
        return point;
    }

    /// Longest coordinate: what rounding noise is relative to.
    [[nodiscard]] double size() const { return std::max(max_abs(on_a), max_abs(on_b)); }
};

template <SupportTable TableA, SupportTable TableB>
class Difference {
  public:
    using Scalar = ComputeOf<TableA>;
    using CornerType = Corner<TableA, TableB>;

    Difference(const TableA& a, const TableB& b, const Transform<Scalar>& a_from_b)
        : a_(a), b_(b), a_from_b_(a_from_b) {}

    [[nodiscard]] CornerType corner(typename TableA::Vertex a, typename TableB::Vertex b) const {
        return {a, b, cast<double>(Vec3<Scalar>(a_.vertex(a))), cast<double>(a_from_b_.point(b_.vertex(b)))};
    }

    [[nodiscard]] CornerType first() const { return corner(a_.first_vertex(), b_.first_vertex()); }

    /// The farthest corner along a direction of length about 1, climbed to from another corner.
    [[nodiscard]] CornerType support(const Vec3d& direction, const CornerType& from) const {
        const Vec3<Scalar> along = cast<Scalar>(direction);
        const Vec3<Scalar> along_b = -a_from_b_.direction_back(along);
        const auto a = edgewise::support(a_, along, from.vertex_a);
        const auto b = edgewise::support(b_, along_b, from.vertex_b);
        return {a.vertex, b.vertex, cast<double>(a.point), cast<double>(a_from_b_.point(b.point))};
    }

  private:
    const TableA& a_;
    const TableB& b_;
    const Transform<Scalar>& a_from_b_;
};

}  // namespace edgewise::epa
