// SPDX-License-Identifier: MIT
//
// The one definition of a relative pose that can be answered, for queries, batches, bounds and penetration:
// finite, a proper rotation to within sloppiest_rotation, and so short that its square does not overflow. The
// answer to any other pose would be a distance of NaN, or a contact that does not exist; such a query fails
// (Status::failed) and leaves its pair unchanged. Some fifty operations, no division and no branch except the
// last.
#pragma once

#include <cmath>
#include <type_traits>

#include "edgewise/geometry/pose.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/table/contract.hpp"

namespace edgewise {

/// Squared distance of R from a proper rotation: by columns x, y, z, the sum of the squares of |x|^2 - 1 and
/// |y|^2 - 1, and twice those of x . y and z - x * y. About the sum of the squares of all entries of R^T R -
/// I, but 8 for a mirror image; NaN where an entry of R is NaN.
template <class Scalar>
[[nodiscard]] Scalar squared_rotation_error(const Mat3<Scalar>& r) {
    const auto x = r.col(0), y = r.col(1), z = r.col(2);
    const Scalar xx = dot(x, x) - 1, yy = dot(y, y) - 1, xy = dot(x, y);
    // Component by component: a whole difference waits for a whole product to pass through memory.
    const Scalar along_x = z.x() - (x.y() * y.z() - x.z() * y.y()),
                 along_y = z.y() - (x.z() * y.x() - x.x() * y.z()),
                 along_z = z.z() - (x.x() * y.y() - x.y() * y.x());
    return xx * xx + yy * yy + 2 * (xy * xy + along_x * along_x + along_y * along_y + along_z * along_z);
}

/// Returns true if the pose has at most this squared distance from a rotation, and is so short that a query
/// in Scalar can answer it.
template <class Scalar>
[[nodiscard]] bool is_within(const Transform<double>& a_from_b, double squared_error) {
    const Vec3d& t = a_from_b.translation;
    const double offset = std::abs(t.x()) + std::abs(t.y()) + std::abs(t.z());
    return squared_rotation_error(a_from_b.rotation) <= squared_error &&
           offset <= static_cast<double>(Tolerance<Scalar>::largest_offset);
}

/// Returns true if the pose can be answered by a query that computes in Scalar.
template <class Scalar>
[[nodiscard]] bool is_answerable(const Transform<double>& a_from_b) {
    return is_within<Scalar>(a_from_b, sloppiest_rotation * sloppiest_rotation);
}

/// Returns false for a table with numbers that no query can compute with: a view at such a scale
/// (table/scaled_table.hpp). Other tables are built from bodies in range.
template <class Table>
[[nodiscard]] bool is_in_range(const Table& table) {
    if constexpr (requires { table.is_in_range(); })
        return table.is_in_range();
    else
        return true;
}

/// Stops the compiler, with one line, where two tables compute in different scalars.
template <class TableA, class TableB>
[[nodiscard]] constexpr bool compute_alike() {
    constexpr bool alike = std::is_same_v<ComputeOf<TableA>, ComputeOf<TableB>>;
    static_assert(alike,
                  "both tables of a query must compute in one precision: aos<f32> with lean<f32>, and "
                  "aos<mixed>, which computes in double, with lean<f64>");
    return alike;
}

/// Returns true if tables and pose can be answered; every query checks this first.
template <class TableA, class TableB>
[[nodiscard]] bool is_answerable(const TableA& a, const TableB& b, const Transform<double>& a_from_b) {
    return is_answerable<ComputeOf<TableA>>(a_from_b) && is_in_range(a) && is_in_range(b);
}

}  // namespace edgewise
