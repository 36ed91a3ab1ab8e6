// SPDX-License-Identifier: MIT
//
// Compares vertices, neighbours, edges and rings of a table with the canonical body. Handles are the table's
// own, so edges are compared as half-edges: start, end and left face. The order matters: the first of equal
// candidates wins, so layouts with different orders would give different answers.
#include <gtest/gtest.h>

#include <cstdint>
#include <set>

#include "edgewise/algorithms/vclip/feature_pair.hpp"
#include "edgewise/table/feature_handle.hpp"
#include "stored_bodies.hpp"
#include "tables_under_test.hpp"

namespace edgewise {
namespace {

template <class Type>
class Topology : public ::testing::Test {};
TYPED_TEST_SUITE(Topology, TableTypes);

template <class T>
void expect_same_support(const T& table, const Polyhedron& body) {
    ASSERT_EQ(table.vertex_count(), body.vertex_count());
    EXPECT_EQ(table.index_of(table.first_vertex()), 0U);
    Index index = 0;
    for (const auto v : table.all_vertices()) {
        ASSERT_LT(index, body.vertex_count());
        ASSERT_EQ(table.index_of(v), index);
        EXPECT_EQ(Vec3d(table.vertex(v).template cast<double>()), body.vertices[index]) << "vertex " << index;
        if constexpr (ClimbingTable<T>) {
            std::vector<Index> around, expected;
            for (const auto neighbour : table.neighbours(v)) around.push_back(table.index_of(neighbour));
            for (const HalfEdge h : body.ring_of_vertex(index)) expected.push_back(body.head(h));
            EXPECT_EQ(around, expected) << "neighbours of vertex " << index;
        }
        ++index;
    }
    EXPECT_EQ(index, body.vertex_count());
}

TYPED_TEST(Topology, VerticesAreExactAndNeighboursInOrder) {
    using T = typename TypeParam::Table;
    for (const auto& [name, body] : test_bodies<T>()) {
        SCOPED_TRACE(name);
        expect_same_support(T(body, Parts::support), body);
        expect_same_support(T(body, Parts::features), body);
    }
}

/// Each number of a feature gives its handle, numbers differ, and other numbers give no handle.
template <class T>
void expect_named_features(const T& table) {
    std::set<std::uint32_t> edges, faces;
    for (const auto v : table.all_vertices()) {
        for (const auto [edge, flipped] : table.ring_of_vertex(v)) {
            const std::uint32_t name = table.edge_name(edge);
            edges.insert(name);
            EXPECT_LT(name, 1U << feature_name_bits);
            ASSERT_TRUE(table.edge_named(name).has_value());
            EXPECT_TRUE(*table.edge_named(name) == edge);
        }
    }
    for (const auto face : table.all_faces()) {
        const std::uint32_t name = table.face_name(face);
        EXPECT_TRUE(faces.insert(name).second);
        ASSERT_TRUE(table.face_named(name).has_value());
        EXPECT_TRUE(*table.face_named(name) == face);
    }
    const std::uint32_t beyond = (1U << feature_name_bits) - 1;
    EXPECT_FALSE(table.edge_named(beyond).has_value());
    EXPECT_FALSE(table.face_named(beyond).has_value());
    EXPECT_EQ(edges.empty(), table.vertex_count() < 2);
}

TYPED_TEST(Topology, FeaturesHaveNumbers) {
    using T = typename TypeParam::Table;
    if constexpr (NamesFeatures<T>) {
        for (const auto& [name, body] : test_bodies<T>()) {
            SCOPED_TRACE(name);
            expect_named_features(T(body, Parts::features));
        }
        EXPECT_EQ(sizeof(FeaturePair<T, T>), 8U);
    } else {
        constexpr bool counts = requires { requires T::counts_vertices; };
        EXPECT_FALSE(counts && FeatureTable<T>) << "a table that counts its vertices can count its features";
    }
}

/// Checks that the edge is half-edge h of the body, reversed if `flipped`.
template <class T>
void expect_half_edge(const T& table, typename T::Edge e, bool flipped, const Polyhedron& body, HalfEdge h) {
    EXPECT_EQ(table.index_of(flipped ? table.head(e) : table.tail(e)), body.tail(h));
    EXPECT_EQ(table.index_of(flipped ? table.tail(e) : table.head(e)), body.head(h));
    const auto left = flipped ? table.right(e) : table.left(e);
    const auto right = flipped ? table.left(e) : table.right(e);
    EXPECT_EQ(body_face(table, left, body), body.face(h));
    EXPECT_EQ(body_face(table, right, body), body.face(h ^ 1));
}

template <class T>
void expect_same_rings(const T& table, const Polyhedron& body) {
    for (const auto v : table.all_vertices()) {
        const auto expected = body.ring_of_vertex(table.index_of(v));
        std::size_t at = 0;
        for (const auto [edge, flipped] : table.ring_of_vertex(v)) {
            ASSERT_LT(at, expected.size());
            expect_half_edge(table, edge, flipped, body, expected[at++]);
        }
        EXPECT_EQ(at, expected.size());
    }
    std::set<Index> faces;
    for (const auto f : table.all_faces()) {
        const Index face = body_face(table, f, body);
        ASSERT_LT(face, body.face_count());
        EXPECT_TRUE(faces.insert(face).second) << "face " << face << " twice";
        const auto expected = body.ring_of_face(face);
        std::size_t at = 0;
        for (const auto [edge, flipped] : table.ring_of_face(f)) {
            ASSERT_LT(at, expected.size());
            expect_half_edge(table, edge, flipped, body, expected[at++]);
            EXPECT_EQ(flipped ? table.right(edge) : table.left(edge), f);
        }
        EXPECT_EQ(at, expected.size());
    }
    EXPECT_EQ(faces.size(), body.face_count());
}

TYPED_TEST(Topology, RingsRunAsInTheBody) {
    for_each_feature_table<typename TypeParam::Table>(
        [](const auto& table, const Polyhedron& body, const std::string& /*name*/) {
            expect_same_rings(table, body);
        });
}

/// One edge, one handle: V-Clip distinguishes features by their handles.
TYPED_TEST(Topology, BothFacesAndBothEndsNameAnEdgeAlike) {
    for_each_feature_table<typename TypeParam::Table>(
        [](const auto& table, const Polyhedron& body, const std::string& /*name*/) {
            for (const auto v : table.all_vertices()) {
                for (const auto [edge, flipped] : table.ring_of_vertex(v)) {
                    const auto other = flipped ? table.tail(edge) : table.head(edge);
                    std::size_t met = 0;
                    for (const auto r : table.ring_of_vertex(other))
                        met += r.edge == edge && r.flipped != flipped;
                    for (const auto r : table.ring_of_face(table.left(edge)))
                        met += r.edge == edge && !r.flipped;
                    for (const auto r : table.ring_of_face(table.right(edge)))
                        met += r.edge == edge && r.flipped;
                    EXPECT_EQ(met, 3U);
                }
            }
            std::size_t faces = 0;
            for ([[maybe_unused]] const auto f : table.all_faces()) ++faces;
            EXPECT_EQ(faces, body.face_count());
        });
}

}  // namespace
}  // namespace edgewise
