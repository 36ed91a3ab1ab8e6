// SPDX-License-Identifier: MIT
#include "edgewise/table/pieces.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace edgewise {
namespace {

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
