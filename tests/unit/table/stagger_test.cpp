// SPDX-License-Identifier: MIT
//
// The trap of parallel arrays, made visible: a walk over all edges that reads the planes and
// the direction of each, nineteen scalars, and
// a first-level cache of 32 KiB in 8 ways that keeps what was used last. Where the arrays of `soa` start a
// multiple of the cache's stride from each other every read misses; `soa_stagger` never does worse than each
// line once.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <set>

#include "edgewise/bench/memory/arena.hpp"
#include "edgewise/layouts/soa.hpp"
#include "edgewise/layouts/soa_stagger.hpp"
#include "round_body.hpp"

namespace edgewise {
namespace {

/// Least recently used goes first.
class Cache {
  public:
    static constexpr std::size_t line = 64, sets = 64, ways = 8;

    void read(const void* address, std::size_t /*size*/, Field /*field*/) {
        const std::uintptr_t wanted = reinterpret_cast<std::uintptr_t>(address) / line;
        lines_.insert(wanted);
        ++reads_;
        auto& set = sets_[wanted % sets];
        const auto found = std::find(set.begin(), set.end(), wanted);
        misses_ += found == set.end();
        if (found != set.end()) set.erase(found);
        set.insert(set.begin(), wanted);
        if (set.size() > ways) set.pop_back();
    }
    [[nodiscard]] std::size_t reads() const { return reads_; }
    [[nodiscard]] std::size_t misses() const { return misses_; }
    [[nodiscard]] std::size_t compulsory() const { return lines_.size(); }

  private:
    std::array<std::vector<std::uintptr_t>, sets> sets_;
    std::set<std::uintptr_t> lines_;
    std::size_t reads_ = 0, misses_ = 0;
};

template <template <class, class> class Layout>
Cache walk(const Polyhedron& body) {
    bench::Arena arena;
    const TablesIn placed(arena);
    const Layout<f64, Direct> table(body, Parts::features);
    Cache cache;
    const Layout<f64, Traced<Cache>> traced(table, Traced<Cache>{&cache});
    for (Index e = 0; e < body.edge_count(); ++e) {
        for (const End end : {End::tail, End::head}) static_cast<void>(traced.vertex_edge_plane(e, end));
        for (const Side side : {Side::left, Side::right}) static_cast<void>(traced.edge_face_plane(e, side));
        static_cast<void>(traced.direction(e));
    }
    return cache;
}

TEST(Stagger, ParallelArraysAStrideApartMissEveryTime) {
    const Polyhedron body = testing::round_body(172);
    ASSERT_EQ(body.edge_count(), 510U) << "64 lines an array: a multiple of the stride of 4096 bytes";
    const Cache plain = walk<soa>(body), staggered = walk<soa_stagger>(body);
    std::printf("510 edges, %zu reads: soa misses %zu times, soa_stagger %zu, once a line is %zu\n",
                plain.reads(), plain.misses(), staggered.misses(), plain.compulsory());
    EXPECT_EQ(plain.misses(), plain.reads());
    EXPECT_EQ(staggered.misses(), staggered.compulsory());
}

/// Also where arrays are half a stride or two strides long, and just off such lengths.
TEST(Stagger, NeverMissesMoreThanOnceALineWhateverTheLength) {
    std::size_t trapped = 0;
    for (const std::size_t near : {44U, 87U, 129U, 172U, 257U, 342U}) {
        for (std::size_t vertices = near - 3; vertices <= near + 3; ++vertices) {
            const Polyhedron body = testing::round_body(vertices);
            const Cache plain = walk<soa>(body), staggered = walk<soa_stagger>(body);
            trapped += plain.misses() > 2 * plain.compulsory();
            EXPECT_EQ(staggered.misses(), staggered.compulsory()) << vertices;
        }
    }
    std::printf("soa misses more than twice per line at %zu of 42 sizes\n", trapped);
    EXPECT_GT(trapped, 3U);
}

}  // namespace
}  // namespace edgewise
