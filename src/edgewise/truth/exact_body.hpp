// SPDX-License-Identifier: MIT
//
// A body in the world, exactly: the vertices R v + t as integers in units of one power of two. Each is
// computed when it is first asked for; most never are. A filter in double keeps exact support to the few
// vertices that can be the lowest.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <vector>

#include "edgewise/geometry/pose.hpp"
#include "edgewise/truth/filter/scanned_body.hpp"
#include "edgewise/truth/integer_vector.hpp"
#include "edgewise/truth/minimum_norm.hpp"

namespace edgewise::truth {

/// One line that says what exact arithmetic cannot take of a pair of bodies: none, NaN, infinity; empty if
/// nothing is wrong.
[[nodiscard]] std::string pair_error(std::span<const Vec3d> a, const Pose& pose_a, std::span<const Vec3d> b,
                                     const Pose& pose_b);

/// Which vertices can be the lowest along a direction? A scan in double that never loses the true one. A
/// body's own extreme vertex does not depend on where the body is, so the filter works on R (v - v0): a
/// far-off origin, in the pose or in the vertices, costs it no digits.
class SupportFilter {
  public:
    SupportFilter(std::span<const Vec3d> vertices, const Mat3d& rotation)
        : shapes_(shapes_of(vertices, rotation)), scanned_(shapes_) {}
    SupportFilter(SupportFilter&&) = default;

    /// False if the coordinates overflowed: then every vertex is a candidate.
    [[nodiscard]] bool usable() const { return usable_; }

    /// R (v - v0) of a vertex, divided by 2^exponent(): entries below 12.
    [[nodiscard]] const Vec3d& shape(std::uint32_t i) const { return shapes_[i]; }
    [[nodiscard]] int exponent() const { return exponent_; }

    /// The vertex that looks lowest along the direction; ties go to the first.
    [[nodiscard]] std::uint32_t lowest(const Vec3d& direction) { return scanned_.highest(-direction).vertex; }

    /// Returns every vertex that can be exactly lowest along a direction with entries of at most 1, known to
    /// 2^-52 (see rounded_direction). Valid until the next call.
    [[nodiscard]] std::span<const std::uint32_t> candidates(const Vec3d& direction);

  private:
    /// Sets exponent_ and usable_; zeros if the coordinates overflowed.
    [[nodiscard]] std::vector<Vec3d> shapes_of(std::span<const Vec3d> vertices, const Mat3d& rotation);

    int exponent_ = 0;
    bool usable_ = true;
    std::vector<Vec3d> shapes_;
    ScannedBody scanned_;  ///< of shapes_
};

/// The direction scaled by a power of two so that its largest entry is in [0.5, 1), truncated to double.
[[nodiscard]] Vec3d rounded_direction(const IntegerVec& direction);

class ExactBody {
  public:
    /// The largest exponent e for which every world coordinate is a whole number of 2^e, term by term.
    [[nodiscard]] static long unit_exponent(std::span<const Vec3d> vertices, const Pose& pose);

    /// Needs finite numbers and at least one vertex; unit at most unit_exponent of the same arguments. Keeps
    /// the span.
    ExactBody(std::span<const Vec3d> vertices, const Pose& pose, long unit);

    /// World position of a vertex in units.
    [[nodiscard]] const IntegerVec& world(std::uint32_t i);

    /// The vertex with the least direction.world, exactly; ties go to the first.
    [[nodiscard]] std::uint32_t lowest(const IntegerVec& direction);

    [[nodiscard]] SupportFilter& filter() { return filter_; }
    [[nodiscard]] std::size_t size() const { return vertices_.size(); }

  private:
    static constexpr std::uint32_t not_yet = ~std::uint32_t{0};

    std::span<const Vec3d> vertices_;
    SupportFilter filter_;
    std::array<IntegerVec, 3> row_;  ///< R in units of 2^(unit - vertex_unit_)
    IntegerVec translation_;
    long vertex_unit_ = 0;
    std::vector<std::uint32_t> slot_;
    std::deque<IntegerVec> world_;  ///< a deque, so that references stay valid
};

/// The lowest point of A - B along a direction.
struct LowestPoint {
    VertexPair pair;
    IntegerVec point;
    mpz_class height;
};

struct ExactPair {
    long unit;  ///< exponent of the common unit; at most 0
    ExactBody a, b;

    ExactPair(std::span<const Vec3d> vertices_a, const Pose& pose_a, std::span<const Vec3d> vertices_b,
              const Pose& pose_b);

    [[nodiscard]] IntegerVec difference(VertexPair pair);
    [[nodiscard]] LowestPoint lowest(const IntegerVec& direction);
};

/// Up to four points of A - B by their vertices. Also handed out with an answer, as the start of the next
/// query of the same two bodies.
struct SimplexSeed {
    std::array<VertexPair, 4> pair{};
    int size = 0;
};

/// A first guess at the simplex that carries the answer, by GJK in plain double precision. It decides
/// nothing: a good guess only saves exact iterations. Never empty. Starts from `start` where that names
/// vertices the bodies have.
[[nodiscard]] SimplexSeed seed_simplex(ExactPair& bodies, const SimplexSeed& start);

}  // namespace edgewise::truth
