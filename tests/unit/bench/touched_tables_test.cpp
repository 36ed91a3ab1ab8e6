// SPDX-License-Identifier: MIT
//
// What of made-up tables was touched, by component and by kind of feature.
#include "edgewise/bench/trace/touched_tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "edgewise/bench/trace/trace_names.hpp"
#include "edgewise/measure/cache/heat_map.hpp"
#include "edgewise/studies/single_cell.hpp"

namespace edgewise::bench {
namespace {

/// Four vertices of 24 bytes, then two edges of 16 bytes of planes and 8 of topology, padded to 32.
TableMap table_at(std::size_t offset) {
    return {{{offset, 24, 4, {{Component::vertex_coordinates, 24}}},
             {offset + 96, 32, 2, {{Component::voronoi_planes, 16}, {Component::topology, 8}}}},
            4,
            2,
            2};
}

TEST(TouchedTables, AreCountedByComponentAndFeature) {
    const std::vector<TableMap> maps = {table_at(0), table_at(1000)};
    measure::TouchedBytes touched;
    touched.touch(0, 8);          // a coordinate of the first vertex
    touched.touch(24, 24);        // the second
    touched.touch(96, 16);        // the first edge's planes
    touched.touch(96 + 24, 8);    // its padding
    touched.touch(1000 + 96, 1);  // of the second table one byte
    const measure::TouchedTables found = touched_tables(maps, touched);
    EXPECT_EQ(found.bytes, 8 + 24 + 16 + 8 + 1U);
    EXPECT_EQ(found.of_bytes, 2 * (96 + 64U));
    EXPECT_EQ(found.by_component.size(), 4U);
    EXPECT_DOUBLE_EQ(found.by_component.at("vertex_coordinates"), 32.0 / 192);
    EXPECT_DOUBLE_EQ(found.by_component.at("voronoi_planes"), 17.0 / 64);
    EXPECT_DOUBLE_EQ(found.by_component.at("topology"), 0);
    EXPECT_DOUBLE_EQ(found.by_component.at("padding"), 8.0 / 32);
    EXPECT_DOUBLE_EQ(found.vertices.value(), 2.0 / 8);
    EXPECT_DOUBLE_EQ(found.edges.value(), 2.0 / 4);
    EXPECT_FALSE(found.faces) << "no part for faces: no fraction of them";
}

/// x, y and z of ten vertices, as three arrays or as one piece: a vertex is touched where any of its is.
TEST(TouchedTables, KnowAFeatureInEachOfItsArrays) {
    const TableMap apart = {{{0, 8, 10, {{Component::vertex_coordinates, 8}}},
                             {80, 8, 10, {{Component::vertex_coordinates, 8}}},
                             {160, 8, 10, {{Component::vertex_coordinates, 8}}}},
                            10,
                            20,
                            12};
    const TableMap together = {{{0, 8, 30, {{Component::vertex_coordinates, 8}}}}, 10, 20, 12};
    measure::TouchedBytes touched;
    touched.touch(0, 8);         // x of vertex 0
    touched.touch(80 + 24, 8);   // y of 3
    touched.touch(160 + 72, 1);  // z of 9
    for (const TableMap& map : {apart, together}) {
        EXPECT_EQ(touched_features(map, touched, FeatureKind::vertex), (std::vector<std::uint32_t>{0, 3, 9}));
        EXPECT_FALSE(touched_features(map, touched, FeatureKind::face)) << "none stored";
    }
}

TEST(TouchedTables, DoNotGuessWithinBlocks) {
    const TableMap blocks = {{{0, 64, 2, {{Component::vertex_coordinates, 64}}}}, 10, 20, 12};
    EXPECT_FALSE(touched_features(blocks, measure::TouchedBytes{}, FeatureKind::vertex));
}

/// The same queries read the same vertices, however they are stored.
TEST(TouchedTables, SeeTheSameVerticesInEveryLayout) {
    std::vector<std::uint32_t> first;
    for (const char* table : {"aos_f64", "soa_f64", "hot_cold_f64", "aos_padded_f64"}) {
        const std::string names[] = {table};
        const auto type = std::find_if(table_types().begin(), table_types().end(),
                                       [&](const TableType& known) { return known.name == table; });
        if (type == table_types().end()) continue;  // this program has only some layouts
        const studies::SingleCell cell({names[0], "vclip", "tumble", "sphere386", {{"bodies", 4}}, 60, 1});
        measure::HeatMap heat(field_names().size(), step_names().size());
        static_cast<void>(cell.runner().trace(60, heat));
        const auto found =
            touched_features(cell.runner().memory_maps().front(), heat.touched(), FeatureKind::vertex);
        ASSERT_TRUE(found) << table;
        EXPECT_GT(found->size(), 10U);
        EXPECT_LT(found->size(), 386U);
        if (first.empty()) first = *found;
        EXPECT_EQ(*found, first) << table;
    }
}

}  // namespace
}  // namespace edgewise::bench
