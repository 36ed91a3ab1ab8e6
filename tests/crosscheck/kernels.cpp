// SPDX-License-Identifier: MIT
//
// crosscheck_kernels LINE D1_BYTES D1_WAYS LL_BYTES LL_WAYS
//
// Run under Callgrind with the same geometry: every kernel from empty caches, which switching instrumentation
// on makes, and a dump after each; and once into the model. From full caches the few lines of stack that a
// call touches would evict lines, and each eviction costs up to as many misses as a set has ways. Prints the
// model's counts, a line a kernel: name, accesses, D1 misses, LL misses.
#include <valgrind/callgrind.h>

#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <string>
#include <utility>

#include "kernels.hpp"

namespace edgewise::crosscheck {
namespace {

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

/// One cycle through all of them in a seeded random order (Sattolo, 1986).
std::vector<Word> cycle(std::size_t count) {
    std::vector<Word> next(count);
    std::iota(next.begin(), next.end(), Word{0});
    Word place = 3;
    for (std::size_t i = count; i > 1; --i) {
        place = (place * 6364136223846793005 + 1442695040888963407);
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
