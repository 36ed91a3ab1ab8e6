// SPDX-License-Identifier: MIT
#include "edgewise/measure/counters/random_chase.hpp"

namespace edgewise::measure {

RandomChase::RandomChase(std::uint64_t bytes)
    : lines_(bytes / line_bytes), memory_((lines_ + 1) * words_a_line, 0) {
    const auto address = reinterpret_cast<std::uintptr_t>(memory_.data());
    first_ = (line_bytes - address % line_bytes) % line_bytes / sizeof(std::uint64_t);
}

void RandomChase::run(std::uint64_t loads) {
    const volatile std::uint64_t* const words = memory_.data() + first_;
    std::uint64_t loaded = 0;
    for (; loads > 0; --loads) {
        const std::uint64_t line = next(loaded);
        loaded = words[line * words_a_line];
        state_ ^= loaded;
    }
}

}  // namespace edgewise::measure
