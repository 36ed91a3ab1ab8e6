// SPDX-License-Identifier: MIT
//
// Blocks of random arrays: aligned, separate from each other, and accounted for to the byte.
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
    std::size_t begin, end, element_alignment;
};

/// A record with bytes that serve nothing.
struct Padded {
    double number;
    std::uint16_t small;
};

/// Each on its alignment and behind the one before; short ones without a gap.
void expect_in_order(const std::vector<Extent>& arrays, std::size_t size) {
    std::size_t end = 0;
    for (const Extent& array : arrays) {
        const bool is_short = array.end - array.begin < BlockPlan::alignment;
        EXPECT_EQ(array.begin % (is_short ? array.element_alignment : BlockPlan::alignment), 0U);
        EXPECT_GE(array.begin, end);
        if (is_short) {
            EXPECT_LT(array.begin - end, array.element_alignment);
        }
        end = array.end;
    }
    EXPECT_EQ(size, end);
}

TEST(BlockPlan, ArraysAreAlignedAndApartAndEveryByteIsBooked) {
    scene::Rng rng(1);
    for (int round = 0; round < 500; ++round) {
        BlockPlan plan;
        std::vector<Extent> arrays;
        std::size_t payload = 0;
        const auto add = [&]<class Element>(Element* array, std::size_t count, const Shares& shares) {
            plan.array(array, count, shares);
            EXPECT_EQ(array, nullptr) << "nothing is placed while sizes are added up";
            arrays.push_back({plan.size() - count * sizeof(Element), plan.size(), alignof(Element)});
            payload += count * shares.bytes();
        };
        for (std::uint64_t i = 0, n = 1 + rng.below(8); i < n; ++i) {
            const std::size_t count = rng.below(4) == 0 ? 0 : rng.below(100);
            switch (rng.below(3)) {
                case 0:
                    add(static_cast<std::uint16_t*>(nullptr), count, {{Component::topology, 2}});
                    break;
                case 1:
                    add(static_cast<double*>(nullptr), count, {{Component::face_planes, 8}});
                    break;
                default:
                    add(static_cast<Padded*>(nullptr), count,
                        {{Component::edge_geometry, 8}, {Component::topology, 2}});
            }
        }
        expect_in_order(arrays, plan.size());
        const Ledger ledger = ledger_of(plan.pieces(nullptr));
        EXPECT_EQ(ledger.total(), plan.size());
        EXPECT_EQ(ledger[Component::padding], plan.size() - payload);
    }
}

TEST(Block, PlacesArraysOneAfterAnother) {
    std::uint8_t* bytes = nullptr;
    double* numbers = nullptr;
    std::uint16_t* few = nullptr;
    const Block block([&](BlockPlan& plan) {
        plan.array(bytes, 3, {{Component::topology, 1}});
        plan.array(numbers, 30, {{Component::face_planes, 8}});
        plan.array(few, 5, {{Component::topology, 2}});
    });
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block.base()) % BlockPlan::alignment, 0U);
    EXPECT_EQ(reinterpret_cast<std::byte*>(bytes), block.base());
    EXPECT_EQ(reinterpret_cast<std::byte*>(numbers), block.base() + 64);
    EXPECT_EQ(reinterpret_cast<std::byte*>(few), block.base() + 64 + 240);
    EXPECT_EQ(block.size(), 64U + 240U + 10U);
}

/// A hundred small blocks from one stretch of memory lie back to back.
TEST(Block, SmallOnesAreAlignedForTheirElementsAlone) {
    std::array<std::byte, 4096> place;
    std::pmr::monotonic_buffer_resource resource(place.data(), place.size(),
                                                 std::pmr::null_memory_resource());
    const TablesIn placed(resource);
    std::vector<Block> blocks;
    double* numbers = nullptr;
    std::uint8_t* bytes = nullptr;
    for (int i = 0; i < 100; ++i) {
        blocks.emplace_back([&](BlockPlan& plan) {
            plan.array(numbers, 3, {{Component::vertex_coordinates, 8}});
            plan.array(bytes, 4, {{Component::topology, 1}});
        });
        EXPECT_EQ(blocks.back().base() - blocks.front().base(), i * 32);
    }
}

TEST(BlockPlan, RecordsOfSeveralLengthsFollowEachOtherAndEqualOnesAreOnePiece) {
    BlockPlan plan;
    EXPECT_EQ(plan.append(24, {{Component::vertex_coordinates, 16}, {Component::topology, 4}}), 0U);
    EXPECT_EQ(plan.append(24, {{Component::vertex_coordinates, 16}, {Component::topology, 4}}), 24U);
    EXPECT_EQ(plan.append(40, {{Component::vertex_coordinates, 16}, {Component::topology, 24}}), 48U);
    EXPECT_EQ(plan.size(), 88U);
    const std::array<std::byte, 88> memory{};
    const std::byte* const base = memory.data();
    const std::vector<Piece> pieces = plan.pieces(base);
    ASSERT_EQ(pieces.size(), 2U);
    EXPECT_EQ(pieces[0].at, base);
    EXPECT_EQ(pieces[0].count, 2U);
    EXPECT_EQ(pieces[1].at, base + 48);
    EXPECT_EQ(ledger_of(pieces)[Component::padding], 8U);
    EXPECT_TRUE(pieces[1].holds(base + 80, 8));
    EXPECT_FALSE(pieces[1].holds(base + 80, 9));
    EXPECT_FALSE(pieces[1].holds(base + 47, 8));
}

void twenty_numbers(BlockPlan& plan) {
    double* numbers = nullptr;
    plan.array(numbers, 20, {{Component::topology, sizeof(double)}});
}

TEST(Block, HasOneOwnerAndViews) {
    Block block(twenty_numbers);
    const std::byte* const base = block.base();
    {
        const Block view = block.view();
        EXPECT_EQ(view.base(), base);
        EXPECT_EQ(view.size(), block.size());
    }
    *block.base() = std::byte{7};  // a view that went gives nothing back: sanitizers would see
    Block owner = std::move(block);
    EXPECT_EQ(owner.base(), base);
    EXPECT_EQ(*owner.base(), std::byte{7});
    owner = Block(twenty_numbers);
    EXPECT_NE(owner.base(), nullptr);
}

}  // namespace
}  // namespace edgewise
