// SPDX-License-Identifier: MIT
//
// Loaders by themselves; that no answer depends on them is a contract test of every table type.
#include "edgewise/table/loader.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "edgewise/geometry/hull.hpp"
#include "edgewise/layout_parts/rings.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/table/pieces.hpp"

namespace edgewise {
namespace {

struct Read {
    const void* address;
    std::size_t bytes;
    Field field;
    bool operator==(const Read&) const = default;
};

struct Recorder {
    std::vector<Read> reads;
    void read(const void* address, std::size_t bytes, Field field) {
        reads.push_back({address, bytes, field});
    }
};

TEST(Loader, DirectIsTheLocationItself) {
    const double value = 3;
    EXPECT_EQ(&Direct::load(value, Field::vertex), &value);
}

TEST(Loader, TracedIsTheLocationItselfAndSaysSo) {
    Recorder recorder;
    const Traced<Recorder> loader{&recorder};
    const double number = 3;
    const Plane<float> plane{Vec3<float>(1, 2, 3), 4};
    EXPECT_EQ(&loader.load(number, Field::vertex), &number);
    EXPECT_EQ(&loader.load(plane, Field::face_plane), &plane);
    const std::vector<Read> expected = {{&number, 8, Field::vertex}, {&plane, 16, Field::face_plane}};
    EXPECT_EQ(recorder.reads, expected);
}

TEST(Loader, RingsReportTheirOffsetsAndEveryEntry) {
    const auto body = scene::make_shape("cube8");
    ASSERT_TRUE(body) << body.error;
    Rings rings;
    const BodyFacts facts(*body, Parts::features, 0);
    const Block block([&](BlockPlan& plan) { rings.place(plan, facts); });
    rings.fill(*body, Parts::features);
    Recorder recorder;
    const Traced<Recorder> loader{&recorder};
    std::vector<Index> direct, traced;
    for (const Index v : rings.neighbours(Direct{}, 5)) direct.push_back(v);
    for (const Index v : rings.neighbours(loader, 5)) traced.push_back(v);
    EXPECT_EQ(direct, traced);
    ASSERT_EQ(recorder.reads.size(), 5U);  // two offsets, three neighbours
    EXPECT_EQ(recorder.reads[0], (Read{rings.vertex_offset + 5, 4, Field::vertex_ring}));
    EXPECT_EQ(recorder.reads[1], (Read{rings.vertex_offset + 6, 4, Field::vertex_ring}));
    for (std::uint32_t i = 0; i < 3; ++i) {
        const Index at = rings.vertex_offset[5] + i;
        EXPECT_EQ(recorder.reads[2 + i], (Read{rings.neighbour + at, 4, Field::neighbour}));
    }
}

TEST(Ledger, TotalIsEveryComponentOnce) {
    Ledger ledger;
    std::size_t expected = 0;
    for (std::size_t i = 0; i < component_names.size(); ++i) {
        ledger[static_cast<Component>(i)] = std::size_t{1} << (8 * i);  // all sums differ
        expected += std::size_t{1} << (8 * i);
        EXPECT_EQ(ledger.total(), expected);
    }
}

TEST(Ledger, EveryComponentHasANameOfItsOwn) {
    const std::set<std::string_view> names(component_names.begin(), component_names.end());
    EXPECT_EQ(names.size(), component_names.size());
    EXPECT_EQ(component_names[static_cast<std::size_t>(Component::voronoi_planes)], "voronoi_planes");
    EXPECT_EQ(component_names[static_cast<std::size_t>(Component::padding)], "padding");
    EXPECT_EQ(static_cast<std::size_t>(Component::padding) + 1, component_names.size());
}

TEST(Ledger, PaperSubtotalIsPlanesGeometryAndCoordinates) {
    Ledger ledger;
    ledger[Component::edge_geometry] = 32;
    ledger[Component::vertex_coordinates] = 8;
    ledger[Component::face_planes] = 1000;
    ledger[Component::topology] = 1000;
    ledger[Component::padding] = 1000;
    EXPECT_EQ(ledger.paper_subtotal(), 0U);  // without Voronoi planes there is nothing to compare
    ledger[Component::voronoi_planes] = 128;
    EXPECT_EQ(ledger.paper_subtotal(), 168U);
}

}  // namespace
}  // namespace edgewise
