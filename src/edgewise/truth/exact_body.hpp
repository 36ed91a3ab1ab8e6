// SPDX-License-Identifier: MIT
//
// A body in the world, exactly: the vertices R v + t as integers in units of one power of two. Each is
// computed when it is first asked for; most never are.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <vector>

#include "edgewise/geometry/pose.hpp"
#include "edgewise/truth/integer_vector.hpp"
#include "edgewise/truth/minimum_norm.hpp"
#include "edgewise/truth/support_filter.hpp"

namespace edgewise::truth {

/// One line that says what exact arithmetic cannot take of a pair of bodies: none, NaN, infinity; empty if
/// nothing is wrong.
[[nodiscard]] std::string pair_error(std::span<const Vec3d> a, const Pose& pose_a, std::span<const Vec3d> b,
                                     const Pose& pose_b);

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
