// SPDX-License-Identifier: MIT
#include "edgewise/measure/cache/touched_bytes.hpp"

#include <algorithm>
#include <bit>

namespace edgewise::measure {

namespace {

/// Calls use(word, bits) for each word that the range meets, with the range's bits in it.
template <class Use>
void each_word(std::uint64_t from, std::uint64_t bytes, Use use) {
    const std::uint64_t end = from + bytes;
    for (std::uint64_t at = from; at < end;) {
        const std::uint64_t stop = std::min(end, (at / 64 + 1) * 64);
        const std::uint64_t ones = ~std::uint64_t{0} >> (64 - (stop - at));
        use(at / 64, ones << at % 64);
        at = stop;
    }
}

}  // namespace

void TouchedBytes::touch(std::uint64_t from, std::uint64_t bytes) {
    const std::uint64_t needed = (from + bytes + 63) / 64;
    if (needed > words_.size()) words_.resize(std::max<std::uint64_t>(needed, 2 * words_.size()), 0);
    each_word(from, bytes, [&](std::uint64_t word, std::uint64_t bits) { words_[word] |= bits; });
}

std::uint64_t TouchedBytes::count(std::uint64_t from, std::uint64_t bytes) const {
    std::uint64_t sum = 0;
    const std::uint64_t there = 64 * words_.size();
    if (from >= there) return 0;
    each_word(from, std::min(bytes, there - from), [&](std::uint64_t word, std::uint64_t bits) {
        sum += static_cast<std::uint64_t>(std::popcount(words_[word] & bits));
    });
    return sum;
}

}  // namespace edgewise::measure
