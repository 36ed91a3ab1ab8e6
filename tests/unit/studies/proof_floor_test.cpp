// SPDX-License-Identifier: MIT
//
// The floor of cubes, counted by hand, and that the vertices it reads prove what they are read for.
#include "edgewise/studies/effort/effort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise::studies {
namespace {

const Polyhedron& cube() {
    static const Polyhedron body = scene::make_shape("cube8").or_throw();
    return body;
}

/// Two cubes, the second `along` x.
scene::Workload cubes(double along) {
    scene::Workload workload;
    workload.bodies = {cube()};
    scene::Query query{0, 0, 0, {}, {}};
    query.pose_b.translation = Vec3d(along, 0, 0);
    workload.queries = {query};
    return workload;
}

ProofFloor floor_of(double along, const ProofReads& reads) {
    const scene::Workload workload = cubes(along);
    const auto floor = proof_floor(workload, workload.bodies, reads);
    EXPECT_TRUE(floor.value) << floor.reason;
    return *floor.value;
}

/// A corner and its three neighbours on either cube: 96 bytes each in double, 48 in single.
TEST(ProofFloor, OfTwoCubesIsCountedByHand) {
    const ProofFloor in_double = floor_of(3, {true, 24}), in_single = floor_of(3, {true, 12});
    EXPECT_EQ(in_double.vertices, 8);
    EXPECT_EQ(in_double.flops, 8 * 5 + 15 + 7);
    EXPECT_EQ(in_double.lines, 4);
    EXPECT_EQ(in_single.flops, in_double.flops);
    EXPECT_EQ(in_single.lines, 2);
}

TEST(ProofFloor, OfTablesWithoutNeighboursReadsAllVertices) {
    const ProofFloor floor = floor_of(3, {false, 24});
    EXPECT_EQ(floor.vertices, 16);
    EXPECT_EQ(floor.flops, 16 * 5 + 15 + 7);
    EXPECT_EQ(floor.lines, 6);
}

/// Two vertices of one body and three of the other fill 48 and 72 bytes.
TEST(ProofFloor, OfContactIsFiveVertices) {
    const ProofFloor floor = floor_of(0.5, {true, 24});
    EXPECT_EQ(floor.vertices, 5);
    EXPECT_EQ(floor.flops, 42);
    EXPECT_EQ(floor.lines, 3);
    EXPECT_EQ(floor_of(0.5, {true, 12}).lines, 2);
}

TEST(ProofFloor, NeedsAQuery) {
    scene::Workload none = cubes(3);
    none.queries.clear();
    EXPECT_FALSE(proof_floor(none, none.bodies, {}).value);
}

/// Brute force: a vertex no lower than its neighbours is the highest of all, and the floor reads it and them;
/// along a face or an edge the one with the fewest.
TEST(ProofFloor, ReadsAsManyVerticesAsTheHighestHasNeighboursAndItself) {
    scene::Rng rng(7);
    std::size_t directions = 0, least = 100, most = 0;
    for (const char* name : {"tetra4", "cube8", "sphere38", "sphere386"}) {
        const Polyhedron body = scene::make_shape(name).or_throw();
        for (int i = 0; i < 200; ++i) {
            const Vec3d direction(rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1));
            Index top = 0;
            for (Index v = 0; v < body.vertex_count(); ++v)
                if (dot(body.vertices[v], direction) > dot(body.vertices[top], direction)) top = v;
            const std::size_t read = proof_vertices(body, direction, true);
            EXPECT_EQ(read, 1 + body.ring_of_vertex(top).size());
            EXPECT_EQ(proof_vertices(body, direction, false), body.vertex_count());
            least = std::min(least, read);
            most = std::max(most, read);
            ++directions;
        }
    }
    EXPECT_EQ(least, 4U);
    EXPECT_GT(most, 6U);
    std::printf("proof floor: %zu directions, %zu to %zu vertices\n", directions, least, most);
    EXPECT_EQ(proof_vertices(cube(), Vec3d(1, 0, 0), true), 4U) << "four corners are level";
}

}  // namespace
}  // namespace edgewise::studies
