// SPDX-License-Identifier: MIT
//
// The part of Jolt's vectors and matrices that its adapter uses, written from the calls.
#pragma once

#include <cmath>

namespace JPH {

struct Vec3 {
    Vec3() = default;
    Vec3(float x, float y, float z) : mF32{x, y, z} {}
    float GetX() const { return mF32[0]; }
    float GetY() const { return mF32[1]; }
    float GetZ() const { return mF32[2]; }
    float Dot(const Vec3& v) const { return mF32[0] * v.mF32[0] + mF32[1] * v.mF32[1] + mF32[2] * v.mF32[2]; }
    bool IsNearZero() const { return Dot(*this) <= 1e-12f; }
    Vec3 operator-() const { return {-mF32[0], -mF32[1], -mF32[2]}; }
    Vec3 operator-(const Vec3& v) const { return *this + -v; }
    Vec3 operator+(const Vec3& v) const {
        return {mF32[0] + v.mF32[0], mF32[1] + v.mF32[1], mF32[2] + v.mF32[2]};
    }
    Vec3 operator*(float f) const { return {mF32[0] * f, mF32[1] * f, mF32[2] * f}; }
    bool operator==(const Vec3&) const = default;
    float mF32[3];
};
using Vec3Arg = const Vec3&;

struct Vec4 {
    Vec4() = default;
    Vec4(Vec3Arg v, float w) : xyz(v), mW(w) {}
    Vec3 xyz;
    float mW;
};

struct Mat44 {
    Mat44() = default;
    Mat44(Vec4 x, Vec4 y, Vec4 z, Vec3Arg t) : columns{x.xyz, y.xyz, z.xyz}, translation(t) {}
    Vec3 GetTranslation() const { return translation; }
    Vec3 Multiply3x3(Vec3Arg v) const {
        return columns[0] * v.GetX() + columns[1] * v.GetY() + columns[2] * v.GetZ();
    }
    Vec3 Multiply3x3Transposed(Vec3Arg v) const {
        return {columns[0].Dot(v), columns[1].Dot(v), columns[2].Dot(v)};
    }
    Vec3 operator*(Vec3Arg v) const { return Multiply3x3(v) + translation; }
    Mat44 operator*(const Mat44& m) const {
        const auto column = [&](int i) { return Vec4(Multiply3x3(m.columns[i]), 0); };
        return {column(0), column(1), column(2), *this * m.translation};
    }
    Mat44 InversedRotationTranslation() const {
        const auto row = [&](int i) {
            return Vec4({columns[0].mF32[i], columns[1].mF32[i], columns[2].mF32[i]}, 0);
        };
        return {row(0), row(1), row(2), -Multiply3x3Transposed(translation)};
    }
    Vec3 columns[3], translation;
};

}  // namespace JPH
