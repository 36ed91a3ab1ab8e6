// SPDX-License-Identifier: MIT
//
// A body's vertices laid out for full scans: coordinate by coordinate, once per body, however many poses it
// is asked at.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "edgewise/geometry/vec.hpp"

namespace edgewise::truth {

/// A vertex that is highest along a direction, within the precision of double; ties go to the first.
struct Highest {
    std::uint32_t vertex = 0;
    double height = 0;
};

/// Not for two threads at once: a scan leaves its heights behind.
class ScannedBody {
  public:
    /// Needs finite coordinates and at least one vertex. Keeps the span.
    explicit ScannedBody(std::span<const Vec3d> vertices);

    /// Heights of all vertices along the direction, which must be finite: plain products and sums in the
    /// order of dot().
    [[nodiscard]] Highest highest(const Vec3d& along);

    /// The vertices of the last scan that were at least so high. Valid until the next call.
    [[nodiscard]] std::span<const std::uint32_t> as_high_as(double height);

    [[nodiscard]] const Vec3d& vertex(std::uint32_t i) const { return vertices_[i]; }
    [[nodiscard]] std::span<const Vec3d> vertices() const { return vertices_; }
    /// Largest |v|, and the diagonal of the vertices' box, as accuracy_band takes them.
    [[nodiscard]] double reach() const { return reach_; }
    [[nodiscard]] double extent() const { return extent_; }
    /// About the mean of the vertices.
    [[nodiscard]] const Vec3d& centre() const { return centre_; }

  private:
    std::span<const Vec3d> vertices_;
    /// Filled up with copies of the first vertex, to a multiple of four.
    std::vector<double> x_, y_, z_, heights_;
    std::vector<std::uint32_t> chosen_;
    double reach_ = 0, extent_ = 0;
    Vec3d centre_ = Vec3d::Zero();
};

}  // namespace edgewise::truth
