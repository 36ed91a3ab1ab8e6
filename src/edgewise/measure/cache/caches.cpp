// SPDX-License-Identifier: MIT
//
// Reads sys/devices/system/cpu/cpu0/cache/index*.
#include "edgewise/measure/cache/caches.hpp"

#include <fmt/core.h>

namespace edgewise::measure {

namespace {

Cache read_cache(const std::filesystem::path& index) {
    Cache cache;
    cache.level = read_number(index / "level");
    cache.type = read_text(index / "type");
    cache.bytes = read_number(index / "size");
    cache.ways = read_number(index / "ways_of_associativity");
    cache.line_bytes = read_number(index / "coherency_line_size");
    cache.sets = read_number(index / "number_of_sets");
    cache.shared_cpus = read_text(index / "shared_cpu_list");
    // The kernel writes 0 where it does not know (Arm without firmware tables): that is not a number of ways.
    for (Expected<std::int64_t>* number : {&cache.bytes, &cache.ways, &cache.line_bytes, &cache.sets}) {
        if (number->value == 0) *number = Expected<std::int64_t>::none("the kernel says 0: it does not know");
    }
    return cache;
}

}  // namespace

Expected<std::vector<Cache>> read_caches(const std::filesystem::path& root) {
    const std::filesystem::path directory = root / "sys/devices/system/cpu/cpu0/cache";
    std::vector<Cache> caches;
    std::error_code error;
    for (int i = 0; std::filesystem::is_directory(directory / fmt::format("index{}", i), error); ++i) {
        caches.push_back(read_cache(directory / fmt::format("index{}", i)));
    }
    if (caches.empty()) {
        return Expected<std::vector<Cache>>::none(fmt::format("{}: no caches described", directory.string()));
    }
    return {std::move(caches)};
}

}  // namespace edgewise::measure
