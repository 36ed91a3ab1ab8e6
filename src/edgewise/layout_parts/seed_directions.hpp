// SPDX-License-Identifier: MIT
//
// Sets of directions, with a fast search for one near any direction: there a table looks up its first vertex
// (seeds.hpp). Each set has `count` directions, `direction(i)` of any length, and `place(direction)`, below
// `count` for every direction, also zero and infinite ones. A lookup takes comparisons, and for a grid on the
// cube one division; no square root, no angle.
//
//     CornerDirections      27: the axes, edges and corners of a cube (MuJoCo's "extrema"); the one in the
//                           middle is for no direction
//     RingDirections<7>     114, RingDirections<15> 482: rings of latitude and two poles (SWIFT's look-up
//                           tables)
//     GridDirections<16>    1536: a grid on each side of a cube (PhysX's "Gauss map")
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/table/small_array.hpp"

namespace edgewise {

struct CornerDirections {
    static constexpr std::size_t count = 27;

    [[nodiscard]] static Vec3d direction(Index i) {
        const int at = static_cast<int>(i);
        return {at / 9 - 1.0, at / 3 % 3 - 1.0, at % 3 - 1.0};
    }

    /// Cell of a direction. A component counts if it is beyond tan(pi / 8) of the longest, half way between
    /// an axis and a diagonal.
    template <class Scalar>
    [[nodiscard]] static Index place(const Vec3<Scalar>& direction) {
        const Scalar least = Scalar(0.41421356) * max_abs(direction);
        const auto third = [least](Scalar x) {
            return static_cast<int>(x > least) - static_cast<int>(x < -least);
        };
        return static_cast<Index>(13 + 9 * third(direction.x()) + 3 * third(direction.y()) +
                                  third(direction.z()));
    }
};

/// Both poles, then rings of latitude from south to north. The 2 (Rings + 1) directions of a ring have the
/// same angle between them as neighbouring rings; the equator is a ring.
template <int Rings>
class RingDirections {
    static_assert(Rings == 7 || Rings == 15);

  public:
    static constexpr int around = 2 * (Rings + 1);
    static constexpr std::size_t count = 2 + Rings * around;

    [[nodiscard]] static Vec3d direction(Index i) {
        if (i < 2) return {0, 0, i == 0 ? -1.0 : 1.0};
        const int ring = static_cast<int>(i - 2) / around - (quarter - 1);
        const int turn = static_cast<int>(i - 2) % around;
        const double level = sine(quarter - std::abs(ring)), up = sine(std::abs(ring));
        return {level * cosine_of_turn(turn), level * cosine_of_turn(turn + 3 * quarter),
                ring < 0 ? -up : up};
    }

    /// Counts the limits between rings, and between directions of a ring, that lie before this direction.
    template <class Scalar>
    [[nodiscard]] static Index place(const Vec3<Scalar>& direction) {
        const Scalar x = std::abs(direction.x()), y = std::abs(direction.y()), z = direction.z();
        const Scalar level = x * x + y * y, up = z * z;
        int ring = 0;
        for (int k = 0; k < quarter; ++k) ring += up > static_cast<Scalar>(limit(k) * limit(k)) * level;
        if (ring == quarter) return z < 0 ? 0 : 1;
        const Scalar least = std::min(x, y), most = std::max(x, y);
        int turn = 0;
        for (int k = 0; 2 * k + 1 < quarter; ++k) turn += least > static_cast<Scalar>(limit(k)) * most;
        if (y > x) turn = quarter - turn;
        if (direction.x() < 0) turn = 2 * quarter - turn;
        if (direction.y() < 0) turn = 4 * quarter - turn;
        const int north = quarter - 1 + (z < 0 ? -ring : ring);
        return static_cast<Index>(2 + north * around + turn % around);
    }

  private:
    /// Number of steps from the equator to a pole, and from one quarter of a ring to the next.
    static constexpr int quarter = (Rings + 1) / 2;

    /// Values of sin(k pi / 32).
    static constexpr SmallArray<double, 17> sines = {0,
                                                     0.098017140329560604,
                                                     0.19509032201612825,
                                                     0.29028467725446233,
                                                     0.38268343236508978,
                                                     0.47139673682599764,
                                                     0.55557023301960218,
                                                     0.63439328416364549,
                                                     0.70710678118654746,
                                                     0.77301045336273699,
                                                     0.83146961230254524,
                                                     0.88192126434835494,
                                                     0.92387953251128674,
                                                     0.95694033573220894,
                                                     0.98078528040323043,
                                                     0.99518472667219682,
                                                     1};
    static constexpr int per_step = 16 / quarter;

    [[nodiscard]] static constexpr double sine(int steps) { return sines[steps * per_step]; }
    /// Cosine of a turn of `steps` steps around a ring; any number of turns.
    [[nodiscard]] static double cosine_of_turn(int steps) {
        const int turn = steps % around,
                  back = turn > 2 * quarter ? around - turn : turn;  // 0 .. half a turn
        return back > quarter ? -sine(back - quarter) : sine(quarter - back);
    }
    /// The slope half way between step k and step k + 1.
    [[nodiscard]] static constexpr double limit(int k) {
        const int at = (2 * k + 1) * per_step / 2;
        return sines[at] / sines[16 - at];
    }
};

/// Directions to the middles of the cells of a Side x Side grid on each side of a cube.
template <int Side>
struct GridDirections {
    static constexpr std::size_t count = 6 * Side * Side;

    [[nodiscard]] static Vec3d direction(Index i) {
        const auto middle = [](Index cell) { return (2.0 * cell + 1) / Side - 1; };
        const Index side = i / (Side * Side);
        const int axis = static_cast<int>(side / 2);
        Vec3d result;
        result[axis] = side % 2 == 0 ? 1 : -1;
        result[(axis + 1) % 3] = middle(i / Side % Side);
        result[(axis + 2) % 3] = middle(i % Side);
        return result;
    }

    template <class Scalar>
    [[nodiscard]] static Index place(const Vec3<Scalar>& direction) {
        const Scalar x = std::abs(direction.x()), y = std::abs(direction.y()), z = std::abs(direction.z());
        const int axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
        const Scalar along = direction[axis];
        const Scalar cells = Scalar(Side / 2) / std::abs(along);
        const auto cell = [cells](Scalar across) {
            const Scalar at = across * cells + Scalar(Side / 2);
            // NaN, from a direction of zero or infinite length, goes to the first cell.
            return static_cast<Index>(at > 0 ? std::min(at, Scalar(Side - 1)) : Scalar(0));
        };
        const Index side = 2 * static_cast<Index>(axis) + (along < 0 ? 1 : 0);
        return (side * Side + cell(direction[(axis + 1) % 3])) * Side + cell(direction[(axis + 2) % 3]);
    }
};

}  // namespace edgewise
