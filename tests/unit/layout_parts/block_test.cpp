// SPDX-License-Identifier: MIT
//
// Blocks of random arrays: aligned, apart from each other, filled as asked, and accounted for to the byte.
#include "edgewise/layout_parts/block.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory_resource>
#include <vector>

#include "edgewise/scene/rng.hpp"

namespace edgewise {
namespace {

struct Extent {
    std::size_t begin, end;
};

/// A record with bytes that serve nothing.
struct Padded {
    double number;
    std::uint16_t small;
};

TEST(BlockPlan, ArraysAreAlignedAndApartAndEveryByteIsBooked) {
    scene::Rng rng(1);
    for (int round = 0; round < 500; ++round) {
        BlockPlan plan;
        std::vector<Extent> arrays;
        std::size_t payload = 0;
        const auto add = [&](auto slot, std::size_t element, std::size_t spoken_for) {
            arrays.push_back({slot.offset, slot.offset + slot.count * element});
            payload += slot.count * spoken_for;
        };
        for (std::uint64_t i = 0, n = 1 + rng.below(8); i < n; ++i) {
            const std::size_t count = rng.below(4) == 0 ? 0 : rng.below(100);
            switch (rng.below(3)) {
                case 0:
                    add(plan.array<std::uint16_t>(count, {{Component::topology, 2}}), 2, 2);
                    break;
                case 1:
                    add(plan.array<double>(count, {{Component::face_planes, 8}}), 8, 8);
                    break;
                default:
                    add(plan.array<Padded>(count, {{Component::edge_geometry, 8}, {Component::topology, 2}}),
                        sizeof(Padded), 10);
            }
        }
        std::size_t end = 0;
        for (const Extent& array : arrays) {
            EXPECT_EQ(array.begin % BlockPlan::alignment, 0U);
            EXPECT_GE(array.begin, end);
            end = array.end;
        }
        EXPECT_EQ(plan.size(), end);
        EXPECT_EQ(plan.ledger().total(), plan.size());
        EXPECT_EQ(plan.ledger()[Component::padding], plan.size() - payload);
    }
}

TEST(Block, FillsArraysInPlace) {
    BlockPlan plan;
    const auto bytes = plan.array<std::uint8_t>(3, {{Component::topology, 1}});
    const auto numbers = plan.array<double>(10, {{Component::face_planes, 8}});
    const Block block(plan);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block.base()) % BlockPlan::alignment, 0U);
    const std::uint8_t* b =
        block.fill(bytes, [](std::uint32_t i) { return static_cast<std::uint8_t>(i + 1); });
    const double* n = block.fill(numbers, [](std::uint32_t i) { return 0.5 * i; });
    for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(b[i], i + 1);
    for (std::uint32_t i = 0; i < 10; ++i) EXPECT_EQ(n[i], 0.5 * i);
    EXPECT_EQ(reinterpret_cast<const std::byte*>(n) - block.base(),
              static_cast<std::ptrdiff_t>(numbers.offset));
}

TEST(BlockPlan, RecordsOfSeveralLengthsFollowEachOtherAndEqualOnesAreOnePiece) {
    BlockPlan plan;
    EXPECT_EQ(plan.append(24, {{Component::vertex_coordinates, 16}, {Component::topology, 4}}), 0U);
    EXPECT_EQ(plan.append(24, {{Component::vertex_coordinates, 16}, {Component::topology, 4}}), 24U);
    EXPECT_EQ(plan.append(40, {{Component::vertex_coordinates, 16}, {Component::topology, 24}}), 48U);
    EXPECT_EQ(plan.size(), 88U);
    const Block block(plan);
    const std::vector<Piece> pieces = block.pieces();
    ASSERT_EQ(pieces.size(), 2U);
    EXPECT_EQ(pieces[0].at, block.base());
    EXPECT_EQ(pieces[0].count, 2U);
    EXPECT_EQ(pieces[1].at, block.base() + 48);
    EXPECT_EQ(plan.ledger()[Component::padding], 8U);
    EXPECT_TRUE(pieces[1].holds(block.base() + 80, 8));
    EXPECT_FALSE(pieces[1].holds(block.base() + 80, 9));
    EXPECT_FALSE(pieces[1].holds(block.base() + 47, 8));
}

TEST(Block, TakesItsMemoryFromWhereItIsTold) {
    BlockPlan plan;
    const auto slot = plan.array<double>(20, {{Component::topology, sizeof(double)}});
    std::array<std::byte, 256> place;
    std::pmr::monotonic_buffer_resource resource(place.data(), place.size(),
                                                 std::pmr::null_memory_resource());
    const Block outside(plan);
    {
        const TablesIn placed(resource);
        const Block inside(plan);
        EXPECT_GE(inside.base(), place.data());
        EXPECT_LT(inside.base(), place.data() + place.size());
        EXPECT_THROW(Block{plan}, std::bad_alloc) << "one block of 256 bytes fits, a second may not";
        static_cast<void>(inside.at(slot));
    }
    const Block after(plan);
    EXPECT_TRUE(after.base() < place.data() || after.base() >= place.data() + place.size());
}

TEST(Block, CopiesShareOneMemory) {
    BlockPlan plan;
    const auto slot = plan.array<int>(1, {{Component::topology, sizeof(int)}});
    const Block block(plan);
    *block.at(slot) = 7;
    const Block copy = block;
    EXPECT_EQ(copy.base(), block.base());
    EXPECT_EQ(*copy.at(slot), 7);
    EXPECT_EQ(copy.ledger().total(), block.ledger().total());
}

}  // namespace
}  // namespace edgewise
