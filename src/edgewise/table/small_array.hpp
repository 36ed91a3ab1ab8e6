// SPDX-License-Identifier: MIT
//
// A few values whose places any whole number counts. What loops over the points of a simplex also shifts
// bits by, counts down and indexes Eigen's vectors with, is an int; std::array has it converted, which may
// change its sign, at each of its uses. Nothing else is different, and g++ makes the same code of it.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>

namespace edgewise {

template <class Value, int count>
struct SmallArray : std::array<Value, static_cast<std::size_t>(count)> {
    using Base = std::array<Value, static_cast<std::size_t>(count)>;

    [[nodiscard]] constexpr Value& operator[](std::integral auto i) {
        return Base::operator[](static_cast<std::size_t>(i));
    }
    [[nodiscard]] constexpr const Value& operator[](std::integral auto i) const {
        return Base::operator[](static_cast<std::size_t>(i));
    }
};

}  // namespace edgewise
