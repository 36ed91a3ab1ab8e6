// SPDX-License-Identifier: MIT
//
// Numbers of eight queries side by side: lane i of every register belongs to query i. The compiler's own
// vector types. Every operation is that of the scalar code, lane by lane, in the order of geometry/vec.hpp:
// the same bits.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

namespace edgewise {

/// Registers of n numbers, and the results of comparing two of them: all bits set where true. Whole numbers
/// per lane have the masks' type.
template <int n>
using Numbers [[gnu::vector_size(n * sizeof(float))]] = float;
template <int n>
using Masks [[gnu::vector_size(n * sizeof(float))]] = std::int32_t;

inline constexpr int lane_count = 8;
using Eight = Numbers<lane_count>;
using EightWords = Masks<lane_count>;

/// A 3D vector per lane.
struct LaneVec {
    Eight x, y, z;

    [[gnu::always_inline]] friend LaneVec operator-(const LaneVec& a, const LaneVec& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    [[gnu::always_inline]] friend LaneVec operator+(const LaneVec& a, const LaneVec& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    [[gnu::always_inline]] friend LaneVec operator-(const LaneVec& a) { return {-a.x, -a.y, -a.z}; }
    [[gnu::always_inline]] friend LaneVec operator*(const Eight& s, const LaneVec& a) {
        return {s * a.x, s * a.y, s * a.z};
    }

    [[gnu::always_inline]] void set(int lane, float at_x, float at_y, float at_z) {
        x[lane] = at_x;
        y[lane] = at_y;
        z[lane] = at_z;
    }
};

[[nodiscard, gnu::always_inline]] inline Eight dot(const LaneVec& a, const LaneVec& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[nodiscard, gnu::always_inline]] inline Eight squared_norm(const LaneVec& a) { return dot(a, a); }

/// Returns a where the mask is set, else b.
[[nodiscard, gnu::always_inline]] inline LaneVec select(const EightWords& mask, const LaneVec& a,
                                                        const LaneVec& b) {
    return {mask ? a.x : b.x, mask ? a.y : b.y, mask ? a.z : b.z};
}

/// Largest absolute component.
[[nodiscard, gnu::always_inline]] inline Eight max_abs(const LaneVec& v) {
    const auto size = [](const Eight& of) __attribute__((always_inline)) {
        return (Eight)((EightWords)of & std::numeric_limits<std::int32_t>::max());
    };
    const Eight x = size(v.x), y = size(v.y), z = size(v.z), larger = x < y ? y : x;
    return larger < z ? z : larger;
}

[[nodiscard, gnu::always_inline]] inline Eight square_root(Eight of) {
    for (int i = 0; i < lane_count; ++i) of[i] = std::sqrt(of[i]);
    return of;
}

/// The lanes' masks, a bit each: lane 0 is the lowest.
[[nodiscard, gnu::always_inline]] inline unsigned lane_bits(const EightWords& mask) {
    const EightWords bits = mask & EightWords{1, 2, 4, 8, 16, 32, 64, 128};
    auto half =
        __builtin_shufflevector(bits, bits, 0, 1, 2, 3) | __builtin_shufflevector(bits, bits, 4, 5, 6, 7);
    half |= __builtin_shufflevector(half, half, 2, 3, 2, 3);
    return static_cast<unsigned>(half[0] | half[1]);
}

}  // namespace edgewise
