// SPDX-License-Identifier: MIT
//
// The Minkowski difference A - B as EPA sees it: corners (a vertex of each body), and the farthest corner
// along a direction. Tables are read and climbed in the precision that computes; the corners are passed on in
// double, where single points are exact. EPA is compiled once, without table types: a call per support point
// costs little compared with the climb.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "edgewise/algorithms/support.hpp"
#include "edgewise/geometry/pose.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/table/contract.hpp"

namespace edgewise::epa {

/// A table's handle of a vertex, whatever its type.
using AnyVertex = std::uint64_t;

struct Corner {
    AnyVertex vertex_a, vertex_b;
    Vec3d on_a, on_b;  ///< both in A's frame

    /// Point of the difference, times a power of two.
    [[nodiscard]] Vec3d point(double scale) const {
        Vec3d point = (on_a - on_b) * scale;
        for (int i = 0; i < 3; ++i) {
            if (std::abs(point[i]) < smallest_coordinate) point[i] = 0;
        }
        return point;
    }

    /// Longest coordinate: rounding noise is relative to it.
    [[nodiscard]] double size() const { return std::max(max_abs(on_a), max_abs(on_b)); }
};

class Difference {
  public:
    Difference() = default;
    Difference(const Difference&) = delete;
    Difference& operator=(const Difference&) = delete;
    virtual ~Difference() = default;

    /// The farthest corner along a direction of length about 1, climbed to from another corner.
    [[nodiscard]] virtual Corner support(const Vec3d& direction, const Corner& from) const = 0;
    /// Rounding noise of the support products, relative to the size.
    [[nodiscard]] virtual double support_noise() const = 0;
};

/// Bytes of a handle; by an array, because sizeof of a pointer type draws a warning.
template <class Vertex>
inline constexpr std::size_t vertex_bytes = sizeof(std::array<Vertex, 1>);

template <class Vertex>
[[nodiscard]] AnyVertex any_vertex(const Vertex& vertex) {
    static_assert(std::is_trivially_copyable_v<Vertex> && vertex_bytes<Vertex> <= sizeof(AnyVertex),
                  "a depth asks for handles that are copied as bytes, eight at most");
    AnyVertex any = 0;
    std::memcpy(&any, &vertex, vertex_bytes<Vertex>);
    return any;
}

template <class Vertex>
[[nodiscard]] Vertex vertex_from(AnyVertex any) {
    Vertex vertex;
    std::memcpy(&vertex, &any, vertex_bytes<Vertex>);
    return vertex;
}

template <SupportTable TableA, SupportTable TableB>
class DifferenceOf final : public Difference {
  public:
    using Scalar = ComputeOf<TableA>;

    /// Keeps all three arguments.
    DifferenceOf(const TableA& a, const TableB& b, const Transform<Scalar>& a_from_b)
        : a_(a), b_(b), a_from_b_(a_from_b) {}

    [[nodiscard]] Corner corner(typename TableA::Vertex a, typename TableB::Vertex b) const {
        return corner_at(a, a_.vertex(a), b, b_.vertex(b));
    }

    [[nodiscard]] Corner support(const Vec3d& direction, const Corner& from) const override {
        const Vec3<Scalar> along = cast<Scalar>(direction);
        const Vec3<Scalar> along_b = -a_from_b_.direction_back(along);
        const auto a = edgewise::support(a_, along, vertex_from<typename TableA::Vertex>(from.vertex_a));
        const auto b = edgewise::support(b_, along_b, vertex_from<typename TableB::Vertex>(from.vertex_b));
        return corner_at(a.vertex, a.point, b.vertex, b.point);
    }

    [[nodiscard]] double support_noise() const override {
        return static_cast<double>(Tolerance<Scalar>::support_noise);
    }

  private:
    [[nodiscard]] Corner corner_at(typename TableA::Vertex a, const Vec3<Scalar>& point_a,
                                   typename TableB::Vertex b, const Vec3<Scalar>& point_b) const {
        return {any_vertex(a), any_vertex(b), cast<double>(point_a), cast<double>(a_from_b_.point(point_b))};
    }

    const TableA& a_;
    const TableB& b_;
    const Transform<Scalar>& a_from_b_;
};

}  // namespace edgewise::epa
