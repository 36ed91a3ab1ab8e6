// SPDX-License-Identifier: MIT
//
// A view of a table with the body stretched along its axes. The view stores only the three factors; instances
// of a shape at any number of scales share one table and one build.
//
// The body of a view is the hull of the points S p, where each coordinate is a product of a factor and a
// stored coordinate, rounded to what the table computes in. It is not the hull of the exact products: so it
// is a body like any other, and an oracle can compute its exact distances.
//
// Queries may climb on the view as on the table, because <S p, d> = <p, S d>. A vertex is the highest of the
// stretched body along d if and only if it is the highest of the body along S d. There every other vertex has
// a higher neighbour. Rounding adds to a height half a rounding step of each of three products, which is
// within what climbs allow (tolerance.hpp, level: 49 of 64), of the view's reach.
//
// For GJK only. V-Clip's planes through an edge are perpendicular to it, and to its faces: a stretch keeps
// neither right angle, so they are not the images of the table's planes. (The image of a face's plane is one:
// its normal times the inverse of S.) Build a table of the stretched body, or refit one (write_geometry.hpp),
// for V-Clip.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/table/contract.hpp"

namespace edgewise {

/// Borrows the table, which must outlive it; a temporary one does not compile. Meets SupportTable, and
/// ClimbingTable where the table does.
template <SupportTable Table>
class ScaledTable {
  public:
    using PrecisionType = typename Table::PrecisionType;
    using Compute = ComputeOf<Table>;
    using Vertex = typename Table::Vertex;
    static constexpr bool counts_vertices = requires { requires Table::counts_vertices; };

    /// `scale`: a factor for each of the body's axes, finite and not 0; a negative one mirrors. If the scale
    /// is invalid, or coordinates leave the range of bodies, every query of the view fails (Status::failed).
    ScaledTable(const Table& table, const Vec3d& scale)
        : table_(&table), scale_(cast<Compute>(scale)), is_in_range_(holds(table, scale)) {}
    ScaledTable(const Table&&, const Vec3d&) = delete;

    [[nodiscard]] bool is_in_range() const { return is_in_range_; }

    [[nodiscard]] Vertex first_vertex() const { return table_->first_vertex(); }
    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const {
        const Vec3<Compute> point = table_->vertex(v);
        return {scale_.x() * point.x(), scale_.y() * point.y(), scale_.z() * point.z()};
    }
    [[nodiscard]] auto all_vertices() const { return table_->all_vertices(); }

    [[nodiscard]] std::size_t vertex_count() const requires ClimbingTable<Table> {
        return table_->vertex_count();
    }
    [[nodiscard]] auto neighbours(Vertex v) const requires ClimbingTable<Table> {
        return table_->neighbours(v);
    }
    /// Always false: a stretch changes angles, so algorithms may not rely on them.
    [[nodiscard]] bool strictly_convex() const requires ClimbingTable<Table> { return false; }
    [[nodiscard]] bool climbable() const requires ClimbingTable<Table> {
        if constexpr (requires { table_->climbable(); })
            return table_->climbable();
        else
            return table_->strictly_convex();
    }
    [[nodiscard]] double reach() const requires requires(const Table& table) { table.reach(); }
    { return static_cast<double>(max_abs(scale_)) * table_->reach(); }
    /// Identity of the table: its vertices are vertices of the view, at every scale.
    [[nodiscard]] std::uint32_t identity() const requires requires(const Table& table) { table.identity(); }
    { return table_->identity(); }

    [[nodiscard]] const Vec3<Compute>& scale() const { return scale_; }

  private:
    [[nodiscard]] static bool holds(const Table& table, const Vec3d& scale) {
        constexpr bool is_single = std::is_same_v<Compute, float>;
        constexpr double largest = is_single ? largest_coordinate_single : largest_coordinate;
        constexpr double smallest = is_single ? smallest_extent_single : smallest_extent;
        const Vec3d factor = scale.cwiseAbs();
        const double most = reach_of(table);
        return scale.array().isFinite().all() && factor.minCoeff() > 0 &&
               (most == 0 || (factor.minCoeff() * most >= smallest && factor.maxCoeff() * most <= largest));
    }
    [[nodiscard]] static double reach_of(const Table& table) {
        if constexpr (requires { table.reach(); }) {
            return table.reach();
        } else {
            double most = 0;
            for (const auto v : table.all_vertices()) most = std::max(most, double{max_abs(table.vertex(v))});
            return most;
        }
    }

    const Table* table_;
    Vec3<Compute> scale_;
    bool is_in_range_;
};

}  // namespace edgewise
