// SPDX-License-Identifier: MIT
//
// Bytes of all tables, and what an allocator cannot tell.
#include "edgewise/probes/memory.hpp"

#include <gtest/gtest.h>

#include "found.hpp"

namespace edgewise::probes {
namespace {

TEST(Memory, IsOfAllTables) {
    bench::MemoryUse use = {12, 12000, 12800, 16384.0, 0.25};
    auto found = by_name(memory::figures(use));
    EXPECT_EQ(found["tables"].value, 12);
    EXPECT_EQ(found["requested_bytes"].value, 12000);
    EXPECT_EQ(found["taken_bytes"].value, 12800);
    EXPECT_EQ(found["resident_bytes"].value, 16384);
    EXPECT_EQ(found["materialised"].value, 0.25);
    use.resident = std::nullopt;
    EXPECT_FALSE(by_name(memory::figures(use))["resident_bytes"].value);
}

}  // namespace
}  // namespace edgewise::probes
