// SPDX-License-Identifier: MIT
//
// Numbers side by side, 32 bytes of them, as the compiler's own vector types: one text makes SSE, AVX or NEON
// of it. Wider ones g++ takes apart into single numbers where the machine lacks them. Used inside functions
// alone: no type that a user links is made of it, so that none depends on machine flags.
#pragma once

#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace edgewise {

template <class Scalar>
struct Pack {
    static constexpr int size = 32 / sizeof(Scalar);
    static_assert(size == 4 || size == 8);

    using Word = std::conditional_t<size == 4, std::int64_t, std::int32_t>;
    typedef Scalar Numbers __attribute__((vector_size(32)));
    /// What comparing two of them gives: all bits set where true.
    typedef Word Words __attribute__((vector_size(32)));

    /// From as many numbers in a row.
    template <class Stored>
    [[nodiscard]] [[gnu::always_inline]] static Numbers load(const Stored* first) {
        typedef Stored Row __attribute__((vector_size(size * sizeof(Stored))));
        Row row;
        std::memcpy(&row, first, sizeof(row));
        if constexpr (std::is_same_v<Stored, Scalar>)
            return row;
        else
            return __builtin_convertvector(row, Numbers);
    }

    /// 0, 1, 2 ...
    [[nodiscard]] [[gnu::always_inline]] static Words places() {
        if constexpr (size == 4)
            return Words{0, 1, 2, 3};
        else
            return Words{0, 1, 2, 3, 4, 5, 6, 7};
    }

    /// The highest, in every place.
    [[nodiscard]] [[gnu::always_inline]] static Numbers highest(const Numbers& of) {
        return fold(
            of,
            [](const Numbers& a, const Numbers& b) __attribute__((always_inline)) { return b > a ? b : a; });
    }

    /// The lowest of those that the mask tells; where it tells none, the largest number that there is.
    [[nodiscard]] [[gnu::always_inline]] static Word lowest(const Words& of, const Words& mask) {
        const Words told = mask ? of : Words{} + std::numeric_limits<Word>::max();
        return fold(
            told,
            [](const Words& a, const Words& b) __attribute__((always_inline)) { return b < a ? b : a; })[0];
    }

  private:
    /// All of them as one, in every place: halves, then pairs.
    template <class Vector, class Join>
    [[nodiscard]] [[gnu::always_inline]] static Vector fold(Vector of, const Join& join) {
        if constexpr (size == 4) {
            of = join(of, __builtin_shufflevector(of, of, 2, 3, 0, 1));
            return join(of, __builtin_shufflevector(of, of, 1, 0, 3, 2));
        } else {
            of = join(of, __builtin_shufflevector(of, of, 4, 5, 6, 7, 0, 1, 2, 3));
            of = join(of, __builtin_shufflevector(of, of, 2, 3, 0, 1, 6, 7, 4, 5));
            return join(of, __builtin_shufflevector(of, of, 1, 0, 3, 2, 5, 4, 7, 6));
        }
    }
};

}  // namespace edgewise
