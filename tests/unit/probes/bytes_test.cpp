// SPDX-License-Identifier: MIT
//
// Shares and slopes from tables of known sizes.
#include "edgewise/probes/bytes.hpp"

#include <gtest/gtest.h>

#include "found.hpp"

namespace edgewise::probes {
namespace {

/// A table of 100 bytes and 168 more an edge, of which the planes take 128.
TableBytes table_of(std::uint64_t edges) {
    TableBytes table;
    table.vertices = (edges + 6) / 3;
    table.edges = edges;
    table.ledger[Component::voronoi_planes] = 128 * edges;
    table.ledger[Component::edge_geometry] = 40 * edges;
    table.ledger[Component::padding] = 100;
    return table;
}

TEST(Bytes, AreSharesAndSlopes) {
    const std::vector<TableBytes> sizes = {table_of(12), table_of(108), table_of(1152)};
    TableBytes table = table_of(108);
    auto found = by_name(bytes::figures(table, sizes));
    EXPECT_EQ(found["voronoi_planes"].value, 128);
    EXPECT_EQ(found["padding"].value, 100.0 / 108);
    EXPECT_EQ(found["paper_bytes_per_edge"].value, 168);
    EXPECT_EQ(found["slope_bytes_per_edge"].value, 168);
    EXPECT_EQ(found["total_bytes_per_edge"].value, 168 + 100.0 / 108);
    EXPECT_EQ(found["table_bytes"].value, 168 * 108 + 100);
    table.ledger[Component::voronoi_planes] = 0;
    EXPECT_FALSE(by_name(bytes::figures(table, sizes))["paper_bytes_per_edge"].value);
    EXPECT_FALSE(by_name(bytes::figures(table, {}))["slope_bytes_per_edge"].value);
}

}  // namespace
}  // namespace edgewise::probes
