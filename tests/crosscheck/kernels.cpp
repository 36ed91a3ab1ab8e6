// SPDX-License-Identifier: MIT
//
// crosscheck_kernels LINE D1_BYTES D1_WAYS LL_BYTES LL_WAYS
//
// Runs under Callgrind with the same geometry: every kernel starts with empty caches, because instrumentation
// is switched on before it, and writes a dump. It also runs once into the model. With full caches, the few
// lines of stack of a call would evict lines, and each eviction could cause one miss per way of a set. Prints
// the model's counts, one line per kernel: name, accesses, D1 misses, LL misses.
#include <valgrind/callgrind.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "edgewise/measure/cache/cache_model.hpp"

namespace edgewise::crosscheck {
namespace {

// Small loops over memory with explicit accesses. They run with real loads and stores, which the compiler can
// neither drop nor add, and into a cache model. A simulator of the whole processor must count for the real
// run what the model counts.

using Word = std::uint64_t;
constexpr std::uint32_t word_bytes = sizeof(Word);

/// The next of a sequence of pseudo-random numbers (Knuth's MMIX).
void advance(Word& place) { place = place * 6364136223846793005 + 1442695040888963407; }

/// Real loads and stores; everything else stays in registers.
struct RealMemory {
    Word read(const Word* at) const { return *static_cast<const volatile Word*>(at); }
    void write(Word* at, Word value) const { *static_cast<volatile Word*>(at) = value; }
    /// Reads a word at any byte.
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

/// Follows `words`, in which each word is the index of the next one; they are a single cycle.
template <class Memory>
Word chase(const Memory& memory, const std::vector<Word>& words, Word steps) {
    Word at = 0;
    for (; steps > 0; --steps) at = memory.read(&words[at]);
    return at;
}

/// Reads random records of 21 words, the paper's 168 bytes.
template <class Memory>
Word records(const Memory& memory, const std::vector<Word>& words, Word steps) {
    const Word count = words.size() / 21;
    Word sum = 0, place = 1;
    for (; steps > 0; --steps) {
        advance(place);
        const Word* const record = &words[(place >> 33) % count * 21];
        for (int i = 0; i < 21; ++i) sum += memory.read(record + i);
    }
    return sum;
}

/// Reads words at random bytes, so that many cross a line.
template <class Memory>
Word crossings(const Memory& memory, const std::vector<Word>& words, Word steps) {
    const auto* const bytes = reinterpret_cast<const char*>(words.data());
    const Word count = words.size() * word_bytes - word_bytes;
    Word sum = 0, place = 1;
    for (; steps > 0; --steps) {
        advance(place);
        sum += memory.read_at(bytes + (place >> 33) % count);
    }
    return sum;
}

/// Copies random words to random places.
template <class Memory>
Word copies(const Memory& memory, std::vector<Word>& words, Word steps) {
    Word place = 1;
    for (; steps > 0; --steps) {
        advance(place);
        const Word from = (place >> 33) % words.size(), to = (place >> 13) % words.size();
        memory.write(&words[to], memory.read(&words[from]));
    }
    return 0;
}

volatile Word sink;

template <class Kernel>
void run(const std::string& name, const measure::CacheGeometry& geometry, Kernel kernel) {
    measure::CacheModel model(geometry);
    sink = kernel(ModelMemory{model});
    std::printf("%s %llu %llu %llu\n", name.c_str(),
                static_cast<unsigned long long>(model.counts(0).accesses),
                static_cast<unsigned long long>(model.counts(0).misses),
                static_cast<unsigned long long>(model.counts(1).misses));
    CALLGRIND_START_INSTRUMENTATION;
    sink = kernel(RealMemory{});
    CALLGRIND_STOP_INSTRUMENTATION;
    CALLGRIND_DUMP_STATS_AT(name.c_str());
}

/// A single cycle through all words in a seeded random order (Sattolo, 1986).
std::vector<Word> cycle(std::size_t count) {
    std::vector<Word> next(count);
    std::iota(next.begin(), next.end(), Word{0});
    Word place = 3;
    for (std::size_t i = count; i > 1; --i) {
        advance(place);
        std::swap(next[i - 1], next[(place >> 33) % (i - 1)]);
    }
    return next;
}

void run_all(const measure::CacheGeometry& geometry) {
    for (const std::size_t kibibytes : {12, 40, 200}) {
        std::vector<Word> words = cycle(kibibytes * 1024 / word_bytes);
        const Word steps = 50000;
        const auto label = [&](const char* name) {
            return std::string(name) + "_" + std::to_string(kibibytes);
        };
        run(label("sequence"), geometry, [&](auto memory) { return sequence(memory, words, 4); });
        run(label("chase"), geometry, [&](auto memory) { return chase(memory, words, steps); });
        run(label("records"), geometry, [&](auto memory) { return records(memory, words, steps / 10); });
        run(label("crossings"), geometry, [&](auto memory) { return crossings(memory, words, steps); });
        run(label("copies"), geometry, [&](auto memory) { return copies(memory, words, steps); });
    }
}

measure::CacheGeometry geometry_of(char** values) {
    const auto number = [&](int i) {
        return static_cast<std::uint32_t>(std::strtoul(values[i], nullptr, 10));
    };
    const auto sets = [&](int i) { return number(i) / number(i + 1) / number(1); };
    measure::CacheGeometry geometry;
    geometry.line_bytes = number(1);
    geometry.levels = {{"D1", sets(2), number(3)}, {"LL", sets(4), number(5)}};
    geometry.crossing = measure::LineCrossing::merge;
    return geometry;
}

}  // namespace
}  // namespace edgewise::crosscheck

int main(int count, char** values) {
    if (count != 6) {
        std::fputs("usage: crosscheck_kernels LINE D1_BYTES D1_WAYS LL_BYTES LL_WAYS\n", stderr);
        return 2;
    }
    edgewise::crosscheck::run_all(edgewise::crosscheck::geometry_of(values));
    return 0;
}
