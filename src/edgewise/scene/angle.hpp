// SPDX-License-Identifier: MIT
//
// Sine and cosine of an angle without libm, because the last bits of libm differ between machines.
//
// The angle x is reduced by whole turns to [-pi, pi]; with t = tan(x/4), |t| <= 1, two half-angle steps give
//     tan(x/2) -> cos(x/2) = (1 - t^2)/(1 + t^2), sin(x/2) = 2t/(1 + t^2), and from them the turn itself.
// t comes from Lambert's continued fraction tan y = y/(1 - y^2/(3 - y^2/(5 - ...))), evaluated from the tail;
// at |y| <= pi/4 ten levels leave a remainder far below the rounding step. Only + - * / and floor are used.
//
// Accuracy: about 4e-16 absolute for |x| <= pi. Beyond, whole turns are taken off with 2 pi in three parts,
// the first two with 33 bits each, so that k * part is exact for up to 2^20 turns; larger angles are refused
// by assertion (no scene turns a body a million times in a step).
#pragma once

#include <cassert>
#include <cmath>

namespace edgewise::scene {

struct SineCosine {
    double sine, cosine;
};

/// The angle less whole turns, in [-pi, pi] up to rounding.
[[nodiscard]] inline double reduce_angle(double angle) {
    constexpr double turn = 0x1.921fb54442d18p+2;     // 2 pi
    constexpr double part_1 = 0x1.921fb544p+2;        // its first 33 bits
    constexpr double part_2 = 0x1.0b4611a6p-32;       // the next 33
    constexpr double part_3 = 0x1.3198a2e037073p-67;  // the rest, rounded
    const double turns = std::floor(angle / turn + 0.5);
    assert(std::abs(turns) <= 0x1p20);
    return ((angle - turns * part_1) - turns * part_2) - turns * part_3;
}

/// tan(y) for |y| <= pi/4 (a little beyond is harmless).
[[nodiscard]] inline double small_tangent(double y) {
    constexpr int levels = 10;
    const double square = y * y;
    double tail = 2 * levels + 1;
    for (int odd = 2 * levels - 1; odd >= 1; odd -= 2) tail = odd - square / tail;
    return y / tail;
}

/// Sine and cosine of half the angle, for a quaternion. A whole turn may flip both signs (same rotation).
[[nodiscard]] inline SineCosine half_angle_sine_cosine(double angle) {
    const double t = small_tangent(reduce_angle(angle) / 4);
    const double scale = 1 + t * t;
    return {2 * t / scale, (1 - t * t) / scale};
}

[[nodiscard]] inline SineCosine sine_cosine(double angle) {
    const SineCosine half = half_angle_sine_cosine(angle);
    return {2 * half.sine * half.cosine, (half.cosine - half.sine) * (half.cosine + half.sine)};
}

}  // namespace edgewise::scene
