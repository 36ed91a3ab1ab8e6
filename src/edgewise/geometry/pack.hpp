// SPDX-License-Identifier: MIT
//
// A pack has the numbers that fit one vector register of the target, in the compiler's own vector types: the
// same source becomes AVX, SSE or NEON. g++ splits comparisons of wider vectors into single numbers. Packs
// are used inside functions only: no type that a user links contains one, so that no such type depends on
// machine flags.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace edgewise {

/// Bytes of a vector register of the target that compares all its numbers at once; 0: it has none.
#if defined(__AVX__)
inline constexpr int pack_bytes = 32;
#elif defined(__SSE2__) || defined(__ARM_NEON)
inline constexpr int pack_bytes = 16;
#else
inline constexpr int pack_bytes = 0;
#endif

/// Returns true if the processor compares all numbers of 32 bytes at once, though this build's flags are for
/// processors that do not.
[[nodiscard]] inline bool has_wider_packs() {
#ifdef __x86_64__
    return pack_bytes < 32 && __builtin_cpu_supports("avx2");
#else
    return false;
#endif
}

template <class Scalar, int bytes = std::max(pack_bytes, 16)>
struct Pack {
    static constexpr int size = bytes / int{sizeof(Scalar)};
    static_assert(size == 2 || size == 4 || size == 8);

    using Word = std::conditional_t<sizeof(Scalar) == 8, std::int64_t, std::int32_t>;
    typedef Scalar Numbers __attribute__((vector_size(bytes)));
    /// Result of a comparison of two of them: all bits set where true.
    typedef Word Words __attribute__((vector_size(bytes)));

    // Results go to a reference of the caller: returning a vector register differs from machine to machine.

    /// Loads consecutive numbers, one for each lane.
    template <class Stored>
    [[gnu::always_inline]] static void load(const Stored* first, Numbers& to) {
        typedef Stored Row __attribute__((vector_size(size * sizeof(Stored))));
        Row row;
        std::memcpy(&row, first, sizeof(row));
        if constexpr (std::is_same_v<Stored, Scalar>)
            to = row;
        else
            to = __builtin_convertvector(row, Numbers);
    }

    /// Fills the lanes with make(0), make(1) ...
    template <class Vector, class Make>
    [[gnu::always_inline]] static void fill(const Make& make, Vector& to) {
        if constexpr (size == 2)
            to = Vector{make(0), make(1)};
        else if constexpr (size == 4)
            to = Vector{make(0), make(1), make(2), make(3)};
        else
            to = Vector{make(0), make(1), make(2), make(3), make(4), make(5), make(6), make(7)};
    }

    /// Fills the lanes with first, first + 1 ...
    [[gnu::always_inline]] static void count_from(Word first, Words& to) {
        fill(
            [](Word lane) __attribute__((always_inline)) { return lane; }, to);
        to += first;
    }

    /// Returns the greatest of the lanes' numbers.
    [[nodiscard]] [[gnu::always_inline]] static Scalar greatest(const Numbers& of) {
        Numbers numbers = of;
        fold(
            numbers, [](auto& a, const auto& b) __attribute__((always_inline)) { a = b > a ? b : a; });
        return numbers[0];
    }

    /// Returns the lowest `where` among the lanes that hold the highest number. Returns the largest word that
    /// there is if a number is NaN.
    [[nodiscard]] [[gnu::always_inline]] static Word first_of_highest(const Numbers& numbers,
                                                                      const Words& where) {
        Words first = numbers == greatest(numbers) ? where : Words{} + std::numeric_limits<Word>::max();
        fold(
            first, [](auto& a, const auto& b) __attribute__((always_inline)) { a = b < a ? b : a; });
        return first[0];
    }

  private:
    /// Joins all lanes and puts the result into every lane: halves first, then pairs.
    template <class Vector, class Join>
    [[gnu::always_inline]] static void fold(Vector& of, const Join& join) {
        if constexpr (size == 8) join(of, __builtin_shufflevector(of, of, 4, 5, 6, 7, 0, 1, 2, 3));
        if constexpr (size == 8) join(of, __builtin_shufflevector(of, of, 2, 3, 0, 1, 6, 7, 4, 5));
        if constexpr (size == 8) join(of, __builtin_shufflevector(of, of, 1, 0, 3, 2, 5, 4, 7, 6));
        if constexpr (size == 4) join(of, __builtin_shufflevector(of, of, 2, 3, 0, 1));
        if constexpr (size == 4) join(of, __builtin_shufflevector(of, of, 1, 0, 3, 2));
        if constexpr (size == 2) join(of, __builtin_shufflevector(of, of, 1, 0));
    }
};

/// Keeps the highest number and its position for each lane, over all packs so far.
template <class Of>
struct HighestOfPacks {
    typename Of::Numbers heights;
    typename Of::Words where;

    /// Starts from the first pack; its vertices count from 0.
    [[gnu::always_inline]] explicit HighestOfPacks(const typename Of::Numbers& first) : heights(first) {
        Of::count_from(0, where);
    }
    [[gnu::always_inline]] void take(const typename Of::Numbers& next, std::size_t first) {
        typename Of::Words places;
        Of::count_from(static_cast<typename Of::Word>(first), places);
        // Each pack waits for the maximum alone, not for a comparison and a selection.
        const typename Of::Numbers before = heights;
        heights = next > before ? next : before;
        where = heights != before ? places : where;
    }
    /// The first of the highest vertices; at most `last`, which it returns where heights are NaN.
    [[nodiscard]] [[gnu::always_inline]] std::size_t first_highest(std::size_t last) const {
        return std::min(static_cast<std::size_t>(Of::first_of_highest(heights, where)), last);
    }
};

}  // namespace edgewise
