// SPDX-License-Identifier: MIT
//
// The seeded random numbers of every scene: xoshiro256** (Blackman and Vigna, "Scrambled linear pseudorandom
// number generators", 2018), its state filled by SplitMix64 as its authors advise.
//
// Own code instead of <random>: the standard fixes its engines but not its distributions, so the same seed
// gives other poses with another standard library. Here everything is integer arithmetic and + - * / sqrt:
// the same bits everywhere. Numbers are drawn one statement each, because C++ does not order function
// arguments.
#pragma once

#include <array>
#include <bit>
#include <cassert>
#include <cstdint>
#include <utility>

#include "edgewise/geometry/split_mix.hpp"
#include "edgewise/geometry/vec.hpp"
#include "edgewise/scene/quaternion.hpp"

namespace edgewise::scene {

class Rng {
  public:
    explicit Rng(std::uint64_t seed) {
        for (std::uint64_t& word : state_) word = split_mix(seed);
    }

    /// 64 random bits.
    [[nodiscard]] std::uint64_t next() {
        const std::uint64_t result = std::rotl(state_[1] * 5, 7) * 9;
        const std::uint64_t shifted = state_[1] << 17;
        state_[2] ^= state_[0];
        state_[3] ^= state_[1];
        state_[1] ^= state_[2];
        state_[0] ^= state_[3];
        state_[2] ^= shifted;
        state_[3] = std::rotl(state_[3], 45);
        return result;
    }

    /// Returns a number in [0, 1), from the top 53 bits: a multiple of 2^-53, without rounding.
    [[nodiscard]] double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }

    /// Returns a number in [low, high); rounding may give high itself.
    [[nodiscard]] double uniform(double low, double high) { return low + (high - low) * uniform(); }

    /// Returns a whole number below n, each equally likely; rejects draws from the incomplete last block.
    [[nodiscard]] std::uint64_t below(std::uint64_t n) {
        assert(n > 0);
        const std::uint64_t surplus = (0 - n) % n;  // 2^64 mod n
        for (;;) {
            const std::uint64_t bits = next();
            if (bits >= surplus) return bits % n;
        }
    }

    /// Every order of the items equally likely (Fisher and Yates).
    template <class Items>
    void shuffle(Items& items) {
        for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[below(i)]);
    }

    /// Uniform in the cube [-half, half]^3.
    [[nodiscard]] Vec3d in_cube(double half) {
        const double x = uniform(-half, half);
        const double y = uniform(-half, half);
        const double z = uniform(-half, half);
        return {x, y, z};
    }

    /// Uniform in the unit ball, by rejection (about two draws of three coordinates).
    [[nodiscard]] Vec3d in_ball() {
        for (;;) {
            const Vec3d point = in_cube(1);
            if (squared_norm(point) <= 1) return point;
        }
    }

    /// Uniform on the unit sphere. Points of the inner quarter are drawn again: scaling them up
    /// would magnify their rounding.
    [[nodiscard]] Vec3d on_sphere() {
        for (;;) {
            const Vec3d point = in_ball();
            const double length = norm(point);
            if (length > 0.25) return point / length;
        }
    }

    /// Uniform among the rotations: a point of the 4-D ball, scaled to a unit quaternion.
    [[nodiscard]] Quaternion orientation() {
        for (;;) {
            Quaternion q;
            q.w = uniform(-1, 1);
            q.x = uniform(-1, 1);
            q.y = uniform(-1, 1);
            q.z = uniform(-1, 1);
            const double square = squared_norm(q);
            if (square <= 1 && square > 0.0625) return normalised(q);
        }
    }

    [[nodiscard]] Mat3d rotation() { return rotation_matrix(orientation()); }

  private:
    std::array<std::uint64_t, 4> state_;
};

}  // namespace edgewise::scene
