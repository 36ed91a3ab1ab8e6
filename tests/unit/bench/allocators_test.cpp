// SPDX-License-Identifier: MIT
//
// The allocators of tables, side by side: what is asked for is counted to the byte, what is taken is no less,
// memory can be used and given back; and the C library's malloc is still the program's own.
#include "edgewise/bench/memory/allocators.hpp"

#include <gmock/gmock.h>
#include <malloc.h>
#include <unistd.h>

#include <chrono>
#include <cstring>

#include "edgewise/bench/memory/arena.hpp"
#include "edgewise/input/guarded.hpp"
#include "edgewise/scene/rng.hpp"

namespace edgewise::bench {
namespace {

class Allocators : public ::testing::TestWithParam<AllocatorKind> {};

struct Piece {
    void* memory;
    std::size_t bytes, alignment;
};

TEST_P(Allocators, CountWhatIsAskedForAndWhatItTakes) {
    if (GetParam() == AllocatorKind::jemalloc && !make_jemalloc())
        GTEST_SKIP() << "this program was built without jemalloc";
    const auto allocator = make_allocator(GetParam());
    scene::Rng rng(1);
    std::vector<Piece> pieces;
    std::size_t asked = 0;
    for (int i = 0; i < 300; ++i) {
        const std::size_t alignment = std::size_t{8} << rng.below(4), bytes = 1 + rng.below(70000);
        void* const memory = allocator->allocate(bytes, alignment);
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(memory) % alignment, 0U);
        std::memset(memory, i, bytes);
        pieces.push_back({memory, bytes, alignment});
        asked += bytes;
        ASSERT_EQ(allocator->requested(), asked);
        ASSERT_GE(allocator->taken(), asked);
        if (const auto own = allocator->by_its_statistics()) {
            ASSERT_EQ(*own, allocator->taken());
        }
    }
    EXPECT_LT(allocator->taken(), asked + asked / 4);
    for (const Piece& piece : pieces) {
        const int mark = static_cast<int>(&piece - pieces.data());
        EXPECT_EQ(static_cast<unsigned char*>(piece.memory)[piece.bytes - 1], mark & 0xff);
        allocator->deallocate(piece.memory, piece.bytes, piece.alignment);
    }
    EXPECT_EQ(allocator->requested(), 0U);
}

INSTANTIATE_TEST_SUITE_P(Each, Allocators,
                         ::testing::Values(AllocatorKind::arena, AllocatorKind::jemalloc,
                                           AllocatorKind::libc),
                         [](const auto& of) { return std::string(to_string(of.param)); });

/// A program that links jemalloc must still use the C library's malloc: usable sizes show which one it uses.
TEST(AllocatorsTogether, LeaveMallocToTheCLibrary) {
    const auto jemalloc = make_jemalloc();
    if (!jemalloc) GTEST_SKIP() << "this program was built without jemalloc";
    void* const memory = std::malloc(100);
    EXPECT_EQ(malloc_usable_size(memory), 104U) << "glibc's chunk; jemalloc's class would be 112";
    std::free(memory);
    void* const large = jemalloc->allocate(64848, 64);
    EXPECT_EQ(jemalloc->taken(), 65536U);
    void* const small = jemalloc->allocate(168, 8);
    EXPECT_EQ(jemalloc->taken(), 65536U + 192U);
    jemalloc->deallocate(large, 64848, 64);
    jemalloc->deallocate(small, 168, 8);
    EXPECT_EQ(jemalloc->taken(), 0U);
}

TEST(Arena, PlacesTablesAtKnownOffsets) {
    Arena arena;
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(arena.base()) % Arena::alignment, 0U);
    const auto offset = [&](void* memory) { return static_cast<std::byte*>(memory) - arena.base(); };
    EXPECT_EQ(offset(arena.allocate(100, 64)), 0);
    EXPECT_EQ(offset(arena.allocate(10, 8)), 104);
    EXPECT_EQ(offset(arena.allocate(1, 64)), 128);
    EXPECT_EQ(arena.taken(), 129U);
    EXPECT_EQ(arena.requested(), 111U);
}

TEST(Arena, TakesPagesOnlyForWhatIsWritten) {
    Arena arena;
    auto* const memory = static_cast<std::byte*>(arena.allocate(1 << 20, 64));
    EXPECT_EQ(arena.resident(), 0U);
    memory[0] = memory[500000] = std::byte{1};
    EXPECT_EQ(arena.resident(), 2U * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)));
    EXPECT_THROW(static_cast<void>(arena.allocate(std::size_t{1} << 40, 64)), std::bad_alloc);
}

/// Two arenas in turn, each with one table of 3 MiB after the other; what the last says that has no room.
std::string filled_in_turn() {
    Arena first, second;
    for (std::ptrdiff_t offset = 0;; offset += 3 << 20) {
        for (Arena* arena : {&first, &second}) {
            try {
                auto* const memory = static_cast<std::byte*>(arena->allocate(3 << 20, 64));
                if (memory - arena->base() != offset) return "elsewhere";
                std::memset(memory, 1, 3 << 20);
            } catch (const std::runtime_error& problem) {
                return std::to_string(offset >> 20) + ": " + problem.what();
            }
        }
    }
}

/// With 64 MiB of addresses instead of the 16 GiB that are reserved elsewhere, at the same offsets.
TEST(Arena, GrowsWhereAddressesAreShort) {
#ifdef __SANITIZE_THREAD__
    GTEST_SKIP() << "ThreadSanitizer chooses addresses itself";
#endif
    const auto said = input::run_guarded(filled_in_turn, {std::uint64_t{64} << 20, std::chrono::seconds(60)});
    ASSERT_TRUE(said) << said.error;
    EXPECT_THAT(*said, testing::ContainsRegex("^(24|27|30): no address space for .* MiB of tables: raise its "
                                              "limit .ulimit -v, now [0-9]+ MiB., or ask for fewer"));
}

TEST(Arena, IsNotSoonFull) {
    Arena arena;
    for (int i = 0; i < 12; ++i) EXPECT_NE(arena.allocate(std::size_t{1} << 30, 64), nullptr);
}

}  // namespace
}  // namespace edgewise::bench
