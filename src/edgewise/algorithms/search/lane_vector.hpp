// SPDX-License-Identifier: MIT
//
// Numbers of several queries side by side: lane i of every register belongs to query i. The compiler's own
// vector types: the same source becomes SSE, AVX or NEON. Every operation is that of the scalar code, lane by
// lane, in the order of geometry/vec.hpp: the same bits.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace edgewise {

/// Registers of n numbers, and the results of comparing two of them: all bits set where true. Whole numbers
/// per lane have the masks' type.
template <class Scalar, int n>
struct LaneTypes {
    using Word = std::conditional_t<sizeof(Scalar) == 8, std::int64_t, std::int32_t>;
    typedef Scalar Numbers __attribute__((vector_size(n * sizeof(Scalar))));
    typedef Word Masks __attribute__((vector_size(n * sizeof(Scalar))));
};
template <class Scalar, int n>
using Numbers = typename LaneTypes<Scalar, n>::Numbers;
template <class Scalar, int n>
using Masks = typename LaneTypes<Scalar, n>::Masks;

/// A 3D vector per lane.
template <class Scalar, int n>
struct LaneVec {
    Numbers<Scalar, n> x, y, z;

    [[gnu::always_inline]] friend LaneVec operator-(const LaneVec& a, const LaneVec& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    [[gnu::always_inline]] friend LaneVec operator+(const LaneVec& a, const LaneVec& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    [[gnu::always_inline]] friend LaneVec operator-(const LaneVec& a) { return {-a.x, -a.y, -a.z}; }
    [[gnu::always_inline]] friend LaneVec operator*(const Numbers<Scalar, n>& s, const LaneVec& a) {
        return {s * a.x, s * a.y, s * a.z};
    }

    [[gnu::always_inline]] void set(int lane, Scalar at_x, Scalar at_y, Scalar at_z) {
        x[lane] = at_x;
        y[lane] = at_y;
        z[lane] = at_z;
    }
};

template <class Scalar, int n>
[[nodiscard]] [[gnu::always_inline]] inline Numbers<Scalar, n> dot(const LaneVec<Scalar, n>& a,
                                                                   const LaneVec<Scalar, n>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Scalar, int n>
[[nodiscard]] [[gnu::always_inline]] inline Numbers<Scalar, n> squared_norm(const LaneVec<Scalar, n>& a) {
    return dot(a, a);
}

template <class Scalar, int n>
[[nodiscard]] [[gnu::always_inline]] inline LaneVec<Scalar, n> cross(const LaneVec<Scalar, n>& a,
                                                                     const LaneVec<Scalar, n>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Returns a where the mask is set, else b; for numbers or whole numbers.
template <class Mask, class Number>
requires(sizeof(Mask) == sizeof(Number)) [[nodiscard]] [[gnu::always_inline]] inline Number
    select(const Mask& mask, const Number& a, const Number& b) {
    return mask ? a : b;
}
template <class Mask, class Scalar, int n>
[[nodiscard]] [[gnu::always_inline]] inline LaneVec<Scalar, n> select(const Mask& mask,
                                                                      const LaneVec<Scalar, n>& a,
                                                                      const LaneVec<Scalar, n>& b) {
    return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
}

/// The larger of two, lane by lane, as std::max chooses.
template <class Number>
[[nodiscard]] [[gnu::always_inline]] inline Number larger(const Number& a, const Number& b) {
    return select(a < b, b, a);
}

/// Largest absolute component.
template <class Scalar, int n>
[[nodiscard]] [[gnu::always_inline]] inline Numbers<Scalar, n> max_abs(const LaneVec<Scalar, n>& v) {
    const Masks<Scalar, n> rest =
        Masks<Scalar, n>{} + std::numeric_limits<typename LaneTypes<Scalar, n>::Word>::max();
    const auto size = [&](const Numbers<Scalar, n>& of) __attribute__((always_inline)) {
        return (Numbers<Scalar, n>)((Masks<Scalar, n>)of & rest);
    };
    return larger(larger(size(v.x), size(v.y)), size(v.z));
}

template <class Scalar, int n>
[[nodiscard]] [[gnu::always_inline]] inline Numbers<Scalar, n> square_root(Numbers<Scalar, n> of) {
    for (int i = 0; i < n; ++i) of[i] = std::sqrt(of[i]);
    return of;
}

/// Returns true if any lane's mask is set.
template <class Mask>
[[nodiscard]] [[gnu::always_inline]] inline bool any_lane(const Mask& mask) {
    constexpr int n = sizeof(Mask) / sizeof(mask[0]);
    std::remove_cvref_t<decltype(mask[0])> all = 0;
#pragma GCC unroll 16
    for (int i = 0; i < n; ++i) all |= mask[i];
    return all != 0;
}

}  // namespace edgewise
