// SPDX-License-Identifier: MIT
//
// The checker sees every kind of damage: a good body is broken in one way at a time, and the line that names
// this damage must appear. Random damage must never pass unseen, nor make the checker read out of bounds.
#include "edgewise/geometry/check_polyhedron.hpp"

#include <cstdio>
#include <functional>
#include <limits>

#include "geometry_bodies.hpp"

namespace edgewise {
namespace {

using testing::all_violations;
using testing::box_points;
using testing::Dice;
using testing::sphere_points;

Polyhedron cube() { return *convex_hull(box_points(Vec3d(1, 1, 1))); }

struct Damage {
    const char* what;
    std::function<void(Polyhedron&)> inflict;
    const char* expected;
};

void swap_ends(PolyhedronEdge& edge) { std::swap(edge.tail, edge.head); }

std::vector<Damage> array_damages() {
    return {
        {"input index lost", [](Polyhedron& b) { b.input_index.pop_back(); }, "input_index has 7 entries"},
        {"face offset lost", [](Polyhedron& b) { b.face_offset.pop_back(); }, "face_offset has 6 entries"},
        {"vertex offset lost", [](Polyhedron& b) { b.vertex_offset.pop_back(); },
         "vertex_offset has 8 entries"},
        {"offset falls", [](Polyhedron& b) { std::swap(b.face_offset[1], b.face_offset[2]); },
         "face_offset must rise"},
        {"offset not from 0", [](Polyhedron& b) { b.vertex_offset[0] = 1; },
         "vertex_offset must rise from 0"},
        {"offset past the end", [](Polyhedron& b) { b.face_offset.back() = 25; }, "face_offset must rise"},
        {"ring out of range", [](Polyhedron& b) { b.face_ring[3] = 24; },
         "face_ring holds half-edge 24 of only 24"},
        {"half-edge twice", [](Polyhedron& b) { b.vertex_ring[0] = b.vertex_ring[1]; },
         "times in vertex_ring"},
        {"ring too short", [](Polyhedron& b) { b.face_ring.pop_back(); }, "is 0 times in face_ring"},
        {"unknown vertex", [](Polyhedron& b) { b.edges[4].head = 8; }, "edge 4 names a vertex or a face"},
        {"unknown face", [](Polyhedron& b) { b.edges[5].left = 6; }, "edge 5 names a vertex or a face"},
    };
}

std::vector<Damage> topology_damages() {
    return {
        {"a lost vertex",
         [](Polyhedron& b) {
             b.vertices.push_back(Vec3d(0, 0, 0));
             b.input_index.push_back(8);
             b.vertex_offset.push_back(b.vertex_offset.back());
         },
         "Euler: 9 vertices - 12 edges + 6 faces = 3, expected 2"},
        {"bare vertex",
         [](Polyhedron& b) {
             b.vertices.push_back(Vec3d(0, 0, 0));
             b.input_index.push_back(8);
             b.vertex_offset.push_back(b.vertex_offset.back());
         },
         "vertex 8 has 0 edges"},
        {"edge turned", [](Polyhedron& b) { swap_ends(b.edges[2]); }, "edge 2: tail must be below head"},
        {"same face twice", [](Polyhedron& b) { b.edges[2].left = b.edges[2].right; }, "on both sides"},
        {"edges swapped", [](Polyhedron& b) { std::swap(b.edges[0], b.edges[1]); },
         "edges 0 and 1 are not in the order"},
        {"sides swapped", [](Polyhedron& b) { std::swap(b.edges[7].left, b.edges[7].right); },
         "belongs to face"},
    };
}

std::vector<Damage> ring_damages() {
    return {
        {"ring shuffled", [](Polyhedron& b) { std::swap(b.face_ring[1], b.face_ring[2]); },
         "its ring breaks"},
        {"ring reversed", [](Polyhedron& b) { std::reverse(b.face_ring.begin(), b.face_ring.begin() + 4); },
         "its ring breaks"},
        {"face moved", [](Polyhedron& b) { std::swap(b.face_ring[0], b.face_ring[4]); },
         "in its ring belongs to face"},
        {"fan clockwise", [](Polyhedron& b) { std::swap(b.vertex_ring[1], b.vertex_ring[2]); },
         "counter-clockwise"},
        {"fan mixed", [](Polyhedron& b) { std::swap(b.vertex_ring[0], b.vertex_ring[3]); },
         "in its ring leaves vertex"},
        {"ring starts late",
         [](Polyhedron& b) {
             std::rotate(b.face_ring.begin(), b.face_ring.begin() + 1, b.face_ring.begin() + 4);
         },
         "face 0: its ring does not start at its smallest half-edge"},
        {"fan starts late",
         [](Polyhedron& b) {
             std::rotate(b.vertex_ring.begin(), b.vertex_ring.begin() + 1, b.vertex_ring.begin() + 3);
         },
         "vertex 0: its ring does not start at its smallest half-edge"},
        {"faces swapped",
         [](Polyhedron& b) {
             std::swap_ranges(b.face_ring.begin(), b.face_ring.begin() + 4, b.face_ring.begin() + 4);
             std::swap(b.face_planes[0], b.face_planes[1]);
             for (PolyhedronEdge& edge : b.edges) {
                 for (Index* side : {&edge.left, &edge.right}) *side = *side < 2 ? 1 - *side : *side;
             }
         },
         "faces 0 and 1 are not in the order of their first half-edges"},
    };
}

std::vector<Damage> shape_damages() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return {
        {"long normal", [](Polyhedron& b) { b.face_planes[0].normal *= 1 + 1e-12; }, "its normal has length"},
        {"zero normal", [](Polyhedron& b) { b.face_planes[0].normal *= 0; }, "its normal has length 0"},
        {"normal not a number", [=](Polyhedron& b) { b.face_planes[1].normal.x() = nan; },
         "its normal has length"},
        {"offset not a number", [=](Polyhedron& b) { b.face_planes[1].offset = nan; }, "is not planar"},
        {"plane too far out", [](Polyhedron& b) { b.face_planes[2].offset -= 1e-10; }, "is not planar"},
        {"plane too far in", [](Polyhedron& b) { b.face_planes[2].offset += 1e-10; }, "not convex"},
        {"inward plane",
         [](Polyhedron& b) {
             b.face_planes[3].normal *= -1;
             b.face_planes[3].offset *= -1;
         },
         "not convex"},
        {"inward plane, winding",
         [](Polyhedron& b) {
             b.face_planes[3].normal *= -1;
             b.face_planes[3].offset *= -1;
         },
         "not a convex polygon run counter-clockwise"},
        {"vertex pulled in", [](Polyhedron& b) { b.vertices[6] *= 1 - 1e-9; }, "is not planar"},
        {"vertex pulled out", [](Polyhedron& b) { b.vertices[6] *= 1 + 1e-9; }, "not convex"},
        {"edge without length", [](Polyhedron& b) { b.vertices[1] = b.vertices[0]; }, "not a convex polygon"},
        {"vertex not a number", [=](Polyhedron& b) { b.vertices[2].y() = nan; }, "a vertex is not finite"},
    };
}

void expect_seen(const std::vector<Damage>& damages) {
    for (const Damage& damage : damages) {
        Polyhedron body = cube();
        ASSERT_EQ(all_violations(body), "");
        damage.inflict(body);
        const std::string seen = all_violations(body);
        EXPECT_NE(seen.find(damage.expected), std::string::npos) << damage.what << ", reported:\n" << seen;
    }
}

TEST(CheckPolyhedron, SeesBrokenArrays) { expect_seen(array_damages()); }

TEST(CheckPolyhedron, SeesBrokenTopology) { expect_seen(topology_damages()); }

TEST(CheckPolyhedron, SeesBrokenRings) { expect_seen(ring_damages()); }

TEST(CheckPolyhedron, SeesBrokenShape) { expect_seen(shape_damages()); }

TEST(CheckPolyhedron, RefusesTheEmptyBody) { EXPECT_NE(all_violations(Polyhedron{}), ""); }

TEST(CheckPolyhedron, RandomDamageToTheIndicesIsAlwaysSeen) {
    Dice dice(31);
    const Polyhedron sound = *convex_hull(sphere_points(dice, 40, Vec3d(1, 1, 1)));
    ASSERT_EQ(all_violations(sound), "");
    int inflicted = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        Polyhedron body = sound;
        PolyhedronEdge& edge = body.edges[dice.below(body.edge_count())];
        std::vector<Index>* const rows[] = {&body.face_offset, &body.face_ring, &body.vertex_offset,
                                            &body.vertex_ring};
        std::vector<Index>& row = *rows[dice.below(4)];
        Index* const places[] = {&edge.tail, &edge.head, &edge.left, &edge.right,
                                 &row[dice.below(row.size())]};
        Index& place = *places[dice.below(5)];
        const auto value = static_cast<Index>(dice.below(trial % 3 == 0 ? 0xffffffffu : 150));
        if (value == place) continue;
        place = value;
        ++inflicted;
        EXPECT_NE(all_violations(body), "") << "trial " << trial;
    }
    std::printf("%d damaged bodies, all seen\n", inflicted);
    EXPECT_GT(inflicted, 2500);
}

}  // namespace
}  // namespace edgewise
