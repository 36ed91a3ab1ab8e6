// SPDX-License-Identifier: MIT
//
// A few values whose places any whole number counts. What loops over the points of a simplex also shifts
// bits by, counts down and indexes Eigen's vectors with, is an int; std::array would convert it, which may
// change its sign, at each of its uses.
#pragma once

#include <concepts>
#include <cstddef>

namespace edgewise {

template <class Value, int count>
struct SmallArray {
    Value values[static_cast<std::size_t>(count)];

    [[nodiscard]] constexpr Value& operator[](std::integral auto i) { return values[i]; }
    [[nodiscard]] constexpr const Value& operator[](std::integral auto i) const { return values[i]; }

    [[nodiscard]] static constexpr std::size_t size() { return static_cast<std::size_t>(count); }
    [[nodiscard]] constexpr Value* data() { return values; }
    [[nodiscard]] constexpr const Value* data() const { return values; }
    [[nodiscard]] constexpr Value* begin() { return values; }
    [[nodiscard]] constexpr const Value* begin() const { return values; }
    [[nodiscard]] constexpr Value* end() { return values + count; }
    [[nodiscard]] constexpr const Value* end() const { return values + count; }
};

}  // namespace edgewise
