// SPDX-License-Identifier: MIT
//
// What is particular to the layouts of engines and papers: rings longer than a block or a line, bodies that
// 16 bits do not count, faces that GJK never reads; and that climbs over blocks go where climbs over single
// neighbours go, to the bit, as wide scans go where single ones go.
#include <gtest/gtest.h>

#include <vector>

#include "cones.hpp"
#include "edgewise/algorithms/support.hpp"
#include "edgewise/layouts/bepu.hpp"
#include "edgewise/layouts/jitter2.hpp"
#include "edgewise/layouts/lean.hpp"
#include "edgewise/layouts/line_per_vertex.hpp"
#include "edgewise/layouts/ring_block.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/table/stored_body.hpp"
#include "expect_rings.hpp"

namespace edgewise {
namespace {

std::vector<Polyhedron> bodies_of_every_degree() {
    std::vector<Polyhedron> all;
    for (const int sides : {3, 7, 8, 9, 10, 12, 13, 14, 15, 16, 40})
        all.push_back(testing::double_cone(sides));
    for (const char* shape : {"cube8", "sphere38", "sphere386", "uv_sphere386"})
        all.push_back(scene::make_shape(shape).or_throw());
    return all;
}

/// In whole words of four bytes.
template <class Table>
void expect_kept(const Table& table, const Polyhedron& body) {
    testing::expect_rings(table, body);
    EXPECT_EQ(table.ledger().total() % 4, 0U) << Table::name;
}

TEST(FieldLayouts, KeepRingsOfEveryLength) {
    for (const Polyhedron& given : bodies_of_every_degree()) {
        const Polyhedron single = stored_body<lean<f32>>(given).or_throw();
        expect_kept(line_per_vertex<f64>(given, Parts::support), given);
        expect_kept(line_per_vertex<f32>(single, Parts::support), single);
        expect_kept(ring_block<f64>(given, Parts::support), given);
        expect_kept(ring_block<f32>(single, Parts::support), single);
    }
}

template <class A, class B>
void expect_same_point(const A& found, const B& expected) {
    EXPECT_EQ(found.vertex, expected.vertex);
    EXPECT_EQ(found.point, expected.point);
    EXPECT_EQ(found.along, expected.along);
}

template <class P>
void expect_same_supports(const Polyhedron& given, scene::Rng& rng) {
    using Scalar = typename P::Compute;
    const Polyhedron body = stored_body<lean<P>>(given).or_throw();
    const lean<P> plain(body, Parts::support);
    const ring_block<P> blocks(body, Parts::support);
    const line_per_vertex<P> lines(body, Parts::support);
    const bepu<P> bundles(body, Parts::support);
    for (int i = 0; i < 500; ++i) {
        Vec3d wanted = rng.on_sphere();
        if (i % 3 == 0) wanted = (wanted * 1.5).array().round();  // lattice: equal vertices
        if (i % 3 == 1) wanted = body.face_planes[rng.below(body.face_count())].normal;
        const auto direction = cast<Scalar>(wanted);
        const auto start = static_cast<Index>(rng.below(body.vertex_count()));
        const auto climbed = climb_support(plain, direction, start);
        expect_same_point(climb_support(blocks, direction, start), climbed);
        expect_same_point(climb_support(lines, direction, start), climbed);
        expect_same_point(scan_support(bundles, direction), scan_support(plain, direction));
    }
}

TEST(FieldLayouts, ClimbAndScanAsOthersDo) {
    static_assert(RingBlockTable<ring_block<f64>> && !RingBlockTable<line_per_vertex<f64>>);
    scene::Rng rng(8);
    for (const Polyhedron& body : bodies_of_every_degree()) {
        expect_same_supports<f64>(body, rng);
        expect_same_supports<f32>(body, rng);
    }
}

TEST(FieldLayouts, BepuKeepsPlanesAndFaces) {
    for (const Polyhedron& body : bodies_of_every_degree()) {
        const bepu<f64> table(body, Parts::support);
        for (Index f = 0; f < body.face_count(); ++f) {
            EXPECT_EQ(table.face_plane(f).normal, body.face_planes[f].normal);
            EXPECT_EQ(table.face_plane(f).offset, body.face_planes[f].offset);
            std::vector<Index> found, expected;
            for (const Index v : table.face_vertices(f)) found.push_back(v);
            for (const HalfEdge h : body.ring_of_face(f)) expected.push_back(body.tail(h));
            EXPECT_EQ(found, expected);
        }
    }
}

TEST(FieldLayouts, Jitter2TakesAsManyNeighboursAs16BitsCount) {
    const Polyhedron fits = scene::make_shape("sphere6146").or_throw();
    EXPECT_TRUE(stored_body<jitter2<f64>>(fits));
    expect_kept(jitter2<f64>(fits, Parts::features), fits);
    const auto refused = stored_body<jitter2<f64>>(scene::make_shape("sphere24578").or_throw());
    EXPECT_FALSE(refused);
    EXPECT_EQ(refused.error, "jitter2 takes bodies of up to 32767 edges, and this one has 73728");
}

}  // namespace
}  // namespace edgewise
