// SPDX-License-Identifier: MIT
//
// Small loops over memory with every access written out: once for real, with loads and stores that the
// compiler may neither drop nor add, and once into a cache model. A simulator of the whole processor must see
// in the first what the model saw in the second.
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

#include "edgewise/measure/cache/cache_model.hpp"

namespace edgewise::crosscheck {

using Word = std::uint64_t;
inline constexpr std::uint32_t word_bytes = sizeof(Word);

/// For real; everything besides stays in registers.
struct RealMemory {
    Word read(const Word* at) const { return *static_cast<const volatile Word*>(at); }
    void write(Word* at, Word value) const { *static_cast<volatile Word*>(at) = value; }
    /// At any byte.
    Word read_at(const char* at) const {
        Word value;
        asm volatile("movq %1, %0" : "=r"(value) : "m"(*at));
        return value;
    }
};

/// Sends the same accesses to a model.
struct ModelMemory {
    measure::CacheModel& model;

    Word read(const Word* at) const { return read_at(reinterpret_cast<const char*>(at)); }
    void write(Word* at, Word value) const {
        model.access(reinterpret_cast<std::uintptr_t>(at), word_bytes, measure::AccessKind::write);
        *at = value;
    }
    Word read_at(const char* at) const {
        model.access(reinterpret_cast<std::uintptr_t>(at), word_bytes, measure::AccessKind::read);
        Word value;
        std::memcpy(&value, at, sizeof value);
        return value;
    }
};

/// Accesses memory word by word, `times` times.
template <class Memory>
Word sequence(const Memory& memory, const std::vector<Word>& words, Word times) {
    Word sum = 0;
    for (; times > 0; --times) {
        for (const Word& word : words) sum += memory.read(&word);
    }
    return sum;
}

/// Where each word says where to go next, all of them once: `words` is one cycle.
template <class Memory>
Word chase(const Memory& memory, const std::vector<Word>& words, Word steps) {
    Word at = 0;
    for (; steps > 0; --steps) at = memory.read(&words[at]);
    return at;
}

/// Records of 21 words, the paper's 168 bytes, here and there.
template <class Memory>
Word records(const Memory& memory, const std::vector<Word>& words, Word steps) {
    const Word count = words.size() / 21;
    Word sum = 0, place = 1;
    for (; steps > 0; --steps) {
        place = (place * 6364136223846793005 + 1442695040888963407);
        const Word* const record = &words[(place >> 33) % count * 21];
        for (int i = 0; i < 21; ++i) sum += memory.read(record + i);
    }
    return sum;
}

/// Words at any byte, so that many cross a line.
template <class Memory>
Word crossings(const Memory& memory, const std::vector<Word>& words, Word steps) {
    const auto* const bytes = reinterpret_cast<const char*>(words.data());
    const Word count = words.size() * word_bytes - word_bytes;
    Word sum = 0, place = 1;
    for (; steps > 0; --steps) {
        place = (place * 6364136223846793005 + 1442695040888963407);
        sum += memory.read_at(bytes + (place >> 33) % count);
    }
    return sum;
}

/// Reads a word here and writes one there.
template <class Memory>
Word copies(const Memory& memory, std::vector<Word>& words, Word steps) {
    Word place = 1;
    for (; steps > 0; --steps) {
        place = (place * 6364136223846793005 + 1442695040888963407);
        const Word from = (place >> 33) % words.size(), to = (place >> 13) % words.size();
        memory.write(&words[to], memory.read(&words[from]));
    }
    return 0;
}

}  // namespace edgewise::crosscheck
