// SPDX-License-Identifier: MIT
//
// A small array that any integer type can index. Loops over the points of a simplex use int, because they
// also shift bits by it, count down and index Eigen's vectors. std::array converts an int at each use, which
// may change its sign. Nothing else is different, and g++ generates the same code.
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
