// SPDX-License-Identifier: MIT
//
// Touched parts of tables by component and by kind of feature, and reads of each feature: of made-up tables
// by hand; of real ones next to the fields that the trace names, and to the features that answers name.
#include "edgewise/bench/trace/touched_tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <numeric>

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

/// A fixed set of queries reads the same vertices in every layout.
TEST(TouchedTables, SeeTheSameVerticesInEveryLayout) {
    std::vector<std::uint32_t> first;
    for (const char* table : {"aos_f64", "soa_f64", "hot_cold_f64", "aos_padded_f64"}) {
        if (!find_table_type(table)) continue;  // this program has only some layouts
        const studies::SingleCell cell({table, "vclip", "tumble", "sphere386", {{"bodies", 4}}, 60, 1});
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

using Reads = std::vector<std::uint32_t>;

measure::TracedAccess heat_read(std::uint64_t address,
                                measure::TraceSide side = measure::TraceSide::table_a) {
    return {address, 8, measure::AccessKind::read, 0, 0, side};
}

TEST(FeatureHeat, CountsReadsOfEachFeatureOverAllTables) {
    const std::vector<TableMap> maps = {table_at(0), table_at(1000)};
    FeatureHeat heat(maps);
    for (const std::uint64_t address : {0, 8, 1000, 24, 96, 1000 + 96 + 32})
        heat.on_access(heat_read(address));
    heat.on_access(heat_read(96 + 16));                       // topology: of no feature alone
    heat.on_access(heat_read(96 + 24));                       // padding
    heat.on_access(heat_read(500));                           // between the tables
    heat.on_access(heat_read(5000));                          // behind them
    heat.on_access(heat_read(0, measure::TraceSide::scene));  // not of a table
    heat.on_query_end(true);
    EXPECT_EQ(heat.reads(FeatureKind::vertex), (Reads{3, 1, 0, 0}));
    EXPECT_EQ(heat.reads(FeatureKind::edge), (Reads{1, 1}));
    EXPECT_FALSE(heat.reads(FeatureKind::face)) << "nothing is stored of faces";
    EXPECT_EQ(heat.queries(), 1U);
}

class FieldCounts final : public measure::TraceListener {
  public:
    void on_access(const measure::TracedAccess& access) override {
        if (access.side != measure::TraceSide::scene) ++counts[access.field];
    }
    void on_query_end(bool /*counts*/) override {}
    std::array<std::uint64_t, 256> counts = {};
};

std::uint64_t sum_of(const std::optional<Reads>& reads) {
    return reads ? std::accumulate(reads->begin(), reads->end(), std::uint64_t{0}) : 0;
}

/// Every read of a field that is of features is of one of them, and no other read is.
TEST(FeatureHeat, IsTheReadsOfTheFieldsThatFeaturesHave) {
    std::uint64_t vertices = 0, edges = 0, faces = 0;
    for (const std::string table : {"aos_f64", "hot_cold_f64", "lean_f64"}) {
        if (!find_table_type(table)) continue;  // this program has only some layouts
        for (const char* algorithm : {"vclip", "gjk"}) {
            const studies::SingleCell cell({table, algorithm, "tumble", "sphere386", {{"bodies", 4}}, 60, 1});
            FeatureHeat heat(cell.runner().memory_maps());
            FieldCounts fields;
            measure::TraceFanOut both({&heat, &fields});
            static_cast<void>(cell.runner().trace(60, both));
            const auto of = [&](Field field) { return fields.counts[static_cast<std::size_t>(field)]; };
            EXPECT_EQ(sum_of(heat.reads(FeatureKind::vertex)), of(Field::vertex)) << table << algorithm;
            EXPECT_EQ(sum_of(heat.reads(FeatureKind::edge)),
                      of(Field::voronoi_plane) + of(Field::edge_direction))
                << table << algorithm;
            const auto& of_faces = heat.reads(FeatureKind::face);
            EXPECT_TRUE(!of_faces || sum_of(of_faces) == of(Field::face_plane)) << table << algorithm;
            vertices += sum_of(heat.reads(FeatureKind::vertex)),
                edges += sum_of(heat.reads(FeatureKind::edge)),
                faces += sum_of(heat.reads(FeatureKind::face));
        }
    }
    EXPECT_GT(vertices, 0U);
    EXPECT_GT(edges, 0U);
    std::cout << vertices << " reads of vertices, " << edges << " of edges, " << faces << " of faces\n";
}

/// A query reads few of 386 vertices, and those that its answer names are among them: numbers are the body's.
TEST(FeatureHeat, NumbersFeaturesAsTheBodyDoes) {
    std::size_t named = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const studies::SingleCell cell(
            {"aos_f64", "vclip", "cold", "sphere386", {{"overlapping", 0}}, 1, seed});
        FeatureHeat heat(cell.runner().memory_maps());
        static_cast<void>(cell.runner().trace(1, heat));
        const Reads& reads = heat.reads(FeatureKind::vertex).value();
        ASSERT_EQ(reads.size(), 386U);
        EXPECT_LT(std::ranges::count_if(reads, [](std::uint32_t count) { return count > 0; }), 386 / 2);
        const NamedAnswer answer = cell.runner().answer(cell.workload().queries.front());
        for (const NamedFeature* feature : {&answer.feature_a, &answer.feature_b}) {
            if (feature->kind == FeatureKind::face) continue;  // its plane was read, its corners need not be
            for (const std::uint32_t vertex : feature->vertices) {
                EXPECT_GT(reads.at(vertex), 0U) << "seed " << seed;
                ++named;
            }
        }
    }
    EXPECT_GT(named, 10U);
}

}  // namespace
}  // namespace edgewise::bench
